"""Writes the tables of doc/guides/observer.md, as tables.py does with the others.

usage: observer_tables.py DATA_FOLDER DOCUMENT.md
"""

from tables import command, load, markdown


def collisions(folder):
    rows = [[row["scalar"], f"{row['seconds']:g}", str(row["contacts"]), str(row["missed"]), f"{row['delay_median_s'] * 1e3:.0f}",
             f"{row['delay_max_s'] * 1e3:.0f}", str(row["false_alarms"]), f"{row['headroom']:.2f}"]
            for row in load(folder / "collide.json") if row["subject"] == "collisions"]
    return markdown(["observer in", "motion, s", "contacts", "missed", "delay, median, ms", "largest, ms", "false alarms",
                     "largest quiet residual over threshold"], rows)


def payloads(folder):
    rows = [[row["robot"], f"{row['mass_kg']:g}", f"{row['ready_s']:.2f}", f"{row['mass_error_kg'] * 1e3:.1f}",
             f"{row['mass_deviation_kg'] * 1e3:.1f}", f"{row['moment_error_kg_m'] * 1e3:.1f}"]
            for row in load(folder / "collide.json") if row["subject"] == "payload"]
    return markdown(["robot", "payload, kg", "sure after, s", "error of mass after 60 s, g", "its deviation, g",
                     "error of first moment, g m"], rows)


def provenance(folder):
    made = load(folder / "collide_provenance.json")
    return f"Commit `{made['commit']}`, {made['compiler']}, `{made['flags']}`.\n"


TABLES = {"collisions": collisions, "payloads": payloads, "collide_provenance": provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
