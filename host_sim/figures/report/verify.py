"""Builds and runs a chosen kernel: its lines compile, and its error and cost are those that were promised."""

import json
import pathlib
import subprocess
import sys
import tempfile

import snippet

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/boards/size"))
import measure  # noqa: E402

COSTS = ("instructions", "cycles", "flash_bytes", "ram_bytes", "stack_bytes")
ERRORS = ("error", "error_rms", "error_torque", "error_certified")
LAST_BITS = 1e-12  # of an error's share that another compiler may sum in another order


class Broken(Exception):
    """A promise that does not hold."""


def probe_of(row):
    return measure.Probe("more", row["robot"], row["scene"], row["algorithm"], row["form"], "off", row["scalar"])


def targets(row):
    """What must be built: (board's targets, host's target)."""
    probe = probe_of(row)
    return [f"size-{probe.name}", f"size-{probe.empty}"], f"errors-{row['robot']}-{row['scalar']}"


def compile_lines(rows, compiler="g++"):
    """The lines of every row."""
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        source = pathlib.Path(folder) / "chosen.cpp"
        source.write_text(snippet.program(rows), encoding="utf-8")
        done = subprocess.run([compiler, "-std=c++17", "-fsyntax-only", f"-I{ROOT}/firmware/include", f"-I{ROOT}", source],
                              capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Broken(f"the lines do not compile: {done.stderr[:2000]}")


def errors_of(row, host):
    program = host / "host_sim/figures/errors" / targets(row)[1]
    if not program.exists():
        raise FileNotFoundError(f"{program}: build it first (./axial choose --verify does)")
    output = subprocess.run([program, "--algorithm", row["algorithm"]], check=True, capture_output=True, text=True).stdout
    found = [each for each in json.loads(output) if (each["scene"], each["variant"]) == (row["scene"], row["form"])]
    if len(found) != 1:
        raise Broken(f"{program} knows {len(found)} such kernels")
    return found[0]


def differences(row, measured, names, tolerance):
    return [f"{name} is {measured[name]}, promised was {row[name]}" for name in names
            if name in row and abs(measured[name] - row[name]) > tolerance * abs(row[name])]


def measured(row, host):
    """The figures of the kernel as it is built: its costs and its errors."""
    return measure.Figures(row["board"], probe_of(row)).row(), errors_of(row, host)


def compare(row, cost, error, cost_tolerance=0.0, error_tolerance=LAST_BITS):
    """Raises Broken where a figure differs from what the row promises."""
    wrong = differences(row, cost, COSTS, cost_tolerance) + differences(row, error, ERRORS, error_tolerance)
    if wrong:
        raise Broken(f"{probe_of(row).name} on {row['board']}: " + "; ".join(wrong))


def check(row, host):
    """Lines that say what was checked. Raises Broken where something differs."""
    compile_lines([row])
    cost, error = measured(row, host)
    compare(row, cost, error)
    return [f"verified {probe_of(row).name} on {row['board']}: the lines compile to the scene that was measured,",
            f"  {cost['instructions']} instructions in {measure.emulator(row['board'])}, error {error['error']:.3g} over {error['states']} states, as promised"]
