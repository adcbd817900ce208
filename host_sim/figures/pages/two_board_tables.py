"""Gathers rows of ./axial hil into data/hil.json and writes the tables of measurements/hil.md.

usage: two_board_tables.py DOC_FOLDER [ROWS.json...]   (without rows: of what is in data/hil.json)
"""

import json
import pathlib
import sys

from tables import fill, grouped, load, markdown

TRACKING = 0.02


def loops(rows):
    found = [[row["robot"], f"{row['board']}, {row['scalar']}", f"{row['plant_board']}, {row['plant_scalar']}", f"{row['seconds']:g}",
              f"{1e6 * row['tool_error_rms']:.3g}", f"{1e6 * row['host_tool_error_rms']:.3g}", f"{100 * row['difference']:.1g} %",
              str(row["last_places"]), grouped(row["instructions"]), grouped(row["plant_instructions"]), f"{row['ticks_per_s']:.0f}"]
             for row in rows if "difference" in row]
    return markdown(["robot", "controller", "arm", "s", "tool RMS, um", "by the host's arm", "apart", "last places", "instructions, controller",
                     "arm", "ticks a second"], found, 3)


def faults(rows):
    found = [[row["fault"], row["ends"], "yes" if row["held"] else "NO: " + row["found"]] for row in rows if "fault" in row]
    return markdown(["fault of the line", "ends", "did"], found, 3)


def main(doc, files):
    data = pathlib.Path(doc) / "data"
    if files:
        rows = [row for file in files for row in load(pathlib.Path(file))]
        (data / "hil.json").write_text(json.dumps(rows, indent=2) + "\n", encoding="utf-8")
    rows = load(data / "hil.json")
    made = load(data / "hil_provenance.json")
    provenance = f"Commit `{made['commit']}`. On the host: {made['compiler']}; images of Arm boards: {made['boards']}, flags of hal/toolchains.\n"
    page = pathlib.Path(doc) / "measurements/hil.md"
    tables = {"two_boards": loops(rows), "two_board_faults": faults(rows), "two_board_provenance": provenance}
    fill(page, tables.get)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
