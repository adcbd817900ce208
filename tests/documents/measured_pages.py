#!/usr/bin/python3
"""Every page with measured tables says the commit that they were measured at, that commit is one of this history, and a release measures it.

usage: measured_pages.py ROOT
"""
import pathlib
import re
import subprocess
import sys

TABLE = re.compile(r"<!-- table ([\w-]+) -->")
COMMIT = re.compile(r"[Cc]ommit `?([0-9a-f]{7,40})(?:-dirty)?\b")
OF_OTHERS_FILES = {"doc/measurements/mjcf.md", "doc/measurements/sdf.md"}  # asks copies of other people's repositories, which are not kept here
NOT_MEASURED = {"rules", "not_offered", "boards"}  # written from the sources, which a test holds them to


def pages(root):
    return [root / "README.md", *(page for page in sorted((root / "doc").glob("*/*.md")) if page.name != "README.md")]


def is_measured(text):
    return bool(set(TABLE.findall(text)) - NOT_MEASURED)


def has_history(root):
    """Not in a source archive or a shallow clone."""
    done = subprocess.run(["git", "-C", root, "rev-parse", "--is-shallow-repository"], capture_output=True, text=True, check=False)
    return done.stdout.strip() == "false"


def is_known(root, commit):
    return subprocess.run(["git", "-C", root, "cat-file", "-e", commit + "^{commit}"], capture_output=True, check=False).returncode == 0


def problems(root):
    measured = [page for page in pages(root) if is_measured(page.read_text(encoding="utf-8"))]
    history = has_history(root)
    if len(measured) < 10:
        yield f"only {len(measured)} measured pages were found"
    parts = (root / "cmake/release/parts.txt").read_text(encoding="utf-8")
    for page in measured:
        if str(page.relative_to(root)) not in {*parts.split(), *OF_OTHERS_FILES}:
            yield f"{page.relative_to(root)}: no part of cmake/release/parts.txt measures it"
        commits = COMMIT.findall(page.read_text(encoding="utf-8"))
        if not commits:
            yield f"{page.relative_to(root)}: does not say at which commit it was measured"
        yield from (f"{page.relative_to(root)}: there is no commit {commit}" for commit in commits if history and not is_known(root, commit))


def main():
    found = list(problems(pathlib.Path(sys.argv[1]).resolve()))
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
