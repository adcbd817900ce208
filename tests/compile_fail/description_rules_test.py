"""Every rule of a description: just beyond its bound the compiler names rule and link among the first lines, just inside it compiles.

usage: description_rules_test.py --compiler CXX | --document | --write-document
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import description_rules as rules  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
FUNCTIONS = ROOT / "firmware/include/axial/robot/malformed.hpp"
DOCUMENT = ROOT / "doc/guides/description_rules.md"
BEGIN, END = "<!-- table rules -->\n", "<!-- end -->"
FIRST_LINES, MOST_LINES = 5, 12


def chain(parts, more=""):
    return f"axial::{'classical_' if parts.startswith('classical') else ''}chain({parts}{more})"


def program(chains):
    text = "#include <axial/robot/classical.hpp>\n#include <axial/scene/consistency.hpp>\n#include <limits>\nusing namespace axial;\n"
    for i, parts in enumerate(chains):
        text += f"struct Robot{i} {{\n  static constexpr auto chain = {parts};\n}};\nstatic_assert(joint_count<Robot{i}> > 0);\n"
    return text


class Compiler:
    def __init__(self, name, folder):
        self.name, self.source = name, pathlib.Path(folder) / "robot.cpp"

    def messages(self, chains):
        """None where it compiles, else the lines that the compiler prints."""
        self.source.write_text(program(chains), encoding="utf-8")
        result = subprocess.run([self.name, "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", f"-I{ROOT}/firmware/include", self.source],
                                capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"})
        if result.returncode == 0 and not result.stderr:
            return None
        return [line for line in result.stderr.splitlines() if not re.fullmatch(r"\d+ errors? generated\.", line)]


def check_sound(compiler):
    """All at once: what lies inside, and what is accepted as published, of links and of robots."""
    doubtful = [rule.broken for rule in rules.DOUBTFUL + rules.TWICE]
    accepted = [chain(parts, ", accept(as_published)") for parts in doubtful]
    by_links = [chain(re.sub(r"((?:classical_)?(?:revolute|prismatic)\(\))", r"\1.accept(as_published)", rule.broken))
                for rule in rules.DOUBTFUL + rules.TWICE if rule.of != "robot"]
    lines = compiler.messages([chain(rule.sound) for rule in rules.ALL] + accepted + by_links)
    return [] if lines is None else ["inside the bounds, or accepted, but refused:"] + lines[:30]


def check_broken(compiler, rule, parts):
    lines = compiler.messages([parts])
    if lines is None:
        return [f"{rule.name}: compiles: {parts}"]
    named = [i for i, line in enumerate(lines) if re.search(rf"\b{rule.name}\b.*\b{re.escape(rule.of)}(?!\w)", line)]
    if not named or named[0] >= FIRST_LINES:
        return [f"{rule.name} of {rule.of} is not in the first {FIRST_LINES} lines for {parts}:"] + lines
    if len(lines) > MOST_LINES:
        return [f"{rule.name}: {len(lines)} lines, at most {MOST_LINES} are wanted"] + lines
    return []


def check(compiler):
    wrong = check_sound(compiler)
    for rule in rules.ALL:
        wrong += check_broken(compiler, rule, chain(rule.broken))
    for rule in rules.STRUCTURAL:  # which no .accept() keeps
        wrong += check_broken(compiler, rule, chain(rule.broken, ", accept(as_published)"))
    return wrong + check_all_are_here()


def functions():
    """Names of the rules and what the compiler quotes of them."""
    return dict(re.findall(r"^template <class Of> void (\w+)\(\) \{\}  ///< axial: (.*)$", FUNCTIONS.read_text(encoding="utf-8"), re.M))


def check_all_are_here():
    missing = sorted(set(functions()) ^ {rule.name for rule in rules.ALL})
    return [f"{name}: a rule without a case, or a case without a rule" for name in missing]


def table():
    rows, said, seen = ["| quantity | bound | message | accepted |", "| --- | --- | --- | --- |"], functions(), set()
    for group, kept in ((rules.STRUCTURAL, "never"), (rules.DOUBTFUL, "as published")):
        for rule in group:
            if rule.name not in seen:
                rows.append(f"| {rule.what} | {rule.bound} | {said[rule.name].split(';')[0]} | {kept} |")
            seen.add(rule.name)
    rows.append("| every quantity of a link, every other part | given once | ... is given twice | the later one, as published |")
    return "\n".join(rows) + "\n"


def document():
    """Of the document: before the table, the table, after it."""
    text = DOCUMENT.read_text(encoding="utf-8")
    begin = text.index(BEGIN) + len(BEGIN)
    end = text.index(END, begin)
    return text[:begin], text[begin:end], text[end:]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler")
    parser.add_argument("--document", action="store_true", help="the document's table is that of the rules")
    parser.add_argument("--write-document", action="store_true")
    given = parser.parse_args()
    wrong = []
    if given.write_document:
        before, _, after = document()
        DOCUMENT.write_text(before + table() + after, encoding="utf-8")
    if given.document and document()[1] != table():
        wrong.append(f"{DOCUMENT}: the rules have changed; run {pathlib.Path(__file__).name} --write-document")
    if given.compiler:
        with tempfile.TemporaryDirectory() as folder:
            wrong += check(Compiler(given.compiler, folder))
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
