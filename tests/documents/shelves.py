#!/usr/bin/python3
"""The documents keep their form: links lead somewhere, guides are short and say for whom they are, shelves list their pages.

usage: shelves.py ROOT
"""
import pathlib
import re
import subprocess
import sys

LINK = re.compile(r"\]\(([^)\s#]*)(?:#([^)]*))?\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
LONGEST_GUIDE, LONGEST_README, LONGEST_CHANGELOG = 120, 110, 80
LONGEST_GLOSSARY = 40  # entries
SOUGHT = re.compile(r"\]\(([^)]+)\) \| `([^`]+)` \|$", re.MULTILINE)
ENTRY = re.compile(r"^\| (?!---|here )", re.MULTILINE)
FOR_WHOM = re.compile(r"^# .*\n\nFor ", re.MULTILINE)


def listed(root, pattern):
    names = subprocess.run(["git", "-C", root, "ls-files", "--cached", "--others", "--exclude-standard", pattern], check=True, capture_output=True, text=True)
    return [root / name for name in names.stdout.splitlines() if (root / name).is_file()]


def broken_links(page):
    for target, anchor in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
        other = page.parent / target if target else page
        if "://" in target:
            continue
        if not other.exists():
            yield target
        elif anchor and other.suffix == ".md" and anchor not in anchors(other):
            yield f"{target}#{anchor}"


def anchors(page):
    """What headings of a page are called in links: lower case, blanks as hyphens, no other signs."""
    for heading in HEADING.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
        yield re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def problems(root):
    for page in listed(root, "*.md"):
        yield from (f"{page.relative_to(root)}: {target} is not there" for target in broken_links(page))
    for shelf in ("guides", "measurements"):
        pages = [page for page in sorted((root / "doc" / shelf).glob("*.md")) if page.name != "README.md"]
        index = (root / "doc" / shelf / "README.md").read_text(encoding="utf-8")
        yield from (f"doc/{shelf}/README.md does not list {page.name}" for page in pages if f"]({page.name})" not in index)
        if shelf == "guides":
            yield from guide_problems(root, pages)
    yield from status_problems(root)
    yield from where_problems(root / "doc/guides/where.md")
    if len(ENTRY.findall((root / "doc/guides/glossary.md").read_text(encoding="utf-8"))) > LONGEST_GLOSSARY:
        yield f"doc/guides/glossary.md has more than {LONGEST_GLOSSARY} entries"
    for name, longest in (("README.md", LONGEST_README), ("CHANGELOG.md", LONGEST_CHANGELOG)):
        lines = len((root / name).read_text(encoding="utf-8").splitlines())
        if lines > longest:
            yield f"{name} has {lines} lines, at most {longest}"


def guide_problems(root, pages):
    for page in pages:
        text = page.read_text(encoding="utf-8")
        if len(text.splitlines()) > LONGEST_GUIDE:
            yield f"{page.relative_to(root)} has more than {LONGEST_GUIDE} lines"
        if not FOR_WHOM.match(text):
            yield f"{page.relative_to(root)} does not begin by saying for whom it is ('For ...')"


def status_problems(root):
    """The page of statuses has every code, by its number."""
    header = (root / "firmware/include/axial/scene/status.hpp").read_text(encoding="utf-8")
    page = (root / "doc/guides/statuses.md").read_text(encoding="utf-8")
    told = {(name, number) for number, name in re.findall(r"^\| (\d+) \| `(\w+)`", page, re.MULTILINE)}
    codes = set(re.findall(r"^    (\w+) =\s+(\d+),", header, re.MULTILINE))
    yield from (f"doc/guides/statuses.md does not tell {name} = {number}" for name, number in sorted(codes - told))
    if len(codes) < 17:
        yield "scene/status.hpp: its codes were not found"


def where_problems(page):
    """What the page tells to look for stands in the file that it names."""
    rows = SOUGHT.findall(page.read_text(encoding="utf-8"))
    if len(rows) < 20:
        yield f"{page.name} answers {len(rows)} questions"
    for file, sought in rows:
        path = page.parent / file
        if path.exists() and sought not in path.read_text(encoding="utf-8"):
            yield f"{page.name}: {sought} is not in {path.name}"


def main():
    found = list(problems(pathlib.Path(sys.argv[1]).resolve()))
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
