#!/usr/bin/python3
"""A board says how much flash and RAM it has three times, to programs, to the linker and to the host: the same each time.

usage: memory_test.py ROOT
"""

import json
import pathlib
import re
import sys

UNIT = {"": 1, "K": 1024, "M": 1024 * 1024}


def of_header(path, root):
    """(flash, RAM) of a board's header, or of one of hal that it includes."""
    text = path.read_text()
    said = re.search(r"flash_bytes = ([\d* ]+), ram_bytes = ([\d* ]+);", text)
    if said:
        return tuple(eval_product(each) for each in said.groups())
    return next(filter(None, (of_header(root / name, root) for name in re.findall(r"#include <(hal/\w+/board\.hpp)>", text))), None)


def eval_product(text):
    product = 1
    for factor in text.split("*"):
        product *= int(factor)
    return product


def of_linker(path):
    lengths = dict((name, int(size) * UNIT[unit]) for name, size, unit in re.findall(r"(FLASH|RAM) .*LENGTH = (\d+)([KM]?)", path.read_text()))
    return lengths["FLASH"], lengths["RAM"]


def of_description(path):
    told = json.loads(path.read_text())
    return told["flash_bytes"], told["ram_bytes"]


def main():
    root, wrong, boards = pathlib.Path(sys.argv[1]), 0, 0
    for folder in sorted(path.parent for path in root.glob("hal/boards/*/board.json")):
        said = {"board.hpp": of_header(folder / "board.hpp", root), "memory.ld": of_linker(folder / "memory.ld"), "board.json": of_description(folder / "board.json")}
        boards += 1
        if len(set(said.values())) != 1:
            wrong += 1
            print(f"{folder.name}: flash and RAM are {said}")
    print(f"{boards} boards, {wrong} wrong")
    return 1 if wrong or not boards else 0


if __name__ == "__main__":
    sys.exit(main())
