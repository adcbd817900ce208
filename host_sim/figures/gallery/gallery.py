"""What every robot costs on every board: robots, boards and number systems as cells, each measured once.

usage: gallery.py cells [choice] [--lane K/N]            a line for each cell that is to be measured: place, number, header; those of lane K,
                                                         where N measure at once: what is built for one place is never in two lanes
       gallery.py targets BOARD NUMBER                   the build's targets of a cell
       gallery.py measure BOARD NUMBER HEADER TYPE       of the images that are built
       gallery.py errors NUMBER HEADER PROGRAM           PROGRAM: errors-own_gallery-<number> of the host
       gallery.py failed NUMBER HEADER LOG               that program cannot be: the build's log says why
       gallery.py show [choice] [--json FILE] [--html FILE]
       gallery.py documents FOLDER                       rows, and what they were made with, as FOLDER/gallery*.json
choice: [--robot NAME|HEADER,...] [--board NAME,...] [--number NAME,...]
"""

import argparse
import collections
import json
import pathlib
import subprocess
import sys

import page
from catalogue import BOARDS, HOST, NUMBERS, PLACES, ROOT, Cell, cells, chosen, of_header
from store import Store, keep

sys.path += [str(ROOT / "host_sim/boards/cost"), str(ROOT / "host_sim/boards/size")]
import cost  # noqa: E402
import measure  # noqa: E402
import refused  # noqa: E402
import size  # noqa: E402

ALGORITHMS = ("inverse_dynamics", "gravity", "forward_dynamics", cost.SAFE_LOOP)
JUDGED = ALGORITHMS[:-1]  # whose errors are computed: the safe loop's are those of the torque
FIGURES = ("instructions", "cycles", "cycles_kind", "cycles_low", "cycles_high", "microseconds", "flash_bytes", "ram_bytes", "stack_bytes")
NOT_YET = "not measured yet"


def cell_of(options):
    return Cell(of_header(options.header), options.number, getattr(options, "board", HOST))


def probes(board, number):
    """Those of ./axial cost that the gallery shows."""
    return [probe for probe in cost.probes(board, number) if probe.algorithm in ALGORITHMS]


def row_of(cell, algorithm, **others):
    return {"robot": cell.robot.name, "board": cell.place, "number": cell.number, "algorithm": algorithm, **others}


def measured(cell, probe):
    """A probe's figures as a row, or why there are none."""
    why = measure.refusal_of(cell.place, probe)
    found = why or cost.figures((cell.place, probe))
    return {"why": found.replace("axial: ", "")} if isinstance(found, str) else {name: found[name] for name in FIGURES if name in found}


def run_cells(options):
    store = Store()
    lane, lanes = map(int, options.lane.split("/"))
    for cell in choice(options):
        if PLACES.index(cell.place) % lanes == lane and not store.is_current(cell):
            print(cell.place, cell.number, ROOT / cell.robot.header)


def run_targets(options):
    found = probes(options.board, options.number)
    print(*(f"size-{name}" for name in [*(probe.name for probe in found), found[0].empty]))


def run_measure(options):
    cell = cell_of(options)
    keep(cell, [row_of(cell, probe.algorithm, type=options.type, header=cell.robot.header, **measured(cell, probe))
                for probe in probes(options.board, options.number)])


def run_errors(options):
    cell = cell_of(options)
    found = json.loads(subprocess.run([options.program], check=True, capture_output=True, text=True).stdout)
    names = ("joints", "error", "error_torque", "error_certified")
    keep(cell, [row_of(cell, row["algorithm"], **{name: row[name] for name in names if name in row}) for row in found])


def run_failed(options):
    cell = cell_of(options)
    said = refused.sentences(pathlib.Path(options.log).read_text(encoding="utf-8", errors="replace"))
    keep(cell, [row_of(cell, algorithm, why=next(iter(said), "no program that computes its errors was built").replace("axial: ", "")) for algorithm in JUDGED])


def choice(options):
    words = lambda given, known: given.split(",") if given else known
    return cells(chosen(words(options.robot, [])), words(options.number, NUMBERS), words(options.board, BOARDS))


def shown_rows(options, store):
    """Every chosen cell's; a cell that was not measured yet says so."""
    rows = []
    for cell in choice(options):
        if cell.place != HOST:
            rows += store.joined(cell) or [row_of(cell, algorithm, header=cell.robot.header, why=NOT_YET) for algorithm in ALGORITHMS]
    return rows


def print_table(rows):
    header = ["robot", "board", "number", "algorithm", "instructions", "cycles", "us", "flash", "stack", "error"]
    names = ("instructions", "cycles", "microseconds", "flash_bytes", "stack_bytes", "error")
    shown = lambda value: f"{value:.1e}" if isinstance(value, float) and value < 0.01 else "" if value is None else f"{value:.1f}" if isinstance(value, float) else str(value)
    size.print_columns([header, *([row[name] for name in header[:4]] + [shown(row.get(name)) for name in names] for row in rows if "why" not in row)], 4)
    for (why, *cell), algorithms in sorted(refusals(rows).items()):
        print(f"{', '.join(cell)}: {', '.join(algorithms)}: {why}")


def refusals(rows):
    """{(why, robot, number, board): algorithms}"""
    found = collections.defaultdict(list)
    for row in rows:
        if "why" in row:
            found[row["why"], row["robot"], row["number"], row["board"]].append(row["algorithm"])
    return found


def run_show(options):
    rows = shown_rows(options, Store())
    print_table(rows)
    if options.json:
        size.write_json(options.json, rows)
    if options.html:
        page.write(options.html, rows, chosen([]), made(rows))


def made(rows):
    """What the rows were made with. Boards that were never configured here keep what was known of them."""
    known = ROOT / "doc/data/gallery_provenance.json"
    before = json.loads(known.read_text(encoding="utf-8")) if known.is_file() else {"flags": {}, "compiler": ""}
    boards = [board for board in dict.fromkeys(row["board"] for row in rows) if (measure.IMAGES / board / "CMakeCache.txt").is_file()]
    now = size.provenance({board: size.cached(board, "CMAKE_CXX_FLAGS") for board in boards})
    commits = collections.Counter(row["commit"] for row in rows if "commit" in row)
    models = {board: cost.model_of(board) for board in BOARDS}
    return {"commits": dict(commits.most_common()), "compiler": now["compiler"] or before["compiler"], "flags": {**before["flags"], **now["flags"]},
            "models": models, "emulators": {board: measure.emulator(board) for board in BOARDS}}


def run_documents(options):
    """One row a line: what changes is seen in a difference."""
    rows = shown_rows(argparse.Namespace(robot=None, board=None, number=None), Store())
    if all("why" in row for row in rows):
        sys.exit("axial gallery: no cell is measured yet")
    folder = pathlib.Path(options.folder)
    lines = ",\n".join(" " + json.dumps(row) for row in rows)
    (folder / "gallery.json").write_text(f"[\n{lines}\n]\n", encoding="utf-8")
    size.write_json(folder / "gallery_provenance.json", made(rows))


ARGUMENTS = {"cells": "", "targets": "board number", "measure": "board number header type", "errors": "number header program",
             "failed": "number header log", "show": "", "documents": "folder"}


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    subs = parser.add_subparsers(dest="action", required=True)
    for action, names in ARGUMENTS.items():
        sub = subs.add_parser(action)
        for name in names.split() or ["--robot", "--board", "--number", "--json", "--html"]:
            sub.add_argument(name)
        if action == "cells":
            sub.add_argument("--lane", default="0/1")
    return parser.parse_args()


if __name__ == "__main__":
    asked = parse()
    globals()["run_" + asked.action](asked)
