#!/usr/bin/python3
"""Kernels of batches put what they have no register for at addresses that vectors are aligned to; Clang does so only where it is asked.

usage: batch_stack_test.py CLANG++
"""

import pathlib
import re
import sys
import tempfile

import compiler

SOURCE = """
#include <axial/batch.hpp>
#include <robots/puma560.hpp>
using Values = axial::Joints<robots::Puma560, axial::Batch<double>>;
extern "C" Values torque(const Values& q, const Values& qd, const Values& qdd) { return axial::inverse_dynamics<robots::Puma560>(q, qd, qdd); }
"""
HEADER = "axial/scalar/lanes.hpp"
ASKED = 'asm volatile("" : "=m"(slot));'
WIDTHS = {32: ("-mavx2", "-mfma"), 64: ("-mavx512f",)}  # bytes of a vector


def assembly(name, flags, *more):
    done = compiler.compile((name, *more), "-std=c++17", "-O2", *flags, "-S", "-x", "c++", "-", "-o", "-", text=SOURCE)
    if done.returncode:
        sys.exit(done.stderr)
    return done.stdout


def is_aligned(code, bytes_of_vector):
    """Whether the kernels that keep vectors on the stack align it."""
    spills = re.search(r"vmov[au]p[sd]\s+%[yz]mm\d+, -?\d*\(%rsp\)", code)
    if not spills:
        sys.exit(f"nothing is put on the stack in vectors of {bytes_of_vector} bytes: the test sees nothing")
    return f"andq\t$-{bytes_of_vector}, %rsp" in code and not re.search(r"vmovup[sd]\s+%[yz]mm\d+, -?\d*\(%rsp\)", code)


def main(name):
    with tempfile.TemporaryDirectory() as folder:
        text = (compiler.INCLUDE / HEADER).read_text(encoding="utf-8")
        if text.count(ASKED) != 1:
            sys.exit(f"{HEADER} does not say once: {ASKED}")
        unasked = pathlib.Path(folder) / HEADER
        unasked.parent.mkdir(parents=True)
        unasked.write_text(text.replace(ASKED, ""), encoding="utf-8")
        for bytes_of_vector, flags in WIDTHS.items():
            if not is_aligned(assembly(name, flags), bytes_of_vector):
                sys.exit(f"vectors of {bytes_of_vector} bytes are kept where no vector is aligned")
            if is_aligned(assembly(name, flags, f"-I{folder}"), bytes_of_vector):
                sys.exit(f"a stack that is not aligned to {bytes_of_vector} bytes is not noticed")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
