"""Operation counts beside published ones: table, JSON, picture, verdict.

usage: counts.py PROGRAM [--robot NAME] [--output FOLDER] [--json FILE]    PROGRAM writes the rows (main.cpp)
       counts.py PROGRAM --update-pins                                      writes tests/host_sim/figures/operation_counts.json
       counts.py PROGRAM --provenance FILE --cache FILE                     writes commit, compiler and flags besides
Exits 1 when a count model needs more than openSYMORO, the closed form more than published.
"""

import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
PUBLISHED = ROOT / "doc/data/published_counts.json"
PINS = ROOT / "tests/host_sim/figures/operation_counts.json"
KEY = ("robot", "algorithm", "parameters")
OPERATIONS = ("mul", "add", "div", "sincos")


def key(row):
    return tuple(row[name] for name in KEY)


def total(operations):
    """M + A: what rows are compared by; divisions stand apart."""
    return sum(operations)


def ours(row):
    return total((row["mul"], row["add"]))


def load(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def published():
    return {key(row): row for row in load(PUBLISHED)["rows"]}


def run(program, robot):
    done = subprocess.run([program] + (["--robot", robot] if robot else []), stdout=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(done.returncode)
    return json.loads(done.stdout)


def violations(rows, bars):
    """A sentence for each bar that is exceeded."""
    closed = load(PUBLISHED)["closed_form"]
    for row in rows:
        bar = bars.get(key(row), {}).get("open_symoro")
        if bar and ours(row) > total(bar):
            yield f"{' '.join(key(row))}: {ours(row)} operations, openSYMORO has {total(bar)}"
        if row["algorithm"] == "closed_form" and any(row[name] > closed[name] for name in ("mul", "add", "sincos")):
            yield f"{' '.join(key(row))}: more than {closed['mul']}M {closed['add']}A and {closed['sincos']} pair"


def cells(row, bars):
    bar = bars.get(key(row), {})
    against = [str(total(bar[name])) if name in bar else "" for name in ("open_symoro", "reachable")]
    errors = [f"{row[name]:.1e}" if name in row else "" for name in ("error_float", "error_double")]
    return [*key(row), *(str(row[name]) for name in OPERATIONS), str(ours(row)), *against, *errors]


def print_table(rows, bars):
    header = [*KEY, "M", "A", "D", "sincos", "M+A", "openSYMORO", "reachable", "error float", "error double"]
    lines = [header] + [cells(row, bars) for row in rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    for line in lines:
        print("  ".join(cell.rjust(width) if i > 2 else cell.ljust(width)
                        for i, (cell, width) in enumerate(zip(line, widths))).rstrip())


def write_json(path, value):
    pathlib.Path(path).write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")


def write_pins(rows):
    """A line per row, so that a change of the kernels is read line by line."""
    pins = [json.dumps({name: row[name] for name in (*KEY, *OPERATIONS)}) for row in rows]
    PINS.write_text("[\n" + ",\n".join(pins) + "\n]\n", encoding="utf-8")
    print(f"written: {PINS} ({len(pins)} rows)")


def write_provenance(path, cache):
    output = lambda *command: subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\n")[0]
    entries = dict(line.split(":", 1) for line in pathlib.Path(cache).read_text(encoding="utf-8").splitlines() if ":" in line)
    compiler, flags, optimisation = (entries[name].split("=", 1)[1]
                                     for name in ("CMAKE_CXX_COMPILER", "CMAKE_CXX_FLAGS", "AXIAL_ERRORS_OPTIMISATION"))
    write_json(path, {"commit": output(ROOT / "host_sim/tools/system/commit.sh"),
                      "compiler": output(compiler, "--version"), "flags": f"{flags} {optimisation}"})


def write_files(rows, options):
    folder = pathlib.Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    write_json(folder / "counts.json", rows)
    plot = ROOT / "host_sim/figures/plot/counts.py"
    subprocess.run([sys.executable, "-E", plot, PUBLISHED, folder / "counts.json"], check=True)
    print(f"written: {folder}/counts.json, counts.png")


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--robot")
    parser.add_argument("--output", default=ROOT / "output/counts")
    parser.add_argument("--json")
    parser.add_argument("--update-pins", action="store_true")
    parser.add_argument("--provenance")
    parser.add_argument("--cache")
    return parser.parse_args()


def main():
    options = parse()
    rows, bars = run(options.program, options.robot), published()
    if options.update_pins:
        return write_pins(rows)
    print_table(rows, bars)
    if options.json:
        write_json(options.json, rows)
    write_files(rows, options)
    if options.provenance:
        write_provenance(options.provenance, options.cache)
    exceeded = list(violations(rows, bars))
    for sentence in exceeded:
        print(f"counts: {sentence}", file=sys.stderr)
    sys.exit(1 if exceeded else 0)


if __name__ == "__main__":
    main()
