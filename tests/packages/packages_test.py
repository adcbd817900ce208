#!/usr/bin/python3
"""Packages of ./axial package and Debian: manifests, and programs built from what they name. usage: packages_test.py"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import xml.etree.ElementTree as xml

import yaml

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
STUBS = HERE / "stubs"
ARM = ["arm-none-eabi-g++", "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]
CATEGORIES = ("Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing", "Data Storage", "Data Processing", "Other")


def run(*command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


class Package(unittest.TestCase):
    name = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.scratch = pathlib.Path(folder.name)
        self.package = self.scratch / "package"
        if self.name is not None:
            run(ROOT / "axial", "package", self.name, "-o", self.package)
            self.assertTrue((self.package / "LICENSE").exists() or self.name in ("vcpkg", "all"))
            for file in self.package.rglob("*"):
                if file.is_file() and self.name != "all" and file.suffix not in (".hpp", ".h", ".in"):
                    self.assertNotRegex(file.read_text(encoding="utf-8"), r"@[A-Z_]+@", file)

    def compile(self, compiler, folders, *flags, source=HERE / "program.cpp"):
        if shutil.which(compiler[0]) is None:
            self.skipTest(f"no {compiler[0]}")
        run(*compiler, *flags, *(f"-I{folder}" for folder in folders), "-c", source, "-o", self.scratch / "program.o")

    def build_and_run(self, folders, *flags):
        run("g++", *flags, *(f"-I{folder}" for folder in folders), HERE / "program.cpp", "-o", self.scratch / "program")
        run(self.scratch / "program")


    def find_by_cmake(self, prefix):
        project = self.scratch / "project"
        project.mkdir()
        (project / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.20)\nproject(p CXX)\nfind_package(axial 0.1 CONFIG REQUIRED)\n"
                                                f"add_executable(p {HERE}/program.cpp)\ntarget_link_libraries(p axial::axial)\n", encoding="utf-8")
        run("cmake", "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
        run("cmake", "--build", project / "build")
        run(project / "build/p")


class Arduino(Package):
    name = "arduino"

    def test_properties_are_those_of_a_library(self):
        lines = (self.package / "library.properties").read_text(encoding="utf-8").splitlines()
        found = dict(line.split("=", 1) for line in lines)
        self.assertLessEqual({"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures"}, set(found))
        self.assertIn(found["category"], CATEGORIES)
        self.assertFalse({"*", "avr", "megaavr"} & set(found["architectures"].split(",")), "AVR has no C++ library")
        self.assertTrue((self.package / "src" / found["includes"]).exists())

    def test_sketches_compile_behind_arduinos_macros(self):
        for sketch in sorted(self.package.glob("examples/*/*.ino")):
            self.assertEqual(sketch.stem, sketch.parent.name)
            source = self.scratch / "sketch.cpp"
            source.write_text(f'#include <Arduino.h>\n#include "{sketch}"\n', encoding="utf-8")
            for optimise in ("-Os", "-Og"):
                self.compile(ARM, [STUBS, self.package / "src"], "-std=gnu++17", optimise, "-Wall", "-Werror", "-fno-exceptions", "-fno-rtti",
                             "-fno-threadsafe-statics", "-fno-use-cxa-atexit", source=source)


class PlatformIo(Package):
    name = "platformio"

    def test_library_builds_with_its_flags(self):
        found = json.loads((self.package / "library.json").read_text(encoding="utf-8"))
        self.assertLessEqual({"name", "version", "description", "frameworks", "platforms", "headers", "build"}, set(found))
        include = self.package / found["build"]["includeDir"]
        self.assertTrue((include / found["headers"]).exists())
        self.compile(ARM, [include], *found["build"]["flags"], "-Os", "-Wall", "-Werror", "-fno-exceptions", "-fno-rtti")
        self.build_and_run([include], *found["build"]["flags"])


class EspIdf(Package):
    name = "esp_idf"

    def test_component_builds_with_esp_idfs_flags(self):
        found = yaml.safe_load((self.package / "idf_component.yml").read_text(encoding="utf-8"))
        self.assertRegex(found["version"], r"^\d+\.\d+\.\d+$")
        self.assertTrue(all(list(self.package.glob(pattern)) for pattern in found["files"]["include"]))
        said = run("cmake", f"-DCOMPONENT={self.package}", "-P", STUBS / "esp_idf.cmake")
        folders = [line.split("include ", 1)[1] for line in said.splitlines() if "include " in line]
        self.assertIn("cxx_std_17", said)
        self.compile(ARM, folders, "-std=gnu++2b", "-Og", "-Wall", "-Wextra", "-Werror=all", "-Wno-unused-parameter", "-fno-exceptions", "-fno-rtti",
                     "-ffunction-sections", "-fdata-sections", "-ffreestanding")


class Zephyr(Package):
    name = "zephyr"

    def test_module_names_files_that_are_there(self):
        found = yaml.safe_load((self.package / "zephyr/module.yml").read_text(encoding="utf-8"))
        self.assertEqual(found["name"], "axial")
        module = self.package / found["build"]["cmake"]
        self.assertTrue((self.package / found["build"]["kconfig"]).is_file())
        said = run("cmake", f"-DMODULE={module}", "-P", STUBS / "zephyr.cmake")
        folders = [line.split("include ", 1)[1] for line in said.splitlines() if "include " in line]
        self.compile(ARM, folders, "-std=c++17", "-Os", "-Wall", "-Werror", "-Wdouble-promotion", "-fno-exceptions", "-fno-rtti", "-ffreestanding", "-fno-common")

    def test_kconfig_is_read(self):
        try:
            import kconfiglib
        except ImportError:
            self.skipTest("no kconfiglib")
        top = self.scratch / "Kconfig"
        top.write_text(f'config CPP\n\tbool\n\tdefault y\nconfig STD_CPP17\n\tbool\n\tdefault y\nsource "{self.package}/zephyr/Kconfig"\n', encoding="utf-8")
        self.assertEqual(kconfiglib.Kconfig(str(top), warn_to_stderr=False).syms["AXIAL"].type, kconfiglib.BOOL)


class Cmsis(Package):
    name = "cmsis"

    def test_pack_describes_files_that_are_there(self):
        pack = xml.parse(self.package / "axial.pdsc").getroot()
        self.assertEqual([pack.tag, pack.find("name").text], ["package", "axial"])
        order = [child.tag for child in pack]
        self.assertEqual(order, ["vendor", "name", "description", "url", "license", "releases", "conditions", "components"])
        conditions = {condition.get("id") for condition in pack.iter("condition")}
        folders = []
        for component in pack.iter("component"):
            self.assertIn(component.get("condition"), conditions)
            for file in component.iter("file"):
                self.assertTrue((self.package / file.get("name")).exists(), file.get("name"))
                folders += [self.package / file.get("name")] if file.get("category") == "include" else []
        self.assertTrue((self.package / pack.find("license").text).exists())
        self.compile(ARM, folders, "-std=c++17", "-O1", "-Wall", "-Werror", "-fno-exceptions", "-fno-rtti")


class Vcpkg(Package):
    name = "vcpkg"

    def test_port_installs_a_package_that_is_found(self):
        port, packages = self.package / "ports/axial", self.scratch / "packages"
        found = json.loads((port / "vcpkg.json").read_text(encoding="utf-8"))
        self.assertLessEqual({"name", "version", "description"}, set(found))
        run("cmake", f"-DPORT={port}", f"-DPACKAGES={packages}", "-P", STUBS / "vcpkg.cmake")
        self.assertEqual(sorted(path.name for path in (packages / "share/axial").iterdir()), ["LICENSE"])
        self.find_by_cmake(packages)


class Conan(Package):
    name = "conan"

    def test_recipe_packages_the_headers(self):
        script = (f"import sys; sys.path[:0] = [{str(STUBS)!r}, {str(self.package)!r}]; import conanfile; "
                  f"r = conanfile.Axial({str(self.package)!r}, {str(self.scratch / 'made')!r}); r.validate(); r.package(); r.package_info(); "
                  "print(*r.cpp_info.includedirs)")
        folders = [self.scratch / "made" / name for name in run(sys.executable, "-B", "-c", script).split()]
        self.assertTrue((self.scratch / "made/licenses/LICENSE").exists())
        self.build_and_run(folders, "-std=c++17")


class Debian(Package):
    name = "all"

    def setUp(self):
        if shutil.which("dpkg-deb") is None:
            self.skipTest("no dpkg")
        super().setUp()
        (self.deb,) = self.package.glob("libaxial-dev_*_all.deb")

    def dpkg(self, *arguments):
        run("dpkg", f"--root={self.scratch / 'root'}", "--log=/dev/null", "--force-not-root", "--force-bad-path", *arguments)

    def test_package_installs_is_found_and_leaves_nothing(self):
        root = self.scratch / "root"
        for folder in ("info", "updates"):
            (root / "var/lib/dpkg" / folder).mkdir(parents=True)
        for file in ("status", "available"):
            (root / "var/lib/dpkg" / file).touch()
        self.dpkg("--install", self.deb)
        self.assertIn("Architecture: all", run("dpkg-deb", "-f", self.deb))
        self.build_and_run([root / "usr/include"], "-std=c++17")
        self.find_by_cmake(root / "usr")
        self.assertEqual(run("pkg-config", "--modversion", "axial", env={**os.environ, "PKG_CONFIG_PATH": str(root / "usr/share/pkgconfig")}).strip(),
                         re.search(r'AXIAL_VERSION "(.+)"', (ROOT / "firmware/include/axial/version.h").read_text(encoding="utf-8"))[1])
        self.dpkg("--purge", "libaxial-dev")
        self.assertFalse((root / "usr").exists())

    def test_packages_are_the_same_to_the_byte(self):
        again = self.scratch / "again"
        run("bash", "-c", 'umask 077; exec "$0" package all -o "$1"', ROOT / "axial", again)
        sums = (self.package / "SHA256SUMS").read_text(encoding="utf-8")
        self.assertEqual((again / "SHA256SUMS").read_text(encoding="utf-8"), sums)
        self.assertEqual(len(sums.splitlines()), len(list(self.package.iterdir())) - 1)

    def test_archives_hold_what_the_folders_do(self):
        (archive,) = self.package.glob("axial-*-platformio.tar.gz")
        with tarfile.open(archive) as packed:
            names = {name.partition("/")[2] for name in packed.getnames()}
        folder = self.scratch / "folder"
        run(ROOT / "axial", "package", "platformio", "-o", folder)
        self.assertEqual(names, {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()})


class Refusals(Package):
    def test_a_folder_that_is_there_is_kept(self):
        (self.scratch / "mine").write_text("kept", encoding="utf-8")
        done = subprocess.run([ROOT / "axial", "package", "arduino", "-o", self.scratch], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("not an empty folder", done.stderr)


if __name__ == "__main__":
    unittest.main()
