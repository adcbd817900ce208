"""Which kernel to take: the cheapest inside an error, the most exact inside a budget, from the report's data.

usage: choose.py --robot NAME --board NAME [--algorithm NAME] [--error E] [--budget N] [--unit instructions|bytes]
                 [--torque] [--pairs] [--json FILE] [--verify] [--targets] [--data FILE]

--targets prints only what --verify needs: lines of a preset and its targets.
"""

import argparse
import json
import pathlib
import sys

import snippet
import verify

ROOT = pathlib.Path(__file__).resolve().parents[3]
DATA = ROOT / "doc/data/work_precision.json"
RUNNERS_UP = 3


class Refused(Exception):
    """Nothing in the data is what was asked for."""


class Unknown(Exception):
    """A name that the data does not have."""


def refuse_unknown(what, name, known):
    if name not in known:
        raise Unknown(f"unknown {what} '{name}'; there are: {', '.join(sorted(known))}")


def candidates(rows, options):
    """Rows of the job, robot, board and unit."""
    kernels = [row for row in rows if "job" in row]
    refuse_unknown("robot", options.robot, {row["robot"] for row in kernels})
    refuse_unknown("board", options.board, {row["board"] for row in kernels})
    refuse_unknown("algorithm", options.algorithm, {row["job"] for row in kernels if not row["job"].endswith("_of_pairs")})
    job = options.algorithm + ("_of_pairs" if options.pairs else "")
    found = [row for row in kernels if (row["job"], row["robot"]) == (job, options.robot) and row["unit_of_work"] == options.unit]
    here = [row for row in found if row["board"] == options.board]
    if not here:
        boards = sorted({row["board"] for row in found})
        where = f"; it was on: {', '.join(boards)}" if boards else ""
        raise Refused(f"{job.replace('_', ' ')} of {options.robot} was not measured on {options.board}{where}")
    return here


def error_name(options):
    return "error_torque" if options.torque else "error"


def cheapest(rows, error, name="error"):
    """Those inside an error, the cheapest first."""
    inside = sorted((row for row in rows if row[name] <= error), key=lambda row: (row["work"], row[name]))
    if not inside:
        nearest = min(rows, key=lambda row: row[name])
        raise Refused(f"no configuration has an error of at most {error:g}; nearest is {describe(nearest)}")
    return inside


def most_exact(rows, budget, name="error"):
    """Those inside a budget, the most exact first."""
    inside = sorted((row for row in rows if row["work"] <= budget), key=lambda row: (row[name], row["work"]))
    if not inside:
        nearest = min(rows, key=lambda row: row["work"])
        raise Refused(f"no configuration costs at most {budget:g} {nearest['unit_of_work']}; nearest is {describe(nearest)}")
    return inside


def describe(row):
    return f"{row['subject'].replace('_', ' ')}, {row['scalar']}, {row['variant']}: error {row['error']:.1e}, {row['work']} {row['unit_of_work']}"


def table(rows, name):
    header = ["kernel", "numbers", "variant", "error", "RMS", "torque" if name == "error_torque" else "certified", "instructions",
              "cycles", "us", "bytes"]
    number = lambda row, field: f"{row[field]:.1e}" if field in row else ""
    cells = [header] + [[row["subject"], row["scalar"], row["variant"], number(row, "error"), number(row, "error_rms"),
                         number(row, name if name == "error_torque" else "error_certified"), str(row["instructions"]),
                         str(row["cycles"]), f"{row['microseconds']:.1f}", str(row["flash_bytes"] + row["ram_bytes"] + row["stack_bytes"])] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(header))]
    return "\n".join("  " + "  ".join(cell.ljust(width) if i < 3 else cell.rjust(width)
                                      for i, (cell, width) in enumerate(zip(line, widths))).rstrip() for line in cells)


def answer(title, found, name):
    """A title, the choice with its code, the runners-up."""
    best = found[0]
    print(f"{title}: {describe(best)}\n")
    print(f"  #include {snippet.included(best)}")
    print("".join(f"  {line}\n" for line in snippet.lines(best)))
    print(table(found[:1 + RUNNERS_UP], name) + "\n")


def questions(rows, options):
    """[(title, rows from best to worst)]"""
    name, asked = error_name(options), []
    if options.error is not None:
        asked.append((f"cheapest with an error of at most {options.error:g}", cheapest(rows, options.error, name)))
    if options.budget is not None:
        asked.append((f"most exact in at most {options.budget:g} {options.unit}", most_exact(rows, options.budget, name)))
    return asked or [("cheapest; then every one on the Pareto front",
                      sorted((row for row in rows if row["pareto"]), key=lambda row: row["work"]))]


def print_targets(chosen, host):
    for row in chosen:
        of_board, of_host = verify.targets(row)
        print(row["board"], *of_board)
        print(host.name, of_host)


def run(options):
    rows = candidates(json.loads(options.data.read_text(encoding="utf-8")), options)
    asked = questions(rows, options)
    if options.targets:
        print_targets([found[0] for _, found in asked], options.host)
        return
    if options.type:
        rows = [{**row, "type": options.type, "header": options.header} for row in rows]
        asked = questions(rows, options)
    print(f"{options.algorithm.replace('_', ' ')} of {options.type or options.robot} on {options.board}; errors relative to the joint's largest value over "
          f"seeded states, instructions counted by {verify.measure.emulator(options.board)}\n")
    for title, found in asked:
        answer(title, found, error_name(options))
    chosen = [{**found[0], "question": title} for title, found in asked]
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(chosen, indent=1) + "\n", encoding="utf-8")
    if options.verify:
        for row in {json.dumps(snippet.lines(row)): row for row in chosen}.values():
            print("\n".join(verify.check(row, options.host)))


def positive(text):
    value = float(text)
    if not value > 0.0:
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return value


def parse(arguments):
    parser = argparse.ArgumentParser(prog="axial choose", usage="./axial choose --robot NAME --board NAME [options]; see ./axial choose --help", add_help=False)
    parser.add_argument("--robot", required=True)
    parser.add_argument("--board", required=True)
    parser.add_argument("--algorithm", default="inverse_dynamics")
    parser.add_argument("--error", type=positive)
    parser.add_argument("--budget", type=positive)
    parser.add_argument("--unit", choices=("instructions", "microseconds", "bytes"), default="instructions")
    parser.add_argument("--torque", action="store_true")
    parser.add_argument("--pairs", action="store_true")
    parser.add_argument("--json")
    for name in ("--verify", "--targets"):
        parser.add_argument(name, action="store_true")
    parser.add_argument("--host", type=pathlib.Path, default=ROOT / "build/host-release")
    parser.add_argument("--data", type=pathlib.Path, default=DATA)
    parser.add_argument("--type", help="the robot's, where it is not of robots/")
    parser.add_argument("--header")
    options = parser.parse_args(arguments)
    if options.torque and options.algorithm != "forward_dynamics":
        parser.error("--torque is of forward_dynamics: the torque that its error stands for")
    return options


def main(arguments):
    try:
        run(parse(arguments))
    except Unknown as error:
        print(f"axial choose: {error}", file=sys.stderr)
        return 2
    except (Refused, verify.Broken, FileNotFoundError) as error:
        print(f"axial choose: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
