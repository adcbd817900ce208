"""Compiles and runs single test sources in a copy of the project: light flags, no CMake, only what a mutation touches."""

import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FOLDERS = ("firmware", "hal", "robots", "host_sim", "tests", "cmake")
# As little optimisation as the compiler has: a test runs for milliseconds and is compiled for seconds.
FLAGS = ["-std=c++17", "-O0", "-DAXIAL_INLINE=", "-DAXIAL_USER_OPTIONS", "-ffp-contract=off", "-w"]
INCLUDES = ["-Ifirmware/include", "-I.", "-Itests", "-Ihost_sim"]
# Of the processor, which nobody else's work makes longer.
RUN_SECONDS = 60
COMPILE_SECONDS = 300


class BuildError(Exception):
    """What the compiler or the linker says."""


class Copy:
    """The project's sources in a folder of their own, where they may be changed."""

    def __init__(self, folder):
        self.folder = folder
        for name in FOLDERS:
            shutil.copytree(ROOT / name, folder / name, symlinks=True, ignore=shutil.ignore_patterns("build", "__pycache__"))

    @contextlib.contextmanager
    def changed(self, file, change):
        """With change(text) in the file, and without it again."""
        path = self.folder / file
        text = path.read_text()
        path.write_text(change(text))
        try:
            yield
        finally:
            path.write_text(text)


class Programs:
    """programs.toml: what a test source needs beside itself."""

    def __init__(self, path=HERE / "programs.toml"):
        data = tomllib.loads(path.read_text())
        self.libraries = data["library"]
        self.tests = data["test"]

    def of(self, test):
        """(sources with their flags, linker arguments) of the program of a test source."""
        own = self.tests.get(test, {})
        sources = [(f"tests/{test}", own.get("flags", []))]
        sources += [(source, own.get("flags", [])) for source in own.get("sources", [])]
        link = []
        for name in own.get("libraries", ["oracle"]):
            library = self.libraries[name]
            sources += [(source, library.get("flags", [])) for source in library.get("sources", [])]
            link += library.get("link", [])
        return sources, link


class Objects:
    """Objects of unchanged sources, and what each was made of."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir(exist_ok=True)

    def precompile(self):
        """GoogleTest's header, half a second of every source."""
        header = self.folder / "tests.hpp"
        header.write_text("#include <gtest/gtest.h>\n#include <cmath>\n#include <string>\n#include <vector>\n")
        subprocess.run(["g++", *FLAGS, "-x", "c++-header", str(header), "-o", f"{header}.gch"], check=True)

    @property
    def precompiled(self):
        return ["-include", str(self.folder / "tests.hpp")]

    def path(self, source, flags):
        return self.folder / (re.sub(r"\W", "_", " ".join([source, *flags])) + ".o")

    def depend_on(self, source, flags, file):
        """Whether a source reads a file; where it was not compiled, its preprocessor tells."""
        made = self.path(source, flags).with_suffix(".d")
        if not made.exists():
            flags = [flag.replace("@ROOT@", str(ROOT)) for flag in flags]
            told = subprocess.run(["g++", *FLAGS, *INCLUDES, *flags, "-MM", source], cwd=ROOT, check=True, capture_output=True, text=True)
            return file in {os.path.normpath(word) for word in told.stdout.split()}
        return file in {os.path.normpath(word) for word in made.read_text().split()}


def compile_source(copy, source, flags, output, included=()):
    """One object; raises BuildError with the first error's line."""
    flags = [flag.replace("@ROOT@", str(ROOT)) for flag in flags]
    launcher = [shutil.which("ccache")] if shutil.which("ccache") else []
    command = [*limited(COMPILE_SECONDS), *launcher, "g++", *FLAGS, *(included if source.startswith("tests/") and source.endswith(".cpp") else ()), *INCLUDES, *flags, "-MMD", "-c", source, "-o", str(output)]
    sloppy = {**os.environ, "CCACHE_SLOPPINESS": "pch_defines,time_macros", "CCACHE_NOHASHDIR": "1"}  # or nothing with a precompiled header is kept
    done = subprocess.run(command, cwd=copy.folder, capture_output=True, text=True, env=sloppy)
    if done.returncode:
        lines = [line for line in done.stderr.splitlines() if "error:" in line] or done.stderr.splitlines()
        raise BuildError(lines[0] if lines else f"{source}: the compiler failed")


def limited(seconds):
    return ["prlimit", f"--cpu={seconds}"]


def link(objects, libraries, output):
    command = ["g++", *map(str, objects), "-lgtest_main", "-lgtest", "-lquadmath", "-lpthread", *libraries, "-o", str(output)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        lines = done.stderr.strip().splitlines()
        raise BuildError(next((line for line in lines if "undefined reference" in line), lines[-1]))


def run(program, tests):
    """(whether all passed, how many ran, the first that failed) of a program's tests that the filter names."""
    command = [*limited(RUN_SECONDS), str(program), f"--gtest_filter={tests or '*'}", "--gtest_brief=1", "--gtest_fail_fast"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=5 * RUN_SECONDS)
    except subprocess.TimeoutExpired:
        return False, 1, f"{tests or program.name}: no answer in {5 * RUN_SECONDS} s"
    counted = re.search(r"\[=+\] (\d+) tests? from", done.stdout)
    ran = int(counted.group(1)) if counted else 0
    failed = re.search(r"\[  FAILED  \] ([\w./]+)", done.stdout)
    if done.returncode and not failed:
        return False, ran, f"{tests or program.name}: ended with status {done.returncode}"
    return done.returncode == 0, ran, failed.group(1) if failed else ""
