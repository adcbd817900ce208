#!/usr/bin/python3
"""Behind a sentence of ours little more is said: every refusal that the documents list, in an algorithm that it refuses.

usage: tails_test.py [--compiler gcc|clang] [--every N] [--from K] [--only REGEX] [--show]
Programs are a user's (calls.py): values, and one algorithm's calls from a function that is no template. From each sentence to the
next one, or to the end, a compiler says at most 12 lines. Clang says three for each call on the way to the sentence, and one for
each file that includes another; those count. A program of several calls may have a sentence of each.
The tests take every second refusal by GCC and the others by Clang; without --every it is all of them, which takes a minute and a half
of a processor.
"""

import argparse
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import calls  # noqa: E402
import check  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_BEHIND = 12  # lines behind a sentence


def said(compiler, text):
    """The lines that a compiler says of a program, but for Clang's count of its errors."""
    command = [check.COMPILERS[compiler], *check.FLAGS, *check.FLAGS_OF[compiler], "-fsyntax-only", f"-I{ROOT}/firmware/include", f"-I{ROOT}",
               "-x", "c++", "-"]
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"})
    return [line for line in done.stderr.splitlines() if not re.fullmatch(r"\d+ errors? generated\.", line)]


def longest_tail(lines):
    """Most lines between a sentence of ours and the next, or the end; lines in all where there is none."""
    sentences = [i for i, line in enumerate(lines) if re.search(r"error: .*\baxial: ", line)] + [len(lines)]
    return max((b - a - 1 for a, b in zip(sentences, sentences[1:])), default=len(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", default="gcc", choices=check.COMPILERS)
    parser.add_argument("--every", type=int, default=1, help="only one in so many")
    parser.add_argument("--from", type=int, default=0, dest="first", help="the first of those")
    parser.add_argument("--only", default="", help="only sentences that match")
    parser.add_argument("--show", action="store_true")
    given = parser.parse_args()
    asked = [w for w in check.witnesses() if re.search(given.only, w[0].sentence)][given.first::given.every]
    wrong = []
    for refusal, c, algorithm in asked:
        lines = said(given.compiler, calls.source(c, algorithm))
        at = next((i for i, line in enumerate(lines, 1) if refusal.sentence in line), 0)
        if at == 0 or longest_tail(lines) > MOST_BEHIND:
            wrong += [f"{algorithm}, line {at} of {len(lines)}: {refusal.sentence}"] + (lines if given.show else [])
    print("\n".join(wrong) or f"{len(asked)} refusals")
    return 1 if wrong or not asked else 0


if __name__ == "__main__":
    sys.exit(main())
