"""Mutants against the essence of the tests alone (tests/essence.txt)."""

import dataclasses
import fnmatch
import pathlib
import random
import re

import table

SHARE = 0.85  # of a sample, at least, are killed


def programs():
    """{source below tests/: programs of tests that have it}, read from the folders' CMakeLists.txt."""
    found = {}
    for path in sorted((table.ROOT / "tests").glob("*/CMakeLists.txt")):
        for name, rest in re.findall(r"axial_add_test\((\w+)([^()]*)\)", path.read_text()):
            for source in re.findall(r"[\w/]+\.cpp", rest):
                found.setdefault(f"{path.parent.name}/{source}", []).append(f"{path.parent.name}.{name}")
    return found


def patterns():
    """Names without what half they are of."""
    lines = [line.split("#")[0].strip() for line in (table.ROOT / "tests/essence.txt").read_text().splitlines()]
    return [re.sub("^(un)?sanitized/", "", line) for line in lines if line]


def is_essential(test, owners, wanted):
    """A program in parts is in the essence if a part of it is."""
    names = owners.get(test, [])
    if test.startswith("compile_fail/"):
        names = ["compile_fail." + pathlib.Path(test).stem]
    return any(fnmatch.fnmatchcase(name + part, pattern) for name in names for part in ("", "_1") for pattern in wanted)


def sample(mutants, count, seed):
    """That many of them, drawn; each with a test of the essence: its own, or one that kills another mutant of the same file, or none."""
    owners, wanted = programs(), patterns()
    others = {}
    for mutant in mutants:
        if is_essential(mutant.test, owners, wanted):
            others.setdefault(mutant.file, mutant.test)
    chosen = random.Random(seed).sample(mutants, min(count, len(mutants)))
    return [mutant if is_essential(mutant.test, owners, wanted) else
            dataclasses.replace(mutant, test=others.get(mutant.file, ""), filter="", by_compiler=False) for mutant in chosen]
