#!/usr/bin/python3
"""Every part of the deep half has passed lately: tests/passed.json, which ./axial test --deep --part K/N --record writes.

usage: passed_parts_test.py ROOT [FILE]
Lately: no part passed before the last release, and none more than 40 merges ago. History is a line, to which what is merged adds 25 commits
or so: 1 000 commits.
"""
import json
import pathlib
import re
import subprocess
import sys

MERGES, COMMITS_OF_A_MERGE = 40, 25
SKIPPED = 77


def git(root, *arguments):
    return subprocess.run(["git", "-C", root, *arguments], capture_output=True, text=True, check=False)


def problems(root, record, parts):
    if record["of"] != parts:
        yield f"parts are {parts} by tests/essence.txt, and {record['of']} in tests/passed.json"
    release = git(root, "describe", "--tags", "--abbrev=0", "--match", "v*").stdout.strip()
    for part in map(str, range(1, parts + 1)):
        commit = record["parts"].get(part)
        since = git(root, "rev-list", "--count", "--first-parent", f"{commit}..HEAD") if commit else None
        if since is None or since.returncode != 0:
            yield f"part {part} has passed at no commit of this history; ./axial test --deep --part {part}/{parts} --record"
        elif int(since.stdout) > MERGES * COMMITS_OF_A_MERGE:
            yield f"part {part} passed {int(since.stdout)} commits ago; ./axial test --deep --part {part}/{parts} --record"
        elif release and git(root, "merge-base", "--is-ancestor", release, commit).returncode != 0:
            yield f"part {part} passed before {release}; ./axial test --deep --part {part}/{parts} --record"


def main(root, record=None):
    root = pathlib.Path(root)
    if git(root, "rev-parse", "--is-shallow-repository").stdout.strip() != "false":
        print("skipped: there is no history here")
        return SKIPPED
    parts = int(re.search(r"^parts: (\d+)$", (root / "tests/essence.txt").read_text(encoding="utf-8"), re.MULTILINE)[1])
    found = list(problems(root, json.loads(pathlib.Path(record or root / "tests/passed.json").read_text(encoding="utf-8")), parts))
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
