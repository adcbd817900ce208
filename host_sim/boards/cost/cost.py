"""What a user's robot costs on a board: a row for each kernel and for the safe loop.

usage: cost.py targets BOARD NUMBER                               the build's targets
       cost.py measure BOARD NUMBER --name NAME [--json FILE]     NAME: what the robot is called in the table
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "size"))
import execution  # noqa: E402
import measure  # noqa: E402
import routes  # noqa: E402
import size  # noqa: E402
import stack  # noqa: E402

SAFE_LOOP = "feedforward"


def probes(board, number):
    """Bare and unrolled, by the default route; the safe loop is the last."""
    found = [probe for probe in measure.own_probes(board)
             if (probe.scalar, probe.variant) == (number, "unrolled") and not routes.route_of(probe.algorithm)]
    return sorted(found, key=lambda probe: probe.algorithm == SAFE_LOOP)


def targets(options):
    found = probes(options.board, options.number)
    print(*(f"size-{name}" for name in [*(probe.name for probe in found), found[0].empty]))


def figures(work):
    """A row, or why there is none."""
    try:
        return measure.Figures(*work).row()
    except FileNotFoundError:
        return f"not built: {measure.why_not_built(*work)}"
    except (execution.Mismatch, stack.Unbounded) as error:
        return str(error)


def cpu_of(board):
    return measure.description(board)["cpu"]


def model_of(board):
    core = measure.timing.Model(measure.description(board)).core
    return f"Cycles: {core.kind} ({core.says}); no interrupts. Never measured on silicon."


def complete(row, name):
    return {**row, "robot": name, "cycles_model": model_of(row["board"]), "instructions_by": measure.emulator(row["board"]), "flags": "ours"}


def span(low, high):
    return str(high) if low == high else f"{low} to {high}"


def shown(row):
    algorithm = "safe loop" if row["algorithm"] == SAFE_LOOP else row["algorithm"].replace("_", " ")
    interval = span(row["cycles_low"], row["cycles_high"]) if "cycles_low" in row else ""
    return [algorithm, span(row.get("instructions_min", row["instructions"]), row["instructions"]),
            str(row["cycles"]), interval, f"{row['microseconds']:.1f}",
            *(str(row[field]) for field in ("flash_bytes", "ram_bytes", "stack_bytes"))]


def print_table(options, rows):
    model = measure.timing.Model(measure.description(options.board))
    print(f"{options.name} on {options.board} ({cpu_of(options.board)}), {options.number}, flags of hal/toolchains:\n")
    size.print_columns([["kernel", "instructions", f"cycles ({model.core.kind})", "from, to", f"us at {model.clock_Hz / 1e6:g} MHz", "flash", "RAM", "stack"],
                        *map(shown, rows)], 1)
    print(f"\nInstructions were executed in {measure.emulator(options.board)} over 8 states and are not cycles. {model_of(options.board)}\n"
          "Flash and RAM in bytes, beside an image without the kernel; kernels share code, so an image with several takes less than their sum.\n"
          f"The safe loop is axial::{SAFE_LOOP}.")


def print_refusals(options, found):
    """What the library does not offer for the robot's joints is no failure."""
    offered = []
    for probe in found:
        why = measure.refusal_of(options.board, probe)
        if why:
            print(f"cost: {probe.algorithm} in {options.number} is not offered: {why}", file=sys.stderr)
        else:
            offered.append(probe)
    return offered


def run_measure(options):
    work = [(options.board, probe) for probe in print_refusals(options, probes(options.board, options.number))]
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(figures, work))
    rows = [complete(row, options.name) for row in found if isinstance(row, dict)]
    if rows:
        print_table(options, rows)
    if options.json:
        size.write_json(options.json, rows)
    missing = [(probe.algorithm, why) for (_, probe), why in zip(work, found) if isinstance(why, str)]
    for algorithm, why in missing:
        print(f"cost: {algorithm} in {options.number}: {why}", file=sys.stderr)
    sys.exit(1 if missing else 0)


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    subs = parser.add_subparsers(dest="action", required=True)
    for name in ("targets", "measure"):
        sub = subs.add_parser(name)
        sub.add_argument("board")
        sub.add_argument("number")
    sub.add_argument("--name", required=True)
    sub.add_argument("--json")
    return parser.parse_args()


if __name__ == "__main__":
    chosen = parse()
    {"targets": targets, "measure": run_measure}[chosen.action](chosen)
