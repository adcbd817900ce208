#!/usr/bin/python3
"""Writes the files that a page shows: every code block that stands right after a line `<!-- file: NAME -->`.

usage: shown_files.py PAGE FOLDER
"""

import pathlib
import re
import sys

BLOCK = re.compile(r"^<!-- file: (\S+) -->\n```\w*\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    page, folder = map(pathlib.Path, sys.argv[1:])
    text = page.read_text()
    blocks = BLOCK.findall(text)
    if len(blocks) != text.count("<!-- file:") or not blocks:
        print(f"{page}: {text.count('<!-- file:')} file marks, {len(blocks)} of them before a code block", file=sys.stderr)
        return 1
    for name, block in blocks:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists():
            print(f"{page}: shows {name} twice, or it is there already", file=sys.stderr)
            return 1
        path.write_text(block)
    return 0


if __name__ == "__main__":
    sys.exit(main())
