#!/usr/bin/python3
"""Every C++ source is compiled as C++17 or later by a compiler whose default is older: the tree is configured for it, nothing is built.

usage: standard_test.py ROOT COMPILER
"""
import json
import re
import subprocess
import sys
import tempfile

OLDEST = 17
STANDARD = re.compile(r" -std=c\+\+(\d+)(?= |$)")


def commands(build):
    """What the build would run."""
    listed = subprocess.run(["ninja", "-C", build, "-t", "compdb"], check=True, capture_output=True, text=True).stdout
    return [entry for entry in json.loads(listed) if entry["file"].endswith(".cpp") and " -c " in entry["command"]]


def configured(root, compiler, folder):
    subprocess.run(["cmake", "-S", root, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}"], check=True, stdout=subprocess.DEVNULL)
    return folder


def standard_of(command):
    """The last one counts; 0 where none is said."""
    found = STANDARD.findall(command)
    return int(found[-1]) if found else 0


def main():
    with tempfile.TemporaryDirectory() as folder:
        every = commands(configured(*sys.argv[1:], folder))
    unsaid = sorted({entry["output"] for entry in every if standard_of(entry["command"]) < OLDEST})
    assert every, "the build compiles nothing"
    for output in unsaid:
        print(f"{output}: compiled without -std=c++{OLDEST} or later; CMAKE_CXX_STANDARD says it for all")
    sys.exit(1 if unsaid else 0)


if __name__ == "__main__":
    main()
