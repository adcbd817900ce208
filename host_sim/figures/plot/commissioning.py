"""Draws what drives report in held poses against what the arm should take, as described and as found.

usage: commissioning.py TORQUES.csv   (of ./axial commission; writes TORQUES.png beside it)
"""

import csv
import pathlib
import sys

import matplotlib.pyplot as plt

import style

CURVES = (("described", "measured", style.COLOURS[1], "x"), ("found", "reported", style.COLOURS[0], "o"))


def panel_of(panel, rows, joint):
    for predicted, measured, colour, mark in CURVES:
        x, y = ([float(row[f"{name}{joint + 1}"]) for row in rows] for name in (predicted, measured))
        panel.plot(x, y, mark, color=colour, markersize=4, fillstyle="none", label=f"as {predicted}")
    low, high = panel.get_xlim()
    panel.plot([low, high], [low, high], color=style.INK, linewidth=0.8)
    panel.set_title(f"joint {joint + 1}, N m or N")


def main(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    joints = sum(1 for name in rows[0] if name.startswith("measured"))
    style.use()
    columns = min(joints, 3)
    lines = -(-joints // columns)
    figure, panels = plt.subplots(lines, columns, figsize=(4 * columns, 3.2 * lines), squeeze=False)
    for joint, panel in enumerate(panels.flat):
        if joint < joints:
            panel_of(panel, rows, joint)
        else:
            panel.axis("off")
    for panel in panels[-1]:
        panel.set_xlabel("predicted")
    for line in panels:
        line[0].set_ylabel("reported by the drive")
    panels.flat[0].legend(loc="upper left")
    figure.tight_layout()
    style.save(figure, str(pathlib.Path(path).with_suffix("")), "Held poses: torque as the drives report it, as predicted")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
