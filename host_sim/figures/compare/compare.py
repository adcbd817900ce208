"""The ways to a torque beside each other: operations, instructions, errors; and what a slow refresh costs.

usage: compare.py ERRORS COUNTS SIZES [--output FOLDER] [--json FILE] [--provenance FILE]

ERRORS, COUNTS: JSON of the programs `compare` and `counts`. SIZES: a folder of JSON files of ./axial size.
Writes separation.json and a picture.
"""

import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
BOARDS = ("stm32f405", "nrf51")
# method: what is computed once per q, what for every torque.
METHODS = {"newton_euler": ((), ("inverse_dynamics",)), "separation": (("separation",), ("separated_torque",)),
           "closed_form": ((), ("closed_form",))}


def load(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


class Costs:
    """Operations (M + A + D) and instructions of every algorithm."""

    def __init__(self, counts, sizes):
        self.operations = {(row["robot"], row["algorithm"]): row for row in counts
                           if row["parameters"] == "base"}
        self.instructions = {(row["robot"], row["algorithm"], row["board"]): row["instructions"] for row in sizes
                             if (row["scene"], row["scalar"], row["variant"], row["contract"]) == ("bare", "float", "unrolled", "off")}

    def of(self, robot, algorithms, unit):
        """None where an algorithm was not measured."""
        values = [self._one(robot, algorithm, unit) for algorithm in algorithms]
        return None if None in values else sum(values)

    def _one(self, robot, algorithm, unit):
        if unit != "operations":
            return self.instructions.get((robot, algorithm, unit))
        row = self.operations.get((robot, algorithm))
        return row and row["mul"] + row["add"] + row["div"]


def break_even(costs, robot, unit):
    """Torques per q from which separating is cheaper than Newton-Euler every time; None: never, or not measured."""
    once, each = (costs.of(robot, part, unit) for part in METHODS["separation"])
    every_time = costs.of(robot, ("inverse_dynamics",), unit)
    if None in (once, each, every_time) or each >= every_time:
        return None
    return -(-once // (every_time - each))


def method_row(costs, errors, robot, method):
    once, each = METHODS[method]
    row = {"robot": robot, "method": method}
    for unit in ("operations", *BOARDS):
        row[f"{unit}_once"], row[f"{unit}_each"] = costs.of(robot, once, unit), costs.of(robot, each, unit)
        if method == "separation":
            row[f"{unit}_break_even"] = break_even(costs, robot, unit)
    for error in errors:
        if (error["robot"], error["method"]) == (robot, method):
            row[f"error_{error['scalar']}"] = error["error"]
    return row


def two_rate_row(costs, error):
    """With the load of a tick: its fast torque and the refresh shared out over the ticks, the tick that refreshes, and what the full
    rate costs."""
    row = dict(error)
    for board in BOARDS:
        once, each = (costs.of(error["robot"], part, board) for part in METHODS["separation"])
        known = None not in (once, each)
        row[f"{board}_per_tick"] = round(each + once / error["ticks"]) if known else None
        row[f"{board}_worst_tick"] = each + once if known else None
        row[f"{board}_full_rate"] = costs.of(error["robot"], ("inverse_dynamics",), board)
    return row


def compared(errors, counts, sizes):
    costs = Costs(counts, sizes)
    robots = list(dict.fromkeys(row["robot"] for row in errors["methods"]))
    generic = sorted({row["robot"] for row in counts if row["robot"].startswith("model_")})
    methods = [method_row(costs, errors["methods"], robot, method) for robot in robots + generic for method in METHODS
               if costs.of(robot, METHODS[method][1], "operations") is not None]
    return {"methods": methods, "two_rate": [two_rate_row(costs, error) for error in errors["two_rate"]]}


def cell(value):
    if value is None:
        return ""
    return f"{value:.1e}" if isinstance(value, float) else str(value)


def print_table(rows):
    header = list(dict.fromkeys(name for row in rows for name in row))
    lines = [header] + [[cell(row.get(name)) for name in header] for row in rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    for line in lines:
        print("  ".join(text.ljust(width) if i < 2 else text.rjust(width)
                        for i, (text, width) in enumerate(zip(line, widths))).rstrip())


def write_json(path, value):
    pathlib.Path(path).write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    for name in ("errors", "counts", "sizes"):
        parser.add_argument(name)
    parser.add_argument("--output", default=ROOT / "output/separation")
    parser.add_argument("--json")
    parser.add_argument("--provenance")
    return parser.parse_args()


def main():
    options = parse()
    sizes = [row for file in sorted(pathlib.Path(options.sizes).glob("*.json")) for row in load(file)]
    result = compared(load(options.errors), load(options.counts), sizes)
    print_table(result["methods"])
    print()
    print_table(result["two_rate"])
    folder = pathlib.Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    write_json(folder / "separation.json", result)
    if options.json:
        write_json(options.json, [{"subject": "method", **row} for row in result["methods"]] +
                   [{"subject": "two_rate", **row} for row in result["two_rate"]])
    if options.provenance:
        commit = subprocess.run([ROOT / "host_sim/tools/system/commit.sh"], check=True, capture_output=True, text=True)
        write_json(options.provenance, {"commit": commit.stdout.strip()})
    subprocess.run([sys.executable, "-E", ROOT / "host_sim/figures/plot/separation.py", folder / "separation.json"], check=True)
    print(f"written: {folder}/separation.json, separation.png")


if __name__ == "__main__":
    main()
