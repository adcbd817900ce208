#!/usr/bin/python3
"""What ran where: every board, the emulator that runs it, the tests of each check, what was measured there, silicon."""

import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools/output"))
from document import fill, grouped, load, markdown  # noqa: E402

PAGE = ROOT / "doc" / "measurements" / "boards.md"
MEASURED = ("size", "number_systems", "on_board")  # doc/data/<name>.json; each row names its board
HEADER = ["board", "CPU", "flash, KiB", "RAM, KiB", "runs in", "tests of it", "figures of it", "says its board.json"]


def target_tests():
    """Programs of tests/target by board, from the list that ctest gets."""
    done = subprocess.run(["cmake", f"-DROOT={ROOT}", "-P", pathlib.Path(__file__).with_name("tests.cmake")],
                          capture_output=True, text=True, check=True)
    tests = {}
    for name in done.stderr.split():
        kind, *parts = name.split(".")
        if kind == "target" and len(parts) == 2:
            tests.setdefault(parts[1], []).append(parts[0])
    return tests


def figures():
    """Which data of MEASURED have rows of a board."""
    found = {}
    for name in MEASURED:
        for board in {row["board"] for row in load(ROOT / "doc" / "data" / f"{name}.json")}:
            found.setdefault(board, []).append(name)
    return found


def rows():
    tests, measured = target_tests(), figures()
    for file in sorted((ROOT / "hal" / "boards").glob("*/board.json")):
        board = load(file)
        yield {"board": board["board"], "cpu": board["cpu"], "flash_bytes": board["flash_bytes"], "ram_bytes": board["ram_bytes"],
               "qemu": "qemu" in board,
               "machine": board.get("qemu", board.get("runner", {})).get("machine"), "tests": sorted(tests.get(board["board"], [])),
               "figures": measured.get(board["board"], []), "run": board["run"]}


def runs_in(row):
    if not row["tests"] and not row["figures"]:
        return "nothing: compiles only"
    return f"{'QEMU, ' if row['qemu'] else ''}`{row['machine']}`"


def cells(row):
    return [row["board"], row["cpu"], grouped(row["flash_bytes"] // 1024), grouped(row["ram_bytes"] // 1024), runs_in(row),
            ", ".join(row["tests"]) or "none", ", ".join(row["figures"]) or "none", row["run"]]


def table(all_rows):
    return markdown(HEADER, map(cells, all_rows), words=(0, 1, 4, 5, 6, 7))


def text(all_rows):
    parts = []
    for row in all_rows:
        parts.append(f"{row['board']:12} {row['cpu']:11} {runs_in(row).replace('`', '')}; {row['run']}\n"
                     f"  tests of it: {', '.join(row['tests']) or 'none'}\n"
                     f"  figures in doc/data: {', '.join(row['figures']) or 'none'}\n")
    return "".join(parts)


def claims():
    """Rows of the page by board: as cells() gives them."""
    lines = [line.strip("| ").split(" | ") for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    return {line[0]: line for line in lines if len(line) == len(HEADER) and line[0] not in (HEADER[0], "---")}


def untrue(claim, row):
    """Whether the page says of a board what is not so. Tests and figures that came since are not untrue."""
    now, lists = cells(row), {HEADER.index("tests of it"): row["tests"], HEADER.index("figures of it"): row["figures"]}
    return any(not set(claim[i].split(", ")) <= {*lists[i], "none"} if i in lists else claim[i] != now[i] for i in range(len(HEADER)))


def check(all_rows):
    page, today = claims(), {row["board"]: row for row in all_rows}
    wrong = [name for name in sorted(page.keys() | today.keys())
             if name not in page or name not in today or untrue(page[name], today[name])]
    for name in wrong:
        print(f"axial: {PAGE.relative_to(ROOT)} does not tell of '{name}' as it is; ./axial boards --documents writes its table",
              file=sys.stderr)
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(prog="./axial boards", description=__doc__, allow_abbrev=False)
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="the rows as an array of objects")
    parser.add_argument("--documents", action="store_true", help="writes the table of doc/measurements/boards.md")
    parser.add_argument("--check", action="store_true", help="ends with 1 where that table says what is not so")
    options = parser.parse_args()
    found = list(rows())
    if options.json:
        options.json.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    if options.check:
        return check(found)
    if options.documents:
        fill(PAGE, lambda _: table(found))
    print(text(found), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
