"""Writes the table of doc/measurements/plant.md, as tables.py does with the others.

usage: plant_tables.py DATA_FOLDER DOCUMENT.md
"""

from tables import command, load, markdown


def number(value):
    return "" if value is None else f"{value:.2g}"


def rows(folder):
    found = [[row["robot"], row["motion"], row["method"].replace("_", " "), f"{row['step_s'] * 1e3:g}", row["scalar"],
              number(row["error"]), number(row["energy_drift"])] for row in load(folder / "plant.json")]
    return markdown(["robot", "motion", "method", "step, ms", "number", "error over travel", "energy drift"], found)


def provenance(folder):
    made = load(folder / "plant_provenance.json")
    return f"On the host: commit `{made['commit']}`, {made['compiler']}, `{made['flags']}`.\n"


TABLES = {"plant": rows, "plant_provenance": provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
