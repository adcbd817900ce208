"""Draws velocities that an extended Kalman filter and differences of the encoders tell, and their errors by joint.

usage: observers.py VELOCITIES.csv VELOCITIES.json   (writes VELOCITIES.png beside them)
"""

import csv
import json
import sys

import matplotlib.pyplot as plt

import style

DRAWN = "3"  # joint
MEANS = [("difference", "velocity_error_difference", "difference of a tick", style.FAINT), ("ten", "velocity_error_ten_ticks", "of ten ticks", style.COLOURS[1]),
         ("filter", "velocity_error_filter", "filter", style.COLOURS[0])]


def main(table, figures):
    with open(table, encoding="utf-8", newline="") as text:
        samples = [row for row in csv.DictReader(text) if row["joint"] == DRAWN]
    with open(figures, encoding="utf-8") as text:
        row = json.load(text)[0]
    style.use()
    figure, panels = plt.subplots(2, 1, figsize=(9, 7.6))
    draw_velocities(panels[0], samples, row)
    draw_errors(panels[1], row)
    figure.tight_layout()
    style.save(figure, table.removesuffix(".csv"), "What a filter on the board knows of the arm's velocities")


def draw_velocities(panel, samples, row):
    time = [float(sample["time"]) for sample in samples]
    for column, _, label, colour in MEANS:
        panel.plot(time, [float(sample[column]) for sample in samples], color=colour, linewidth=1.6 if column == "filter" else 0.8, label=label)
    panel.plot(time, [float(sample["true"]) for sample in samples], color=style.INK, linewidth=0.8, linestyle="--", label="the plant's")
    size = 1.4 * max(abs(float(sample["true"])) for sample in samples)
    panel.set_ylim(-size, size)
    panel.set_xlabel("time, s")
    panel.set_ylabel(f"velocity of joint {DRAWN}, rad/s or m/s")
    panel.set_title(f"{row['robot']} on the emulated {row['board']}: encoders of {row['encoder_bits']} bits, a count of noise")
    panel.legend(ncols=4, loc="lower right")


def draw_errors(panel, row):
    joints = range(1, len(row["velocity_error_filter"]) + 1)
    for (_, key, label, colour), shift in zip(MEANS, (-0.27, 0.0, 0.27)):
        panel.bar([joint + shift for joint in joints], row[key], width=0.25, color=colour, label=label)
    panel.set_yscale("log")
    panel.set_xticks(list(joints), [f"joint {joint}" for joint in joints])
    panel.set_ylabel("velocity error, RMS, rad/s or m/s")
    panel.legend(ncols=3, loc="upper right", bbox_to_anchor=(1.0, 1.12))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
