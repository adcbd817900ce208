"""Draws a closed loop: tracking errors of the joints with and without what is fed forward, and what errors of the model cost;
or of an arm on a board beside one on the host, and how far these are apart.

usage: loop.py LOOP.csv LOOP.json   (writes LOOP.png beside them)
"""

import csv
import json
import sys

import matplotlib.pyplot as plt

import style

LOOPS = ["feedback alone", "feed-forward"]
ARMS = ["the host's plant", "two boards"]


def read(file):
    with open(file, encoding="utf-8", newline="") as text:
        return list(csv.DictReader(text))


def main(table, figures):
    samples = read(table)
    with open(figures, encoding="utf-8") as text:
        rows = json.load(text)
    joints = sum(1 for name in samples[0] if name.startswith("error"))
    swept = [row for row in rows if row["board"] == "host"]
    on_boards = "plant_board" in rows[0]
    lower = swept or on_boards
    style.use()
    figure, panels = plt.subplots(2 if lower else 1, 1, figsize=(9, 8.4 if lower else 4.2), squeeze=False)
    where = f"{rows[0]['robot']} on the emulated {rows[0]['board']}, {rows[0]['scalar']}"
    if on_boards:
        draw_errors(panels[0, 0], samples, joints, ARMS, f"{where}; the arm on a {rows[0]['plant_board']}; pale: on the host")
        draw_difference(panels[1, 0], samples, joints)
    else:
        draw_errors(panels[0, 0], samples, joints, LOOPS, f"{where}; pale: feedback alone")
    if swept:
        draw_sweep(panels[1, 0], swept)
    figure.tight_layout()
    what = "with its arm on another board" if on_boards else "with and without feed-forward"
    style.save(figure, table.removesuffix(".csv"), f"The firmware in a closed loop, {what}")


def draw_difference(panel, samples, joints):
    one, other = ([sample for sample in samples if sample["loop"] == arm] for arm in ARMS)
    time = [float(sample["time"]) for sample in other]
    for joint in range(joints):
        name = f"error{joint + 1}"
        apart = [max(abs(float(a[name]) - float(b[name])), 1e-11) for a, b in zip(one, other)]
        panel.plot(time, apart, color=style.COLOURS[joint], linewidth=1.2, label=f"joint {joint + 1}")
    panel.set_yscale("log")
    panel.set_xlabel("time, s")
    panel.set_ylabel("board's arm less host's, rad or m")
    panel.legend(ncols=joints, loc="upper right")


def draw_errors(panel, samples, joints, loops, title):
    for loop, width in zip(loops, (0.9, 1.8)):
        own = [sample for sample in samples if sample["loop"] == loop]
        time = [float(sample["time"]) for sample in own]
        for joint in range(joints):
            size = [max(abs(float(sample[f"error{joint + 1}"])), 1e-9) for sample in own]
            panel.plot(time, size, color=style.COLOURS[joint], linewidth=width, alpha=0.5 if loop == loops[0] else 1.0,
                       label=f"joint {joint + 1}" if loop == loops[1] else None)
    panel.set_yscale("log")
    panel.set_ylim(1e-8, 1.0)
    panel.set_xlabel("time, s")
    panel.set_ylabel("tracking error, rad or m")
    panel.set_title(title)
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
