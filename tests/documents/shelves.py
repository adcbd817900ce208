#!/usr/bin/python3
"""The documents keep their form: links lead somewhere, guides are short and say for whom they are, shelves list their pages.

usage: shelves.py ROOT
"""
import pathlib
import re
import subprocess
import sys

LINK = re.compile(r"\]\(([^)\s#]+)(?:#[^)]*)?\)")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
LONGEST_GUIDE, LONGEST_README = 150, 130
FOR_WHOM = re.compile(r"^# .*\n\nFor ", re.MULTILINE)


def listed(root, pattern):
    names = subprocess.run(["git", "-C", root, "ls-files", "--cached", "--others", "--exclude-standard", pattern], check=True, capture_output=True, text=True)
    return [root / name for name in names.stdout.splitlines() if (root / name).is_file()]


def broken_links(page):
    for target in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
        if "://" not in target and not (page.parent / target).exists():
            yield target


def problems(root):
    for page in listed(root, "*.md"):
        yield from (f"{page.relative_to(root)}: {target} is not there" for target in broken_links(page))
    for shelf in ("guides", "measurements"):
        pages = [page for page in sorted((root / "doc" / shelf).glob("*.md")) if page.name != "README.md"]
        index = (root / "doc" / shelf / "README.md").read_text(encoding="utf-8")
        yield from (f"doc/{shelf}/README.md does not list {page.name}" for page in pages if f"]({page.name})" not in index)
        if shelf == "guides":
            yield from guide_problems(root, pages)
    lines = len((root / "README.md").read_text(encoding="utf-8").splitlines())
    if lines > LONGEST_README:
        yield f"README.md has {lines} lines, at most {LONGEST_README}"


def guide_problems(root, pages):
    for page in pages:
        text = page.read_text(encoding="utf-8")
        if len(text.splitlines()) > LONGEST_GUIDE:
            yield f"{page.relative_to(root)} has more than {LONGEST_GUIDE} lines"
        if not FOR_WHOM.match(text):
            yield f"{page.relative_to(root)} does not begin by saying for whom it is ('For ...')"


def main():
    found = list(problems(pathlib.Path(sys.argv[1]).resolve()))
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
