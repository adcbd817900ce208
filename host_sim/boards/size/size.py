"""Flash, static RAM, worst-case stack, instructions and cycles of the probes that a build lists.

usage: size.py boards [choice]      prints the chosen boards
       size.py targets [choice]     prints the build's targets of the chosen probes
       size.py measure [choice] [--output FOLDER] [--json FILE]
       size.py budgets FILE         writes budgets from measurements, a little above them
       size.py provenance FILE      writes compiler, flags and commit
       size.py anew FOLDER --board NAME [choice]   measures a board's chosen probes again: their rows and their commit into the data of FOLDER
choice: [--quick] [--robot NAME] [--board NAME] [--scene NAME] [--algorithm NAME] [--scalar NAME]
        [--variant NAME] [--contract NAME]; but for the board each may be a list, separated by commas
"""

import argparse
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import time

import execution
import measure
import stack

ALLOWANCE, STEP = 1.02, {"stack_bytes": 8}  # of a budget over what was measured: a share, at least a step
BUDGETED = ("instructions", "flash_bytes", "stack_bytes")
CHOICES = ("robot", "scene", "algorithm", "scalar", "variant", "contract")
CYCLES = ("cycles_estimated", *measure.timing.FIELDS)  # of rows; the first is cycles by its older name
SHOWN = ("instructions", "cycles", "microseconds", "flash_bytes", "ram_bytes", "stack_bytes")
FIELDS = ("board", "robot", "scene", "algorithm", "scalar", "variant", "contract", "instructions", "instructions_min",
          "instructions_max", *CYCLES, *SHOWN[3:])


def chosen(board, options):
    return [probe for probe in measure.probes(board)
            if (probe.set == "main" or not options.quick)
            and all(getattr(options, name) is None or getattr(probe, name) in getattr(options, name).split(",") for name in CHOICES)]


def figures(work):
    return measure.Figures(*work).row()


def measure_all(work):
    """Rows in the order of the work; a line on standard error now and then."""
    rows, began = [], time.monotonic()
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        for row in pool.map(figures, work):
            rows.append(row)
            if time.monotonic() - began > 10:
                began = time.monotonic()
                print(f"measuring: {len(rows)} of {len(work)}", file=sys.stderr, flush=True)
    return rows


def boards_of(options):
    known = measure.boards()
    if options.board not in (None, *known):
        raise ValueError(f"unknown board '{options.board}'; there are: {', '.join(known)}")
    return [options.board] if options.board else known


def work_of(options):
    return [(board, probe) for board in boards_of(options) for probe in chosen(board, options)]


def some_work_of(options):
    work = work_of(options)
    if not work:
        raise ValueError("no probe is called so; firmware/apps/size/matrix.txt lists what there is")
    return work


def print_table(rows):
    header = ["board", "robot", "scene", "algorithm", "scalar", "variant", "contract", *SHOWN]
    print_columns([header] + [[str(row[name]) for name in header] for row in rows], 7)


def print_columns(cells, words):
    """The first columns are words, the others numbers, aligned to the right."""
    widths = [max(len(line[i]) for line in cells) for i in range(len(cells[0]))]
    for line in cells:
        print("  ".join(cell.rjust(width) if i >= words else cell.ljust(width)
                        for i, (cell, width) in enumerate(zip(line, widths))).rstrip())


def print_cores(boards):
    """What cycles and microseconds are, board by board."""
    for board in boards:
        model = measure.timing.Model(measure.description(board))
        print(f"cycles on {board}: {model.core.kind} ({model.core.says}); {model.clock_Hz / 1e6:g} MHz")


def write_json(path, value):
    pathlib.Path(path).write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")


def run_measure(options):
    rows = measure_all(some_work_of(options))
    print_table(rows)
    print_cores(dict.fromkeys(row["board"] for row in rows))
    if options.json:
        write_json(options.json, rows)
    folder = pathlib.Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    write_json(folder / "size.json", rows)
    write_csv(folder / "size.csv", rows)
    plot = measure.ROOT / "host_sim/figures/plot/size.py"
    subprocess.run([sys.executable, "-E", plot, folder / "size.json"], check=True)
    print(f"written: {folder}/size.json, size.csv" + ", size.png" * (folder / "size.png").exists())


def run_boards(options):
    print(*boards_of(options))


def run_targets(options):
    print(*("size-" + probe.name for _, probe in work_of(options)))


def run_provenance(options):
    write_json(options.file, provenance({board: cached(board, "CMAKE_CXX_FLAGS") for board in boards_of(options)}))


def cached(board, name):
    """A variable of a board's build."""
    cache = (measure.IMAGES / board / "CMakeCache.txt").read_text(encoding="utf-8").splitlines()
    return next(line.partition("=")[2] for line in cache if line.startswith(name + ":"))


def provenance(flags):
    """What the rows depend on: the compilers, the flags of each board, the commit."""
    output = lambda *command: subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\n")[0]
    compilers = sorted({output(cached(board, "AXIAL_TOOLS") + "g++", "--version") for board in flags})
    return {"commit": output(measure.ROOT / "host_sim/tools/system/commit.sh"), "compiler": ", ".join(compilers), "flags": flags}


def run_budgets(options):
    work = some_work_of(options)
    budgets = {f"{board}/{probe.name}": {name: max(math.ceil(row[name] * ALLOWANCE), row[name] + STEP.get(name, 1)) for name in BUDGETED}
               for (board, probe), row in zip(work, measure_all(work))}
    write_json(options.file, budgets)
    print(f"written: {options.file} ({len(budgets)} budgets)")


def measured(row):
    """Which probe a row is of."""
    return tuple(row[name] for name in ("board", *CHOICES))


def merged(known, rows):
    """Rows by boards, with those that were measured now for those that were known."""
    now = {measured(row) for row in rows}
    return sorted([row for row in known if measured(row) not in now] + rows, key=lambda row: row["board"])


def anew(known, board, choice, commit):
    """Which commits rows are of that are not of the whole data's: of a board, or of those of its probes that were chosen."""
    own = ", ".join([board, *choice])
    return {**{key: value for key, value in known.items() if choice or not key.startswith(board + ",")}, own: commit}


def run_anew(options):
    """The other rows stay, with the commit that they have."""
    folder = pathlib.Path(options.file)
    file, made = folder / "size.json", folder / "size_provenance.json"
    choice = [getattr(options, name).replace(",", ", ") for name in CHOICES if getattr(options, name)]
    known = [row for row in json.loads(file.read_text(encoding="utf-8")) if choice or row["board"] != options.board]
    rows = merged(known, measure_all(some_work_of(options)))
    write_json(file, rows)
    write_csv(folder / "size.csv", rows)
    own = provenance({options.board: cached(options.board, "CMAKE_CXX_FLAGS")})
    known = json.loads(made.read_text(encoding="utf-8"))
    flags = {**known["flags"], **own["flags"]}
    write_json(made, {**known, "flags": dict(sorted(flags.items())),
                      "anew": anew(known.get("anew", {}), options.board, choice, own["commit"])})
    print(f"written: {options.board} into {file}")


def write_csv(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def parse(arguments):
    parser = argparse.ArgumentParser(usage=__doc__)
    verbs = parser.add_subparsers(dest="verb", required=True)
    for run in (run_boards, run_targets, run_measure, run_budgets, run_provenance, run_anew):
        verb = run.__name__.removeprefix("run_")
        sub = verbs.add_parser(verb)
        sub.set_defaults(run=run)
        sub.add_argument("--quick", action="store_true")
        for name in ("board", *CHOICES):
            sub.add_argument("--" + name)
        sub.add_argument("--json")
        sub.add_argument("--output", default=measure.ROOT / "output/size")
        if verb in ("budgets", "provenance", "anew"):
            sub.add_argument("file")
    return parser.parse_args(arguments)


def main():
    options = parse(sys.argv[1:])
    try:
        options.run(options)
    except (ValueError, FileNotFoundError, stack.Unbounded, execution.Mismatch) as error:
        sys.exit(f"size: {error}")


if __name__ == "__main__":
    main()
