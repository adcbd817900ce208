"""Writes the tables of what large robots cost a compiler into a document, as tables.py does with the others.

usage: compile_time_tables.py DATA_FOLDER DOCUMENT.md

DATA_FOLDER holds compile_time.json and compile_time_provenance.json.
"""

from compile_cost_tables import provenance
from tables import command, load, markdown, unique


class Data:
    def __init__(self, folder):
        self.rows = load(folder / "compile_time.json")
        self.provenance = load(folder / "compile_time_provenance.json")


FORMS = {"headers": "headers alone", "route": "route", "route_looped": "route, looped", "default": "forward dynamics",
         "articulated": "`ArticulatedBody`", "looped": "`Looped`", "looped_articulated": "`Looped`, `ArticulatedBody`"}


def of_build(build):
    """A row per robot; in each cell seconds and megabytes of one form."""
    def table(data):
        found = {(row["robot"], row["form"]): row for row in data.rows if row["build"] == build}
        robots = {row["robot"]: f"{row['joints']} | {row['shape']}" for row in data.rows}
        rows = []
        for robot in unique(robot for robot, _ in found):
            each = [found.get((robot, form)) for form in FORMS]
            rows.append([robots[robot]] + [f"{row['seconds']:.2f} s, {row['memory_MB']} MB" if row else "" for row in each])
        return markdown([f"{build}, joints", "shape", *FORMS.values()], [[*row[0].split(" | "), *row[1:]] for row in rows], words=(1,))
    return table


TABLES = {f"compile_time_{build.replace('-', '_')}": of_build(build) for build in ("host-gcc-O2", "host-clang-O2")}
TABLES["compile_time_provenance"] = provenance

if __name__ == "__main__":
    command(__doc__, TABLES, Data)
