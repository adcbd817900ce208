"""Draws predicted against measured torque of each joint.

usage: identification.py TORQUES.csv   (of ./axial identify; writes TORQUES.png beside it)
"""

import csv
import pathlib
import sys

import matplotlib.pyplot as plt

import style

CURVES = (("measured", style.INK, 2.4), ("prior", style.COLOURS[1], 0.9), ("identified", style.COLOURS[5], 1.1))


def main(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    rows = rows[::max(1, len(rows) // 1500)]
    joints = sum(1 for name in rows[0] if name.startswith("measured"))
    time = [float(row["time"]) for row in rows]
    style.use()
    columns = 2 if joints > 3 else 1
    figure, panels = plt.subplots(-(-joints // columns), columns, figsize=(11, 2.2 * -(-joints // columns) + 0.6), sharex=True, squeeze=False)
    for joint in range(joints):
        panel = panels.flat[joint]
        for name, colour, width in CURVES:
            panel.plot(time, [float(row[f"{name}{joint + 1}"]) for row in rows], color=colour, linewidth=width, label=name)
        panel.set_title(f"joint {joint + 1}, N m or N")
    for panel in list(panels.flat)[joints:]:
        panel.axis("off")
    for panel in panels[-1]:
        panel.set_xlabel("time, s")
    panels.flat[0].legend(ncols=3, loc="upper right", bbox_to_anchor=(1.0, 1.32))
    figure.tight_layout()
    style.save(figure, str(pathlib.Path(path).with_suffix("")), "Measured torques beside those of the identified parameters")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
