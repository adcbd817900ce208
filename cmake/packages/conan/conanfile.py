"""conan create . : headers alone, one package for all processors."""
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy


class Axial(ConanFile):
    name = "axial"
    version = "@VERSION@"
    description = "@DESCRIPTION@"
    package_type = "header-library"
    settings = "compiler"
    exports_sources = "include/*", "@LICENCE_FILE@"
    no_copy_source = True

    def validate(self):
        check_min_cppstd(self, 17)

    def package_id(self):
        self.info.clear()

    def package(self):
        copy(self, "*", os.path.join(self.source_folder, "include"), os.path.join(self.package_folder, "include"))
        copy(self, "@LICENCE_FILE@", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "axial")
        self.cpp_info.set_property("cmake_target_name", "axial::axial")
