"""Draws an excitation trajectory: positions and speeds of the joints.

usage: excitation.py TRAJECTORY.csv   (writes TRAJECTORY.png beside it)
"""

import csv
import pathlib
import sys

import matplotlib.pyplot as plt

import style


def main(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    rows = rows[::max(1, len(rows) // 1000)]
    joints = sum(1 for name in rows[0] if name.startswith("qdd"))
    time = [float(row["time"]) for row in rows]
    style.use()
    figure, panels = plt.subplots(3, 1, figsize=(9, 7.5), sharex=True)
    for panel, name, label in zip(panels, ("q", "qd", "qdd"), ("position, rad or m", "speed, 1/s", "acceleration, 1/s²")):
        for joint in range(joints):
            panel.plot(time, [float(row[f"{name}{joint + 1}"]) for row in rows], color=style.COLOURS[joint % len(style.COLOURS)],
                       linestyle="-" if joint < len(style.COLOURS) else "--", label=f"joint {joint + 1}")
        panel.set_ylabel(label)
    panels[0].set_title("excitation")
    panels[0].legend(ncols=joints, loc="upper right", bbox_to_anchor=(1.0, 1.2))
    panels[2].set_xlabel("time, s")
    figure.tight_layout()
    style.save(figure, str(pathlib.Path(path).with_suffix("")), "A motion that excites every parameter, inside the limits")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
