"""The tables of documents: rows as Markdown, between the marks that they are written to."""

import json
import pathlib
import re
import sys

MARKED = re.compile(r"(<!-- table (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)


def load(file):
    return json.loads(file.read_text(encoding="utf-8"))


def markdown(header, rows, words=1):
    """Numbers, to the right, in the columns whose places are not in `words`: how many stand first, or which ones."""
    words = range(words) if isinstance(words, int) else words
    lines = [header, ["---" if k in words else "---:" for k in range(len(header))], *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def filled(text, table):
    """With table(name), a text, between each pair of marks."""
    return MARKED.sub(lambda match: match[1] + table(match[2]) + match[3], text)


def fill(document, table):
    """Replaces what stands between the marks of a document by table(name), a text."""
    path = pathlib.Path(document)
    path.write_text(filled(path.read_text(encoding="utf-8"), table), encoding="utf-8")


def command(usage, tables, read=lambda folder: folder):
    """The whole of a script that fills one document: its tables by name, each of what read(DATA_FOLDER) gives."""
    if len(sys.argv) != 3:
        sys.exit(usage)
    data = read(pathlib.Path(sys.argv[1]))
    fill(sys.argv[2], lambda name: tables[name](data))


def unique(values):
    return list(dict.fromkeys(values))


def grouped(number):
    return f"{number:,}".replace(",", " ")


def span(low, high):
    return grouped(high) if low == high else f"{grouped(low)} to {grouped(high)}"
