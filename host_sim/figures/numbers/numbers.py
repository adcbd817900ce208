"""Number systems beside each other: errors on the host, costs on the boards; table, CSV, JSON, picture.

usage: numbers.py ERRORS SIZES [--output FOLDER] [--json FILE] [--provenance FILE --cache FILE]

ERRORS, SIZES: folders of JSON files of the program `errors` and of ./axial size. Writes number_systems.json, .csv and a picture of
the kernels that have every number system; with --provenance the commit, and the compilers and flags of the boards and of the
host, whose are in CACHE.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/boards/size"))
import size  # noqa: E402

KEY = ("robot", "algorithm", "scalar")
SYSTEMS = ("fixed16", "fixed32_down", "fixed32", "fixed32_high", "float", "double")
BOARDS = ("nrf51", "rv32_virt", "stm32f100", "stm32f405")
ERRORS = ("error", "error_rms", "error_certified")
COSTS = ("instructions", "instructions_min", *size.CYCLES, "flash_bytes", "ram_bytes", "stack_bytes")
FIELDS = (*KEY, "board", "states", *ERRORS, *COSTS)


def load(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def key(row):
    return tuple(row[name] for name in KEY)


def plain(row):
    return (row["scene"], row["variant"], row.get("contract", "off")) == ("bare", "unrolled", "off")


def in_every_system(errors):
    """The bare, unrolled kernels that have all, one after another."""
    found = {}
    for row in filter(plain, errors):
        found.setdefault((row["algorithm"], row["robot"]), {})[row["scalar"]] = row
    robots = list(dict.fromkeys(row["robot"] for row in errors))
    order = sorted(found, key=lambda kernel: (robots.index(kernel[1]), kernel[0] != "inverse_dynamics"))
    return [found[kernel][system] for kernel in order if set(SYSTEMS) <= set(found[kernel]) for system in SYSTEMS]


def joined(errors, sizes):
    """A row per robot, algorithm, number system and board."""
    rows = []
    for error in in_every_system(errors):
        costs = {row["board"]: row for row in sizes if key(row) == key(error) and plain(row)}
        missing = [board for board in BOARDS if board not in costs]
        if missing:
            raise ValueError(f"{' '.join(key(error))} was not measured on {', '.join(missing)}")
        for board in BOARDS:
            both = {**error, **costs[board]}
            rows.append({name: both[name] for name in FIELDS if name in both})
    return rows


def cell(value):
    return f"{value:.2e}" if isinstance(value, float) else str(value)


def write_csv(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def write_provenance(path, cache, boards):
    entries = dict(line.split(":", 1) for line in pathlib.Path(cache).read_text(encoding="utf-8").splitlines() if ":" in line)
    compiler, flags, optimisation = (entries[name].split("=", 1)[1]
                                     for name in ("CMAKE_CXX_COMPILER", "CMAKE_CXX_FLAGS", "AXIAL_ERRORS_OPTIMISATION"))
    version = subprocess.run([compiler, "--version"], check=True, capture_output=True, text=True).stdout.split("\n")[0]
    made = size.provenance({board: size.cached(board, "CMAKE_CXX_FLAGS") for board in boards})
    size.write_json(path, {**made, "host_compiler": version, "host_flags": f"{flags} {optimisation}"})


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    for name in ("errors", "sizes"):
        parser.add_argument(name)
    parser.add_argument("--output", default=ROOT / "output/numbers")
    for name in ("--json", "--provenance", "--cache"):
        parser.add_argument(name)
    return parser.parse_args()


def main():
    options = parse()
    rows = joined(*([row for file in sorted(pathlib.Path(folder).glob("*.json")) for row in load(file)]
                    for folder in (options.errors, options.sizes)))
    shown = [name for name in FIELDS if name not in ("states", "instructions_min", "ram_bytes")]
    size.print_columns([shown] + [[cell(row.get(name, "")) for name in shown] for row in rows], len(KEY) + 1)
    folder = pathlib.Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    size.write_json(folder / "number_systems.json", rows)
    write_csv(folder / "number_systems.csv", rows)
    if options.json:
        size.write_json(options.json, rows)
    if options.provenance:
        write_provenance(options.provenance, options.cache, dict.fromkeys(row["board"] for row in rows))
    plot = ROOT / "host_sim/figures/plot/number_systems.py"
    subprocess.run([sys.executable, "-E", plot, folder / "number_systems.json"], check=True)
    print(f"written: {folder}/number_systems.json, number_systems.csv, number_systems.png")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, FileNotFoundError) as error:
        sys.exit(f"numbers: {error}")
