#!/usr/bin/python3
"""Writes the library as a package of an embedded ecosystem: its manifests, the headers, and the licence where there is one.

usage: ./axial package [--help] NAME -o FOLDER
"""
import argparse
import pathlib
import re
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LICENCES = ("LICENSE", "LICENSE.md", "LICENSE.txt", "COPYING")
NO_LICENCE = ("LICENSE", "No licence has been chosen yet: nothing grants a right to use, copy or distribute this package.\n")
HEADERS = (".hpp", ".h")
# Where a package has the headers, <axial/...> below it; of those built by CMake the whole sources.
FOLDERS = {"arduino": "src", "platformio": "include", "esp_idf": "include", "zephyr": "include", "cmsis": "include", "conan": "include",
           "vcpkg": "ports/axial/source"}
SOURCES = ("CMakeLists.txt", "cmake/AxialInstall.cmake", "cmake/axial.pc.in", "firmware/include/axial", "robots")


def project():
    """{name: value} that manifests name."""
    header = (ROOT / "firmware/include/axial/version.h").read_text(encoding="utf-8")
    build = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return {"VERSION": re.search(r'define AXIAL_VERSION "([\d.]+)"', header)[1], "DESCRIPTION": re.search(r'DESCRIPTION "([^"]+)"', build)[1]}


def licence():
    """(file name, text)."""
    found = next((ROOT / name for name in LICENCES if (ROOT / name).is_file()), None)
    return (found.name, found.read_text(encoding="utf-8")) if found else NO_LICENCE


def copy_tree(source, target):
    if source.is_file():
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)
        return
    for file in sorted(source.rglob("*")):
        if file.suffix in HEADERS:
            copy_tree(file, target / file.relative_to(source))


def write_manifests(name, folder, words):
    for file in sorted((HERE / name).rglob("*")):
        if file.is_file():
            text = file.read_text(encoding="utf-8")
            for word, value in words.items():
                text = text.replace(f"@{word}@", value)
            target = folder / file.relative_to(HERE / name)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")


def write(name, folder):
    licence_file, licence_text = licence()
    write_manifests(name, folder, {**project(), "LICENCE_FILE": licence_file})
    headers = folder / FOLDERS[name]
    if name == "vcpkg":
        for source in SOURCES:
            copy_tree(ROOT / source, headers / source)
        (headers / licence_file).write_text(licence_text, encoding="utf-8")
    else:
        copy_tree(ROOT / "firmware/include/axial", headers / "axial")
        (folder / licence_file).write_text(licence_text, encoding="utf-8")


def main(arguments):
    parser = argparse.ArgumentParser(prog="./axial package", description=__doc__.split("\n")[0], allow_abbrev=False)
    parser.add_argument("name", choices=sorted(FOLDERS))
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, metavar="FOLDER", help="a folder that is not there yet, or empty")
    options = parser.parse_args(arguments)
    if options.output.exists() and (not options.output.is_dir() or any(options.output.iterdir())):
        parser.error(f"{options.output} is there already and not an empty folder")
    write(options.name, options.output)
    print(f"written: {options.output}")


if __name__ == "__main__":
    main(sys.argv[1:])
