#!/usr/bin/python3
"""Every header says first, in one sentence, that it is C++17, where a compiler is told an older standard; axial.h stays C.

usage: language_test.py ROOT
"""
import itertools
import pathlib
import shutil
import subprocess
import sys

STANDARDS = ("gnu++14", "c++11", "c++14", "gnu++11")
SENTENCE = "axial needs C++17: pass -std=c++17 or -std=gnu++17"
USERS = ("axial/axial.hpp", "axial/fixed.hpp", "axial/batch.hpp", "axial/algorithm.hpp", "axial/cost.hpp", "axial/robot/chain.hpp",
         "axial/c_interface/export.hpp", "axial/simulation/motion.hpp", "axial/control/payload_estimator.hpp",
         "axial/dynamics/inverse_dynamics.hpp")
BEHIND = 6  # lines: the sentence's source, what ends the compiler
FIRST, DEEPEST = 3, 22  # the sentence's line: of what documents name; of what other headers lead to


def said(root, compiler, standard, source, language="c++"):
    command = [compiler, f"-std={standard}", "-E", "-x", language, f"-I{root}/firmware/include", "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"})
    return done.returncode, done.stderr.splitlines()


def main():
    root, compilers, wrong = pathlib.Path(sys.argv[1]), [name for name in ("g++", "clang++") if shutil.which(name)], []
    folder = root / "firmware/include"
    headers = [str(path.relative_to(folder)) for path in sorted(folder.rglob("*.hpp")) if path.parent.name != "options"]
    standards = itertools.cycle(STANDARDS)
    for compiler, header in itertools.product(compilers, headers):
        standard = next(standards)
        code, lines = said(root, compiler, standard, f"#include <{header}>\n")
        at = next((i for i, line in enumerate(lines, 1) if SENTENCE in line), 0)
        if code == 0 or not 0 < at <= (FIRST if header in USERS else DEEPEST) or len(lines) > at + BEHIND:
            wrong += [f"{compiler} -std={standard}: <{header}> says it in line {at} of {len(lines)}"] + lines
    for standard in ("c99", "gnu11"):
        code, lines = said(root, "cc", standard, "#include <axial/axial.h>\n", "c")
        wrong += [f"axial.h is no C of {standard}"] + lines if code or lines else []
    print("\n".join(wrong) or f"{len(headers)} headers")
    return 1 if wrong or not headers else 0


if __name__ == "__main__":
    sys.exit(main())
