"""Draws how a regulator brings an arm back, beside the tracking image: deviations and torques of the joints after a push of each.

usage: pushes.py PUSH.csv PUSH.json   (writes PUSH.png beside them)
"""

import csv
import json
import sys

import matplotlib.pyplot as plt

import style

LOOPS = {"pd": (0.9, 0.5), "lqr": (1.8, 1.0)}  # width of a line, and how opaque it is
DRAWN = 0.6  # s


def main(table, figures):
    with open(table, encoding="utf-8", newline="") as text:
        samples = [row for row in csv.DictReader(text) if float(row["time"]) <= DRAWN]
    with open(figures, encoding="utf-8") as text:
        row = json.load(text)[0]
    joints = sum(1 for name in samples[0] if name.startswith("error"))
    style.use()
    figure, panels = plt.subplots(2, 1, figsize=(9, 7.6), sharex=True)
    draw(panels[0], samples, joints, "error", 1e3)
    panels[0].set_ylabel("off the motion, mrad or mm")
    panels[0].set_title(f"{row['robot']} on the emulated {row['board']} at 1 kHz, pushed in motion; pale: PD")
    panels[0].legend(ncols=joints, loc="upper right")
    draw(panels[1], samples, joints, "effort", 1.0)
    panels[1].axhline(1.0, color=style.INK, linewidth=0.8)
    panels[1].axhline(-1.0, color=style.INK, linewidth=0.8)
    panels[1].set_ylabel("torque over its limit")
    panels[1].set_xlabel("time since the push, s")
    figure.tight_layout()
    style.save(figure, table.removesuffix(".csv"), "A regulator whose gains the board computes brings the arm back")


def draw(panel, samples, joints, quantity, scale):
    for loop, (width, alpha) in LOOPS.items():
        own = [sample for sample in samples if sample["controller"] == loop]
        time = [float(sample["time"]) for sample in own]
        for joint in range(joints):
            panel.plot(time, [scale * float(sample[f"{quantity}{joint + 1}"]) for sample in own], color=style.COLOURS[joint], linewidth=width,
                       alpha=alpha, label=f"joint {joint + 1}" if loop == "lqr" else None)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
