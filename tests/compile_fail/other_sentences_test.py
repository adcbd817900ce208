#!/usr/bin/python3
"""Every sentence of other_sentences.py is said as often as it has to be, and at most 12 lines behind it.

usage: other_sentences_test.py [--compiler CXX] [--only REGEX] [--show]
"""

import argparse
import re
import sys

sys.dont_write_bytecode = True
import described_calls_test as calls  # noqa: E402
import other_sentences as others  # noqa: E402

MOST_BEFORE = 6  # lines that lead to a sentence: who includes the header


def program(other):
    includes = "".join(f"#include <axial/{header}.hpp>\n" for header in other.headers)
    return f"{others.PROLOGUE.format(includes=includes)}{other.declared}void run() {{\n  {other.code}\n}}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--only", default="", help="only sentences that match")
    parser.add_argument("--show", action="store_true")
    given = parser.parse_args()
    asked, wrong = [other for other in others.ALL if re.search(given.only, other.sentence)], []
    for other in asked:
        lines = calls.said(given.compiler, program(other))
        at = [i for i, line in enumerate(lines, 1) if other.sentence in line and "error:" in line]
        tails = [behind - line for line, behind in zip(at, at[1:] + [len(lines) + MOST_BEFORE])]
        if len(at) != other.times or max(tails) > calls.MOST_BEHIND + MOST_BEFORE:
            wrong += [f"lines {at} of {len(lines)}: {other.sentence}"] + (lines if given.show else [])
    print("\n".join(wrong) or f"{len(asked)} sentences")
    return 1 if wrong or not asked else 0


if __name__ == "__main__":
    sys.exit(main())
