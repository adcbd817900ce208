#!/usr/bin/python3
"""Writes the library as a package of an embedded ecosystem: its manifests, the headers, and the licence where there is one; or all
packages of a version as files, the same to the byte wherever they are made.

usage: ./axial package [--help] NAME -o FOLDER
"""
import argparse
import gzip
import hashlib
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LICENCES = ("LICENSE", "LICENSE.md", "LICENSE.txt", "COPYING")
NO_LICENCE = ("LICENSE", "No licence has been chosen yet: nothing grants a right to use, copy or distribute this package.\n")
HEADERS = (".hpp", ".h")
# Where a package has the headers, <axial/...> below it; of those built by CMake the whole sources.
FOLDERS = {"arduino": "src", "platformio": "include", "esp_idf": "include", "zephyr": "include", "cmsis": "include", "conan": "include",
           "vcpkg": "ports/axial/source"}
NAMES = (*sorted(FOLDERS), "debian")
ALL = "all"
ZIPPED = {"arduino": "zip", "cmsis": "pack"}  # the others are .tar.gz, Debian's a .deb
WRITTEN_AT = 315532800  # seconds: 1980-01-01, before which zip knows no time; what files are dated by
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


def write_debian(folder):
    """What dpkg-deb packs: the installation, below usr/, and DEBIAN/control."""
    with tempfile.TemporaryDirectory() as build:
        run("cmake", "-S", ROOT, "-B", build, "-DAXIAL_OWN_BUILD=OFF", "-DCMAKE_INSTALL_PREFIX=/usr")
        run("cmake", "--install", build, "--prefix", folder / "usr")
    copyright_file = folder / "usr/share/doc/libaxial-dev/copyright"
    copyright_file.parent.mkdir(parents=True)
    copyright_file.write_text(licence()[1], encoding="utf-8")


def run(*command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        raise SystemExit(f"axial: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")


def write(name, folder):
    licence_file, licence_text = licence()
    write_manifests(name, folder, {**project(), "LICENCE_FILE": licence_file})
    if name == "debian":
        write_debian(folder)
        return
    headers = folder / FOLDERS[name]
    if name == "vcpkg":
        for source in SOURCES:
            copy_tree(ROOT / source, headers / source)
        (headers / licence_file).write_text(licence_text, encoding="utf-8")
    else:
        copy_tree(ROOT / "firmware/include/axial", headers / "axial")
        (folder / licence_file).write_text(licence_text, encoding="utf-8")


def files_of(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file())


def zipped(folder, file):
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in files_of(folder):
            entry = zipfile.ZipInfo(str(path.relative_to(folder.parent if file.suffix == ".zip" else folder)))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o100644 << 16
            archive.writestr(entry, path.read_bytes())


def tarred(folder, file):
    raw = io.BytesIO()
    with tarfile.open(fileobj=raw, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for path in files_of(folder):
            entry = tarfile.TarInfo(str(path.relative_to(folder.parent)))
            entry.size, entry.mtime, entry.mode = path.stat().st_size, WRITTEN_AT, 0o644
            archive.addfile(entry, io.BytesIO(path.read_bytes()))
    file.write_bytes(gzip.compress(raw.getvalue(), mtime=0))


def built_by_dpkg(folder, file):
    for path in (folder, *folder.rglob("*")):
        path.chmod(0o755 if path.is_dir() else 0o644)
        os.utime(path, (WRITTEN_AT, WRITTEN_AT))
    run("dpkg-deb", "--root-owner-group", "-Zxz", "--build", folder, file, env={**os.environ, "SOURCE_DATE_EPOCH": str(WRITTEN_AT)})


def write_all(target):
    """Every package as a file, the one header, and their checksums."""
    version = project()["VERSION"]
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        for name in NAMES:
            folder = pathlib.Path(scratch) / (name if name == "debian" else f"axial-{version}")
            write(name, folder)
            if name == "debian":
                built_by_dpkg(folder, target / f"libaxial-dev_{version}_all.deb")
            elif name in ZIPPED:
                zipped(folder, target / f"axial-{version}-{name}.{ZIPPED[name]}")
            else:
                tarred(folder, target / f"axial-{version}-{name}.tar.gz")
            shutil.rmtree(folder)
    run(ROOT / "axial", "amalgamate", "-o", target / f"axial-{version}.hpp")
    sums = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in files_of(target)]
    (target / "SHA256SUMS").write_text("".join(sums), encoding="utf-8")


def main(arguments):
    parser = argparse.ArgumentParser(prog="./axial package", description=__doc__.split("\n")[0], allow_abbrev=False)
    parser.add_argument("name", choices=(*NAMES, ALL))
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, metavar="FOLDER", help="a folder that is not there yet, or empty")
    options = parser.parse_args(arguments)
    if options.output.exists() and (not options.output.is_dir() or any(options.output.iterdir())):
        parser.error(f"{options.output} is there already and not an empty folder")
    if options.name == ALL:
        write_all(options.output)
    else:
        write(options.name, options.output)
    print(f"written: {options.output}")


if __name__ == "__main__":
    main(sys.argv[1:])
