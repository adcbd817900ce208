#!/usr/bin/python3
"""Whatever flags a build has, no call says ok of NaN or infinity, in or out; a build in which the compiler leaves none of them is refused
in one sentence. The rows are those of doc/guides/any_build.md.

usage: flags_test.py COMPILER [--only ROW] [--states N]
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import compiler

GCC = ("-O2 -ffast-math", "-Ofast", "-O1 -ffinite-math-only", "-O2 -ffinite-math-only -DAXIAL_USER_OPTIONS", "-Ofast -DAXIAL_USER_OPTIONS",
       "-O3 -march=native -ffast-math", "-Ofast -flto", "-O2 -funsafe-math-optimizations", "-O2")
CLANG = ("-Ofast -fno-fast-math", "-O2 -funsafe-math-optimizations", "-O3 -march=native", "-O2 -flto", "-O2")
REFUSED_BY_CLANG = ("-O2 -ffast-math", "-Ofast", "-O1 -ffinite-math-only", "-O2 -ffinite-math-only -DAXIAL_USER_OPTIONS")
SENTENCE = "axial tells of NaN, which Clang leaves out"


def built_and_run(name, flags, states, folder):
    """What went wrong; empty where all is right."""
    program = folder / "hostile_calls"
    done = compiler.compile([name, "-std=c++17"], *flags.split(), compiler.HERE / "hostile_calls.cpp", "-o", program)
    if done.returncode:
        return done.stderr
    run = subprocess.run([program, str(states)], capture_output=True, text=True, check=False)
    return "" if run.returncode == 0 else run.stdout


def refused(name, flags):
    """Likewise of a build that has to be refused: every header that can be first says so, once, and nothing behind it."""
    done = compiler.compile([name, "-std=c++17", "-fsyntax-only", "-x", "c++", "-"], *flags.split(), text="#include <axial/axial.hpp>\n")
    errors = [line for line in done.stderr.splitlines() if "error:" in line]
    right = done.returncode != 0 and SENTENCE in errors[0] and len(done.stderr.splitlines()) <= 12
    return "" if right else f"not refused in a sentence:\n{done.stderr}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("compiler")
    parser.add_argument("--only", help="one row")
    parser.add_argument("--states", type=int, default=100000)
    given = parser.parse_args()
    clang = "clang" in pathlib.Path(given.compiler).name
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for flags in CLANG if clang else GCC:
            if given.only in (None, flags):
                said = built_and_run(given.compiler, flags, given.states, pathlib.Path(folder))
                wrong += [f"{flags}: {said}"] if said else []
                print(given.compiler, flags, "wrong" if said else "right", flush=True)
    for flags in REFUSED_BY_CLANG if clang else ():
        if given.only in (None, flags):
            said = refused(given.compiler, flags)
            wrong += [f"{flags}: {said}"] if said else []
            print(given.compiler, flags, "not refused" if said else "refused", flush=True)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
