"""Draws a closed loop: tracking errors of the joints with and without what is fed forward, and what errors of the model cost.

usage: loop.py LOOP.csv LOOP.json   (writes LOOP.png beside them)
"""

import csv
import json
import sys

import matplotlib.pyplot as plt

import style

LOOPS = ["feedback alone", "feed-forward"]


def read(file):
    with open(file, encoding="utf-8", newline="") as text:
        return list(csv.DictReader(text))


def main(table, figures):
    samples = read(table)
    with open(figures, encoding="utf-8") as text:
        rows = json.load(text)
    joints = sum(1 for name in samples[0] if name.startswith("error"))
    swept = [row for row in rows if row["board"] == "host"]
    style.use()
    figure, panels = plt.subplots(2 if swept else 1, 1, figsize=(9, 8.4 if swept else 4.2), squeeze=False)
    draw_errors(panels[0, 0], samples, joints, rows[0])
    if swept:
        draw_sweep(panels[1, 0], swept)
    figure.tight_layout()
    style.save(figure, table.removesuffix(".csv"), "The firmware in a closed loop, with and without feed-forward")


def draw_errors(panel, samples, joints, row):
    for loop, width in zip(LOOPS, (0.9, 1.8)):
        own = [sample for sample in samples if sample["loop"] == loop]
        time = [float(sample["time"]) for sample in own]
        for joint in range(joints):
            size = [max(abs(float(sample[f"error{joint + 1}"])), 1e-9) for sample in own]
            panel.plot(time, size, color=style.COLOURS[joint], linewidth=width, alpha=0.5 if loop == LOOPS[0] else 1.0,
                       label=f"joint {joint + 1}" if loop == LOOPS[1] else None)
    panel.set_yscale("log")
    panel.set_ylim(1e-8, 1.0)
    panel.set_xlabel("time, s")
    panel.set_ylabel("tracking error, rad or m")
    panel.set_title(f"{row['robot']} on the emulated {row['board']}, {row['scalar']}; pale: feedback alone")
    panel.legend(ncols=joints, loc="upper right")


def draw_sweep(panel, rows):
    names = list(dict.fromkeys(row["name"] for row in rows))
    for loop, colour, shift in zip((False, True), (style.COLOURS[1], style.COLOURS[0]), (0.2, -0.2)):
        own = {row["name"]: row["tool_error_rms"] * 1e3 for row in rows if row["feeds_forward"] == loop}
        panel.barh([i + shift for i in range(len(names))], [own[name] for name in names], height=0.38, color=colour,
                   label=LOOPS[loop])
    panel.set_yticks(range(len(names)), names)
    panel.invert_yaxis()
    panel.set_xscale("log")
    panel.set_xlabel("tool error, RMS, mm")
    panel.set_title("what spoils it (sources on the host)")
    panel.legend(loc="upper right", bbox_to_anchor=(1.0, 1.1), ncols=2)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
