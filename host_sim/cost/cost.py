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
import size  # noqa: E402
import stack  # noqa: E402

SAFE_LOOP = "feedforward"
ROUTE = "forward_dynamics_"
MODEL = ("cycles are an estimate: one per instruction; loads and stores 1 and 1 per word; divisions and square roots {divide}; fused multiply-adds "
         "{fused}; no wait states, stalls or interrupts. Never measured on silicon.")
# What the cores' manuals say otherwise.
KNOWN_WRONG = {
    "cortex-m0": "A taken branch takes 3, a call 4: soft float costs more than is said here.",
    "cortex-m3": "Long multiplications take 3 to 7 and are counted 1: fixed point costs a quarter to a half more than is said here; "
                 "divisions take 2 to 12.",
    "cortex-m4f": "Loads one after the other take less than is said here, taken branches more.",
    "rv32imac": "A model of no core in particular: a three-stage core takes 5 to 19 % less.",
}
NO_TIMES = "No timing of this core is published: the model is the Cortex-M4F's."


def probes(board, number):
    """Bare and unrolled, by the default route; the safe loop is the last."""
    found = [probe for probe in measure.own_probes(board)
             if (probe.scalar, probe.variant) == (number, "unrolled") and not probe.algorithm.startswith(ROUTE)]
    return sorted(found, key=lambda probe: probe.algorithm == SAFE_LOOP)


def targets(options):
    found = probes(options.board, options.number)
    print(*(f"size-{name}" for name in [*(probe.name for probe in found), found[0].empty]))


def figures(work):
    """A row, or why there is none."""
    try:
        return measure.Figures(*work).row()
    except FileNotFoundError:
        return "not built: it does not compile or does not fit the board"
    except (execution.Mismatch, stack.Unbounded) as error:
        return str(error)


def cpu_of(board):
    return measure.description(board)["cpu"]


def model_of(board):
    cpu = cpu_of(board)
    text = MODEL.format(divide=size.measure.cycles.CYCLES_OF_DIVIDE.get(cpu, 14), fused=size.measure.cycles.CYCLES_OF_FUSED.get(cpu, 3))
    return f"{text} {KNOWN_WRONG.get(cpu, NO_TIMES)}"


def complete(row, name):
    return {**row, "robot": name, "core": cpu_of(row["board"]), "cycles": row["cycles_estimated"], "cycles_kind": "estimate",
            "cycles_model": model_of(row["board"]), "instructions_by": "QEMU", "flags": "ours"}


def shown(row):
    low = row.get("instructions_min", row["instructions"])
    count = f"{low} to {row['instructions']}" if low != row["instructions"] else str(low)
    algorithm = "safe loop" if row["algorithm"] == SAFE_LOOP else row["algorithm"].replace("_", " ")
    return [algorithm, count, *(str(row[field]) for field in ("cycles_estimated", "flash_bytes", "ram_bytes", "stack_bytes"))]


def print_table(options, rows):
    print(f"{options.name} on {options.board} ({cpu_of(options.board)}), {options.number}, flags of hal/toolchains:\n")
    size.print_columns([["kernel", "instructions", "cycles (estimate)", "flash", "RAM", "stack"], *map(shown, rows)], 1)
    print(f"\nInstructions were executed in QEMU over 8 states and are not cycles; {model_of(options.board)}\n"
          "Flash and RAM in bytes, beside an image without the kernel; kernels share code, so an image with several takes less than their sum.\n"
          f"The safe loop is axial::{SAFE_LOOP}.")


def run_measure(options):
    work = [(options.board, probe) for probe in probes(options.board, options.number)]
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
