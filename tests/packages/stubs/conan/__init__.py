"""Conan's base class, as much of it as a recipe of headers uses."""


class Properties:
    def __init__(self):
        self.includedirs, self.properties = ["include"], {}

    def set_property(self, name, value):
        self.properties[name] = value


class ConanFile:
    def __init__(self, source, package):
        self.source_folder, self.package_folder, self.cpp_info = source, package, Properties()
