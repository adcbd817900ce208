"""Writes the tables of doc/measurements/work_precision.md, as tables.py does with the others.

usage: work_precision_tables.py DATA_FOLDER DOCUMENT.md
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "plot"))
from number_systems import NAMES  # noqa: E402
from tables import fill, grouped, load, markdown  # noqa: E402

JOBS = ["inverse_dynamics", "inverse_dynamics_of_pairs", "gravity", "bias", "mass_matrix", "forward_dynamics", "forward_kinematics", "jacobian",
        "inverse_dynamics_derivatives", "forward_dynamics_derivatives", "elastic_feedforward"]


def identity(row):
    return tuple(row[name] for name in ("board", "robot", "algorithm", "scene", "form", "scalar"))


def words(name):
    return name.replace("_", " ")


def fronts(rows, board):
    """What is on a front of its robot and job: of instructions, of time, of bytes."""
    header = ["job, robot", "kernel, numbers, variant", "largest error", "RMS", "as torque", "instructions", "cycles", "us", "bytes", "front of"]
    here = [row for row in rows if "job" in row and row["board"] == board]
    units = {unit: {identity(row): row for row in here if row["unit_of_work"] == unit} for unit in ("instructions", "microseconds", "bytes")}
    lines = []
    for key, row in sorted(units["instructions"].items(), key=lambda item: (JOBS.index(item[1]["job"]), item[1]["robot"], item[1]["work"])):
        quick, small = units["microseconds"][key], units["bytes"][key]
        front = [unit for unit, each in (("instructions", row), ("time", quick), ("bytes", small)) if each["pareto"]]
        if front:
            lines.append([f"{words(row['job'])}, {row['robot']}", f"{words(row['subject'])}, {NAMES[row['scalar']]}, {row['variant']}",
                          f"{row['error']:.1e}", f"{row['error_rms']:.1e}", f"{row['error_torque']:.1e}" if "error_torque" in row else "",
                          grouped(row["work"]), grouped(row["cycles"]), f"{quick['work']:.1f}", grouped(small["work"]), ", ".join(front)])
    return markdown(header, lines)


def two_rate(rows):
    header = ["robot", "ticks between refreshes", "largest error", "largest error, ahead", "instructions per tick, average, stm32f405", "worst tick",
              "full rate", "average, nrf51", "worst tick", "full rate"]
    found = {}
    for row in rows:
        if row["subject"] == "two_rate_feedforward":
            found.setdefault((row["robot"], row["ticks"]), {})[row["board"], "ahead" in row["variant"]] = row
    lines = []
    for (robot, ticks), cells in found.items():
        main = cells["stm32f405", False]
        line = [robot, str(ticks), f"{main['error']:.1e}", f"{cells['stm32f405', True]['error']:.1e}"]
        for board in ("stm32f405", "nrf51"):
            row = cells.get((board, False))
            line += [grouped(row[name]) if row else "" for name in ("work", "work_worst", "work_full_rate")]
        lines.append(line)
    return markdown(header, lines)


def simulation(rows):
    """The front of each simulated case."""
    own = [row for row in rows if "job" not in row and row["subject"] != "two_rate_feedforward" and row["pareto"]]
    if not own:
        return "No simulation was measured.\n"
    header = ["case, robot", "integrator, numbers", "global error", "kernel calls", "host time over a kernel call's"]
    own.sort(key=lambda row: (row["subject"], row["robot"], row["work"]))
    return markdown(header, [[f"{words(row['subject'].removeprefix('simulation, '))}, {row['robot']}", f"{words(row['variant'])}, {row['scalar']}",
                              f"{row['error']:.1e}", grouped(row["work"]), f"{row['time_ratio']:.3g}"] for row in own])


def provenance(made):
    flags = "".join(f"- `{board}`: `{flags}`\n" for board, flags in made["flags"].items())
    return f"Costs measured in QEMU at commit `{made['commit']}` with {made['compiler']}:\n\n{flags}"


def main(folder, document):
    folder = pathlib.Path(folder)
    rows = load(folder / "work_precision.json")
    tables = {f"fronts_{board}": fronts(rows, board) for board in {row["board"] for row in rows if "job" in row}}
    tables.update(two_rate=two_rate(rows), simulation=simulation(rows), work_precision_provenance=provenance(load(folder / "size_provenance.json")))
    fill(document, tables.__getitem__)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
