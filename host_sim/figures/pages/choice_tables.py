"""Writes the tables of doc/guides/choosing.md: the cheapest kernels inside an error, on every board.

usage: choice_tables.py DATA_FOLDER DOCUMENT.md
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "plot"))
from number_systems import NAMES  # noqa: E402
from tables import fill, grouped, load, markdown  # noqa: E402

ERRORS = (1e-2, 1e-4, 1e-6, 1e-7)
ROBOT = "puma560"


def cheapest(rows, error):
    """Of these, the one with the least work inside an error, or None."""
    return min((row for row in rows if row["error"] <= error), key=lambda row: (row["work"], row["error"]), default=None)


def cell(row):
    if row is None:
        return "none"
    kernel = "" if row["subject"] == row["job"] else row["subject"].replace("_", " ") + ", "
    variant = "" if row["variant"] == "unrolled" else ", " + row["variant"]
    return f"{kernel}{NAMES[row['scalar']]}{variant}: {amount(row)}"


def amount(row):
    return f"{row['work']:.1f}" if row["unit_of_work"] == "microseconds" else grouped(row["work"])


def choices(rows, job, unit):
    """A line per board: what is cheapest inside each error."""
    here = [row for row in rows if (row.get("job"), row["robot"], row["unit_of_work"]) == (job, ROBOT, unit)]
    boards = sorted({row["board"] for row in here})
    lines = [[board] + [cell(cheapest([row for row in here if row["board"] == board], error)) for error in ERRORS] for board in boards]
    return markdown(["board"] + [f"error at most {error:.0e}" for error in ERRORS], lines)


def main(folder, document):
    rows = load(pathlib.Path(folder) / "work_precision.json")
    commit = load(pathlib.Path(folder) / "size_provenance.json")["commit"]

    def table(name):
        if name == "choice_provenance":
            return f"From the data of [work_precision.md](../measurements/work_precision.md), measured in QEMU at commit `{commit}`.\n"
        job, unit = name.rsplit("_in_", 1)
        return choices(rows, job, unit)

    fill(document, table)


if __name__ == "__main__":
    main(*sys.argv[1:])
