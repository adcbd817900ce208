"""Every mistake of beginners_mistakes.py: the compiler says its sentence among the first lines, and not many lines in all.

usage: beginners_mistakes_test.py [--compiler CXX] [--every N] [--only REGEX] [--show] [--headers FOLDER]
       beginners_mistakes_test.py --measure BEFORE    doc/data/messages.json: by both compilers, at the commit BEFORE and now
       beginners_mistakes_test.py --write-document    the table of doc/measurements/messages.md from that file; --document checks it
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import beginners_mistakes as mistakes  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIRST_LINES, MOST_LINES = 5, 12
NUMBERS = {"float": ("axial", "float"), "fixed32": ("fixed", "axial::Fixed32")}
COMPILERS = ("g++", "clang++")
DATA, DOCUMENT = ROOT / "doc/data/messages.json", ROOT / "doc/measurements/messages.md"
BEGIN, END = "<!-- table messages -->\n", "<!-- end -->"


def program(mistake, number):
    umbrella, scalar = NUMBERS[number]
    if mistake.name == "include of fixed point forgotten":
        umbrella = "axial"
    prologue = mistakes.PROLOGUE.format(umbrella=umbrella, number=scalar)
    return f"{prologue}{mistake.declared}void run() {{\n  {mistake.code}\n}}\n"


def said(compiler, library, source):
    command = [compiler, "-std=c++17", "-fsyntax-only", "-Werror=unused-result", f"-I{library}", "-x", "c++", "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"})
    return [line for line in done.stderr.splitlines() if not re.fullmatch(r"\d+ errors? generated\.", line)]


def measure(mistake, compiler, number, library):
    """A row: the sentence's line (0: not said) and the lines in all."""
    sentence = getattr(mistake, "fixed" if number == "fixed32" else number)
    lines = said(compiler, library, program(mistake, number))
    at = next((i for i, line in enumerate(lines, 1) if sentence in line), 0)
    return {"mistake": mistake.name, "number": number, "compiler": compiler, "sentence_line": at, "lines": len(lines)}, lines


def all_cases():
    return [(m, number) for m in mistakes.ALL for number in NUMBERS if getattr(m, "fixed" if number == "fixed32" else number)]


def at_commit(commit, folder):
    """The library as it was."""
    archive = subprocess.run(["git", "-C", ROOT, "archive", commit, "firmware/include"], capture_output=True, check=True).stdout
    subprocess.run(["tar", "x", "-C", folder], input=archive, check=True)
    return pathlib.Path(folder) / "firmware/include"


def write_data(before):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        old = at_commit(before, folder)
        for compiler in COMPILERS:
            for mistake, number in all_cases():
                was, now = (measure(mistake, compiler, number, library)[0] for library in (old, ROOT / "firmware/include"))
                rows.append({"mistake": mistake.name, "number": number, "compiler": compiler, "lines_before": was["lines"],
                             "lines": now["lines"], "sentence_line": now["sentence_line"]})
    DATA.write_text(json.dumps({"before": before, "rows": rows}, indent=0) + "\n", encoding="utf-8")


def table():
    data = json.loads(DATA.read_text(encoding="utf-8"))
    lines = {(r["mistake"], r["number"], r["compiler"]): r for r in data["rows"]}
    text = f"Before: commit `{data['before']}`.\n\n| mistake | number | GCC, before | now | Clang, before | now |\n| --- | --- | ---: | ---: | ---: | ---: |\n"
    for name, number in dict.fromkeys((r["mistake"], r["number"]) for r in data["rows"]):
        cells = [f"{lines[name, number, c]['lines_before'] or 'compiles'} | {lines[name, number, c]['lines']}" for c in COMPILERS]
        text += f"| {name} | {number} | {' | '.join(cells)} |\n"
    return text


def document():
    """Before the table, the table, after it."""
    text = DOCUMENT.read_text(encoding="utf-8")
    begin = text.index(BEGIN) + len(BEGIN)
    return text[:begin], text[begin:text.index(END, begin)], text[text.index(END, begin):]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--every", type=int, default=1, help="only one in so many")
    parser.add_argument("--only", default="")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--headers", default=ROOT / "firmware/include")
    parser.add_argument("--measure", metavar="BEFORE")
    parser.add_argument("--write-document", action="store_true")
    parser.add_argument("--document", action="store_true")
    given = parser.parse_args()
    if given.measure or given.write_document or given.document:
        if given.measure:
            write_data(given.measure)
        if given.write_document:
            before, _, after = document()
            DOCUMENT.write_text(before + table() + after, encoding="utf-8")
        return int(given.document and document()[1] != table())
    cases = [(m, number) for m, number in all_cases() if re.search(given.only, m.name)][::given.every]
    wrong = []
    for mistake, number in cases:
        row, lines = measure(mistake, given.compiler, number, given.headers)
        if not 0 < row["sentence_line"] <= FIRST_LINES or len(lines) > MOST_LINES:
            wrong += [f"{mistake.name}, {number}: in line {row['sentence_line']} of {len(lines)}"] + (lines if given.show else [])
    print("\n".join(wrong) or f"{len(cases)} mistakes")
    return 1 if wrong or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
