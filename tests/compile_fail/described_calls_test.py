#!/usr/bin/python3
"""Every rule of robot/problems.hpp broken by a robot that a program calls kernels of, in float and in fixed point: the compiler names the
rule, and says at most 12 lines behind it.

usage: described_calls_test.py [--compiler CXX] [--every N] [--from K] [--only REGEX] [--show]
The tests take every ninth program by each compiler; without --every it is all of them, which takes minutes.
"""

import argparse
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import description_rules as rules  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROBLEMS = ROOT / "firmware/include/axial/robot/problems.hpp"
MOST_BEHIND = 12  # lines behind the one that names the rule
NUMBERS = {"float": "axial", "Fixed32": "fixed"}
CALLS = """Positions<Robot, T> q;
Velocities<Robot, T> qd;
Accelerations<Robot, T> qdd;
EffortsOf<Robot, T> tau;
auto efforts() { return inverse_dynamics<Robot>(q, qd, qdd); }
auto accelerations() { return forward_dynamics<Robot>(q, qd, tau); }
"""


def stops():
    """The rules' functions, in the order of the header."""
    text = PROBLEMS.read_text(encoding="utf-8")
    table = text[text.index("stops[] = {"):]
    return re.findall(r"(\w+)<Of>", table[:table.index("};")])


def program(rule, number):
    maker = "classical_chain" if rule.broken.startswith("classical") else "chain"
    shared = "#include <axial/transmissions/shared_drives.hpp>\n" if re.search(r"driven_by|mimic|drive|differential|screw_spline", rule.broken) else ""
    return (f"#include <axial/axial.hpp>\n#include <axial/{NUMBERS[number]}.hpp>\n#include <axial/robot/classical.hpp>\n{shared}#include <limits>\n"
            f"using namespace axial;\nusing T = {number};\nstruct Robot {{\n  static constexpr auto chain = axial::{maker}({rule.broken});\n}};\n{CALLS}")


def said(compiler, text):
    command = [compiler, "-std=c++17", "-fsyntax-only", f"-I{ROOT}/firmware/include", "-x", "c++", "-"]
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"})
    return [line for line in done.stderr.splitlines() if not re.fullmatch(r"\d+ errors? generated\.", line)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--every", type=int, default=1, help="only one in so many")
    parser.add_argument("--from", type=int, default=0, dest="first", help="the first of those")
    parser.add_argument("--only", default="", help="only rules that match")
    parser.add_argument("--show", action="store_true")
    given = parser.parse_args()
    of = {rule.name: rule for rule in reversed(rules.ALL)}  # the first of each name
    wrong = [f"{name}: no chain breaks it; add one to description_rules.py" for name in stops() if name not in of]
    asked = [(name, number) for name in stops() for number in NUMBERS if name in of and re.search(given.only, name)]
    asked = asked[given.first::given.every]
    for name, number in asked:
        lines = said(given.compiler, program(of[name], number))
        at = next((i for i, line in enumerate(lines, 1) if re.search(rf"\b{name}\b", line)), 0)
        if at == 0 or len(lines) - at > MOST_BEHIND:
            wrong += [f"{name} in {number}: line {at} of {len(lines)}"] + (lines if given.show else [])
    print("\n".join(wrong) or f"{len(asked)} programs")
    return 1 if wrong or not asked else 0


if __name__ == "__main__":
    sys.exit(main())
