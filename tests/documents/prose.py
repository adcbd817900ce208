#!/usr/bin/python3
"""The guides read well as far as a count can tell: short sentences, short paragraphs, lines that fit a window.

usage: prose.py ROOT
The style asks for 120 columns, 25 words and five sentences; these are ceilings above that. Tables, blocks, indented
formulae and headings are no prose, and a line that one link fills may be longer.
"""
import pathlib
import re
import sys

LONGEST_LINE, MOST_SENTENCES, MOST_WORDS = 130, 7, 35
NO_PROSE = re.compile(r"^```.*?^```|^(?:\||#|<!--|!\[|    ).*?$", re.MULTILINE | re.DOTALL)
PARAGRAPH = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )")
TARGET, CODE = re.compile(r"\]\([^)]*\)"), re.compile(r"`[^`]*`")
SENTENCE = re.compile(r"(?<=[\w)\]\"'*]{2}[.:?!])\s+(?=[A-Z*`\[(])")  # not behind an initial
WORD = re.compile(r"(?<!\S)[(*\[\"]*[A-Za-z]{2,}")  # symbols of formulae are none
BAD = (("x " * 66, "wide"), ("One word. " * 8, "sentences"), ("of the\n" * 18, "words"))


def problems(text):
    prose = NO_PROSE.sub("\n", text)
    yield from (f"a line is {len(line)} wide: {line[:60]}" for line in prose.splitlines()
                if len(line) > LONGEST_LINE and not re.fullmatch(r"\s*\S+", line))
    for paragraph in PARAGRAPH.split(prose):
        sentences = SENTENCE.split(CODE.sub("Code", TARGET.sub("]", " ".join(paragraph.split()))))
        if len(sentences) > MOST_SENTENCES:
            yield f"a paragraph has {len(sentences)} sentences: {sentences[0][:60]}"
        for sentence in sentences:
            words = len(WORD.findall(sentence))
            if words > MOST_WORDS:
                yield f"a sentence has {words} words: {sentence[:60]}"


def main(root):
    found = [f"this check does not see what is too many {what}" for text, what in BAD if what not in "".join(problems(text))]
    for page in sorted((pathlib.Path(root) / "doc/guides").glob("*.md")):
        found += (f"doc/guides/{page.name}: {problem}" for problem in problems(page.read_text(encoding="utf-8")))
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
