"""Writes the tables of doc/measurements/gallery.md, as tables.py does with the others.

usage: gallery_tables.py DATA_FOLDER DOCUMENT.md
"""

import collections
import sys

from tables import command, grouped, load, markdown

NUMBERS = ("float", "fixed32")
TORQUE, SAFE_LOOP = "inverse_dynamics", "feedforward"
TIMED = (TORQUE, "gravity", "forward_dynamics", SAFE_LOOP)
TITLES = {TORQUE: "torque", "gravity": "gravity", "forward_dynamics": "forward dynamics", SAFE_LOOP: "safe loop"}
NOT_YET = "not measured yet"
HEADER = ["robot", "joints", "number", "torque, us", "gravity, us", "forward dynamics, us", "safe loop, us", "torque, instructions",
          "safe loop: flash", "RAM", "stack", "torque's error", "forward dynamics' error"]


def time(row):
    value = row.get("microseconds")
    return "-" if value is None else f"{value:.1f}" if value < 1000 else grouped(round(value))


def count(row, name):
    return grouped(row[name]) if name in row else "-"


def error(row):
    return f"{row['error']:.1e}" if row.get("error") is not None else "-"


def line(name, number, joints, rows):
    """`rows`: a cell's, by their algorithm."""
    torque, safe = rows[TORQUE], rows[SAFE_LOOP]
    return [name, str(joints or ""), number, *(time(rows[algorithm]) for algorithm in TIMED), count(torque, "instructions"),
            *(count(safe, field) for field in ("flash_bytes", "ram_bytes", "stack_bytes")), error(torque), error(rows["forward_dynamics"])]


def cells(rows):
    """{(robot, number): {algorithm: row}}"""
    found = collections.defaultdict(dict)
    for row in rows:
        found[row["robot"], row["number"]][row["algorithm"]] = row
    return found


def joints_of(rows):
    return {row["robot"]: row["joints"] for row in rows if row.get("joints")}


def refusals(rows):
    """What is not there, and why: robots with the same reason in a line."""
    found = collections.defaultdict(list)
    for (robot, number), cell in cells(rows).items():
        whys = collections.defaultdict(list)
        for algorithm, row in cell.items():
            if row.get("why", NOT_YET) != NOT_YET:
                whys[row["why"]].append(TITLES[algorithm])
        for why, titles in whys.items():
            found[number, "all" if len(titles) == len(TIMED) else ", ".join(titles), why].append(robot)
    return "".join(f"- {', '.join(robots)} in {number}, {what}: {why}\n" for (number, what, why), robots in found.items())


def missing(rows):
    count_of = sum(all(row.get("why") == NOT_YET for row in cell.values()) for cell in cells(rows).values())
    return f"Not measured yet: {count_of} of {len(cells(rows))} cells.\n" if count_of else ""


def board(name):
    def table(folder):
        known = load(folder / "gallery.json")
        rows, joints = [row for row in known if row["board"] == name], joints_of(known)
        there = [line(robot, number, joints.get(robot), cell) for (robot, number), cell in cells(rows).items() if any("why" not in row for row in cell.values())]
        return "\n\n".join(filter(None, [markdown(HEADER, there).strip("\n") if there else "", missing(rows).strip("\n"), refusals(rows).strip("\n")])) + "\n"
    return table


def provenance(folder):
    made = load(folder / "gallery_provenance.json")
    commits = [f"commit `{commit}`" for commit in made["commits"]]
    several = "; each row's is in the data, with a digest of the sources that it was made from" if len(commits) > 1 else ""
    lines = [f"- `{name}`: instructions by {made['emulators'][name]}. {says} Flags: `{made['flags'].get(name, 'not built here')}`\n" for name, says in made["models"].items()]
    return f"Measured at {', '.join(commits)}{several}, by {made['compiler']}.\n\n" + "".join(lines)


def coverage(folder):
    """Of which cells there are figures."""
    rows, found = load(folder / "gallery.json"), []
    for name in dict.fromkeys(row["board"] for row in rows):
        for number in NUMBERS:
            of_both = cells([row for row in rows if (row["board"], row["number"]) == (name, number)])
            left = sum(all(row.get("why") == NOT_YET for row in cell.values()) for cell in of_both.values())
            there = sum(all("why" not in row for row in cell.values()) for cell in of_both.values())
            found.append([name, number, str(len(of_both)), str(there), str(len(of_both) - there - left), str(left)])
    return markdown(["board", "number", "robots", "all four kernels", "some cannot be", NOT_YET], found, words=2)


BOARDS = ("stm32f405", "stm32f100", "nrf51", "rp2040", "rp2350_riscv")
TABLES = {"gallery_provenance": provenance, "gallery_coverage": coverage, **{f"gallery_{name}": board(name) for name in BOARDS}}


if __name__ == "__main__":
    command(__doc__, TABLES)
