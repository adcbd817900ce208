#!/usr/bin/python3
"""Macros of other people's headers (foreign_macros.hpp) in front of the library's do no harm, and the library defines none but
AXIAL_*.

usage: macros_test.py COMPILER
"""

import pathlib
import re
import sys
import tempfile

import compiler

FOREIGN = compiler.HERE / "foreign_macros.hpp"
STANDARD = "".join(f"#include <{name}>\n" for name in ("cstddef", "cstdint", "limits", "stdint.h", "type_traits", "utility"))
DEFINED = re.compile(r"^#define (\w+)", re.MULTILINE)
# What each would do to an innocent line.
CLASHES = ("int small;", "int near = 1;", "enum { B1 };", "template <int _N> struct S;", "template <class SS> struct S;",
           "int max();", "double PI;", "struct F { F(); };")


def errors(command, headers, source):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "headers.hpp"
        path.write_text(headers)
        result = compiler.compile(command, "-fsyntax-only", "-include", path, "-x", "c++", "-", text=source)
    return result.stderr if result.returncode else ""


def macros(command, headers):
    return set(DEFINED.findall(compiler.compile(command, "-dM", "-E", "-x", "c++", "-", text=headers).stdout))


def main(name):
    command = (name, "-std=c++17")
    foreign = f'#include "{FOREIGN}"\n'
    for line in CLASHES:
        if not errors(command, STANDARD + foreign, line + "\n"):
            sys.exit(f"foreign_macros.hpp does no harm to: {line}")
    kernels = (compiler.HERE / "every_kernel.cpp").read_text()
    found = errors(command, STANDARD + foreign + compiler.public_headers(), kernels)
    if found:
        sys.exit(found)
    own = macros(command, STANDARD + compiler.public_headers()) - macros(command, STANDARD)
    wrong = sorted(name for name in own if not name.startswith("AXIAL_"))
    if wrong or not own:
        sys.exit(f"macros of the library: {wrong or 'none, so they are not seen'}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
