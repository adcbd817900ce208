#!/usr/bin/python3
"""The library's options stay in its headers: a user's functions, and the standard library's that the user instantiates, execute the
same instructions with and without the library in front of them, at every level. What GCC 12 does not put back is how it aligns
functions and loops, and where it puts constants: padding and addresses of constants are not compared.

usage: leaks_test.py COMPILER [TARGET FLAG...]
"""

import pathlib
import re
import sys
import tempfile

import compiler

LEVELS = ("-O0", "-Og", "-O1", "-Os", "-O2", "-O3")
STANDARD = "".join(f"#include <{name}>\n" for name in ("cstddef", "cstdint", "limits", "stdint.h", "type_traits", "utility"))
# Whatever would come out otherwise at another level, or with another order of instructions: loops, calls, long sums, a lambda,
# templates, a constructor that nobody wrote.
USER = """
namespace user {
struct Filter {
  float state[4] = {1.0F, 2.0F, 3.0F, 4.0F};
  float step(float x) {
    for (float& each : state) x = each += 0.25F * (x - each);
    return x;
  }
};
template <class F> float twice(const F& f, float x) { return f(f(x)); }
static int triangle(int n) { int sum = 0; for (int i = 0; i < n; ++i) sum += i; return sum; }
float filtered(float x) { Filter filter; Filter copy = filter; return copy.step(filter.step(x)); }
float squared(const float* a, const float* b) {
  const auto square = [](float x) { return x * x; };
  return twice(square, a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4]);
}
int swapped(int a, int b) { std::swap(a, b); return triangle(a) - b; }
}
"""
ADDRESS = re.compile(r"^\s*[0-9a-f]+:\s*|\s*(?:[@<;]|# ).*$", re.MULTILINE)
PADDING = re.compile(r"^(?:(?:data16 |cs )*nop\w?\b.*|xchg\s+%ax,%ax)\n", re.MULTILINE)
TARGET = re.compile(r"^(b\w*(?:\.n|\.w)?|j\w+|cbn?z|loop\w*)(\s+\S+)?$", re.MULTILINE)  # of a branch: padding moves it
CONSTANT = re.compile(r"^(?:\.word\s+0x\w+\n)?(R_\w+)\s+\.(?:LC|rodata).*", re.MULTILINE)


def comparable(code):
    for pattern, kept in ((ADDRESS, ""), (PADDING, ""), (TARGET, r"\1"), (CONSTANT, r"\1 constant")):
        code = pattern.sub(kept, code)
    return code.strip()


SECTION = re.compile(r"^Disassembly of section (\S+):\n((?:(?!^Disassembly).*\n?)*)", re.MULTILINE)


def sections(command, level, headers, source):
    """{section: instructions}: a function each."""
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "user.o"
        done = compiler.compile(command, level, "-ffunction-sections", "-c", "-x", "c++", "-", "-o", made, text=headers + source)
        if done.returncode:
            sys.exit(done.stderr)
        listing = compiler.compile((command[0].replace("g++", "objdump"),), "-d", "-r", "--no-show-raw-insn", made)
    return {name: comparable(code) for name, code in SECTION.findall(listing.stdout)}


def users(found):
    return {name: code for name, code in found.items() if "4user" in name or "4swap" in name}


def differences(command, level, headers):
    alone, behind = (users(sections(command, level, text, USER)) for text in (STANDARD, headers))
    if not {f".text._ZN4user{name}" for name in ("8filteredEf", "7squaredEPKfS1_", "7swappedEii")} <= alone.keys():
        sys.exit(f"{level}: the user's functions are not found: {sorted(alone)}")
    return [f"{level}: {name}" for name in sorted(alone.keys() | behind.keys()) if alone.get(name) != behind.get(name)]


def main(name, *target):
    command = (name, "-std=c++17", *target)
    headers = STANDARD + "#include <axial/fixed.hpp>\n"
    found = [each for level in LEVELS for each in differences(command, level, headers)]
    if found:
        sys.exit("other code behind the library: " + ", ".join(found))
    begun = STANDARD + "#include <axial/options/begin.hpp>\n"
    for level in set(LEVELS) - {"-O2"}:
        if not differences(command, level, begun):
            sys.exit(f"options that nobody ends are not noticed at {level}")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
