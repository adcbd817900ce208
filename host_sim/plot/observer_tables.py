"""Writes the tables of doc/observer.md, as tables.py does with the others.

usage: observer_tables.py DATA_FOLDER DOCUMENT.md
"""

import pathlib
import sys

from tables import fill, load, markdown


def collisions(folder):
    rows = [[row["scalar"], f"{row['seconds']:g}", str(row["contacts"]), str(row["missed"]), f"{row['delay_median_s'] * 1e3:.0f}",
             f"{row['delay_max_s'] * 1e3:.0f}", str(row["false_alarms"]), f"{row['headroom']:.2f}"]
            for row in load(folder / "collide.json")]
    return markdown(["observer in", "motion, s", "contacts", "missed", "delay, median, ms", "largest, ms", "false alarms",
                     "largest quiet residual over threshold"], rows)


def provenance(folder):
    made = load(folder / "collide_provenance.json")
    return f"Commit `{made['commit']}`, {made['compiler']}, `{made['flags']}`.\n"


TABLES = {"collisions": collisions, "collide_provenance": provenance}


def main(folder, document):
    folder = pathlib.Path(folder)
    fill(document, lambda name: TABLES[name](folder))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
