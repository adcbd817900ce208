"""Error against work: joins what was measured, writes work_precision.json, .csv, derivatives.json, pictures and one HTML page.

usage: report.py --errors FOLDER --sizes FILE [--separation FILE] [--more FOLDER] [--robot NAME] [--board NAME]
                 [--output FOLDER] [--json FILE] [--provenance FILE]

--errors: a folder of JSON files of the program `errors`, or work_precision.json of an earlier report. --sizes: JSON of ./axial size. --separation: of ./axial compare. --more: a
folder that may hold simulation.json and stability.json. --provenance: of ./axial size; the page shows it.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys

import kernels
import other_rows
import page

ROOT = pathlib.Path(__file__).resolve().parents[3]
PLOTS = ROOT / "host_sim/figures/plot"


def load(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def all_rows(options):
    chosen = lambda row: all(getattr(options, name) in (None, row[name]) for name in ("robot", "board"))
    rows = kernels.joined(errors_in(options.errors), load(options.sizes))
    if options.separation:
        rows += other_rows.two_rate(load(options.separation))
    rows = [row for row in rows if chosen(row)]
    if options.more:
        rows += other_rows.found(options.more, "simulation.json")
    if not rows:
        raise ValueError("nothing was measured of this robot and board; firmware/apps/size/matrix.txt lists what there is")
    return rows


def errors_in(folder):
    """Of a folder; or, of a report that was written before, the errors that stand there."""
    if pathlib.Path(folder).is_file():
        return [{**row, "variant": row["form"]} for row in load(folder) if row.get("unit_of_work") == "bytes" and "job" in row]
    return [row for file in sorted(pathlib.Path(folder).glob("*.json")) for row in load(file)]


def write_json(path, rows):
    """A line per row."""
    lines = ",\n".join(json.dumps(row) for row in rows)
    pathlib.Path(path).write_text(f"[\n{lines}\n]\n", encoding="utf-8")


def write_csv(path, rows):
    fields = list(dict.fromkeys([*kernels.FIELDS, *(name for row in rows for name in row)]))
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, fields, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def print_table(rows):
    """Instructions, time and bytes beside each other, and what it is on the front of."""
    other = {unit: {page.identity(row): row for row in rows if "job" in row and row["unit_of_work"] == unit} for unit in ("microseconds", "bytes")}
    header = ["board", "robot", "kernel", "numbers", "variant", "error", "RMS", "instructions", "cycles", "us", "bytes", "front"]
    cells = [header]
    for row in (row for row in rows if "job" in row and row["unit_of_work"] == "instructions"):
        quick, small = (of_unit[page.identity(row)] for of_unit in other.values())
        cells.append([row["board"], row["robot"], row["subject"], row["scalar"], row["variant"], f"{row['error']:.1e}", f"{row['error_rms']:.1e}",
                      str(row["work"]), str(row["cycles"]), f"{quick['work']:.1f}", str(small["work"]),
                      "".join(mark for mark, each in (("i", row), ("t", quick), ("b", small)) if each["pareto"])])
    widths = [max(len(line[i]) for line in cells) for i in range(len(header))]
    for line in cells:
        print("  ".join(cell.ljust(width) if i < 5 else cell.rjust(width) for i, (cell, width) in enumerate(zip(line, widths))).rstrip())
    print("errors relative to the joint's largest over seeded states; instructions counted in the boards' emulators, cycles by the core's model (./axial size);\n"
          "bytes: flash, static RAM and stack; front: nothing that does the same job there is as exact and takes as few\n"
          "i: instructions, t: time, b: bytes")


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    for name in ("errors", "sizes"):
        parser.add_argument("--" + name, required=True)
    for name in ("separation", "more", "robot", "board", "json", "provenance"):
        parser.add_argument("--" + name)
    parser.add_argument("--output", default=ROOT / "output/report", type=pathlib.Path)
    return parser.parse_args()


def main():
    options = parse()
    rows = all_rows(options)
    print_table(rows)
    options.output.mkdir(parents=True, exist_ok=True)
    stem = options.output / "work_precision"
    write_json(f"{stem}.json", rows)
    write_csv(f"{stem}.csv", rows)
    if pathlib.Path(options.errors).is_dir():
        write_json(options.output / "derivatives.json", kernels.derivatives(errors_in(options.errors)))
    if options.json:
        write_json(options.json, rows)
    subprocess.run([sys.executable, "-E", PLOTS / "work_precision.py", f"{stem}.json"], check=True)
    stability = other_rows.stability(options.more) if options.more else []
    page.write(f"{stem}.html", rows, stability, sorted(options.output.glob("work_precision*.png")),
               load(options.provenance) if options.provenance else None)
    print(f"written: {stem}.json, .csv, .html and pictures")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, FileNotFoundError) as error:
        sys.exit(f"report: {error}")
