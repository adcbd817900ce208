#!/usr/bin/python3
"""Public headers and every kernel compile without a warning of the strict sets that people use; so do they behind a
firmware's globals of short names.

usage: warnings_test.py COMPILER STANDARD [TARGET FLAG...]
"""

import pathlib
import sys
import tempfile

import compiler

STRICT = ("-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Wsign-conversion", "-Wdouble-promotion", "-Wundef", "-Wold-style-cast")
GCC_ALONE = ("-Wuseless-cast",)
# A warning each, so that a set that lost one is noticed.
WARNED = {
    "-Wshadow": "int f(int a) { { int a = 1; return a; } }",
    "-Wconversion": "short f(int a) { return a; }",
    "-Wsign-conversion": "unsigned f(int a) { return a; }",
    "-Wdouble-promotion": "double f(float a, double b) { return a * b; }",
    "-Wundef": "#if NOT_DEFINED\n#endif",
    "-Wold-style-cast": "int f(long a) { return (int)a; }",
    "-Wunused-parameter": "int f(int a) { return 0; }",
    "-Wuseless-cast": "int f(int a) { return static_cast<int>(a); }",
}
GLOBALS = ("q qd qdd tau u v w a b c d e f g h i j k l m n p r s t x y z dt state gains in out status scene model link joint "
           "mass speed limit position velocity sum result value row col size count angle sine cosine payload now last time lo hi").split()
TYPES = ("Robot", "State", "Result", "Arm", "Motion", "Gains", "Controller", "Config")
SPELT = {"23": "2b"}  # Clang 14 knows the draft's name alone; GCC 12 both


def said(command, source, headers=None):
    """Lines with a warning or an error."""
    include = ("-include", headers) if headers else ()
    result = compiler.compile(command, "-fsyntax-only", *include, "-x", "c++", "-", text=source)
    found = [line for line in result.stderr.splitlines() if "warning:" in line or "error:" in line]
    return found or ([result.stderr] if result.returncode else [])


def main(name, standard, *target):
    gcc = "clang" not in name
    command = (name, f"-std=c++{SPELT.get(standard, standard)}", *target, *STRICT, *(GCC_ALONE if gcc else ()))
    for flag, source in WARNED.items():
        if flag in GCC_ALONE and not gcc:
            continue
        if not said(command, source + "\n"):
            sys.exit(f"{flag} is not noticed: {source}")
    with tempfile.TemporaryDirectory() as folder:
        headers = pathlib.Path(folder) / "all.hpp"
        headers.write_text(compiler.public_headers())
        found = said((*command, "-DAXIAL_WARN_SHADOW"), (compiler.HERE / "every_kernel.cpp").read_text(), headers)
        headers.write_text("".join(f"static float {name}[6];\n" for name in GLOBALS) + "".join(f"struct {name} {{}};\n" for name in TYPES) +
                           compiler.public_headers())
        behind = said((*command, "-DAXIAL_KERNELS_OF=1"), (compiler.HERE / "every_kernel.cpp").read_text(), headers)
        found += [line for line in behind if "firmware/include" in line or "error:" in line]
    sys.exit("\n".join(found) if found else 0)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
