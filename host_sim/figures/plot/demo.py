"""Draws a demo's recording: trajectory, torques and errors over time.

usage: demo.py RECORDING.csv SUMMARY.json   (writes RECORDING.png beside them)
"""

import json
import sys

import matplotlib.pyplot as plt
import numpy as np

import style

FLOOR = 1e-10  # of the error axis; an error of zero is drawn there


def main(csv_file, json_file):
    data = np.genfromtxt(csv_file, delimiter=",", names=True)
    with open(json_file, encoding="utf-8") as file:
        joints = json.load(file)
    style.use()
    figure, panels = plt.subplots(3, 1, figsize=(9, 8.6), sharex=True, height_ratios=[1, 1.1, 1])
    lines = draw_pair(panels[0], data, joints, "q", "Desired motion", {"N m": "rad", "N": "m"})
    draw_pair(panels[1], data, joints, "torque", "Torque from the firmware", {"N m": "N m", "N": "N"})
    draw_errors(panels[2], data, joints)
    panels[2].set_xlabel("time, s")
    panels[2].set_xlim(data["time"][0], data["time"][-1])
    figure.text(0.012, 0.99, title(joints), ha="left", va="top")
    figure.legend(handles=lines, loc="upper left", bbox_to_anchor=(0.004, 0.972), ncols=len(lines), columnspacing=1.4)
    figure.align_ylabels(panels)
    figure.tight_layout(rect=(0, 0, 1, 0.94))
    style.save(figure, csv_file.removesuffix(".csv"))


def title(joints):
    first = joints[0]
    unit = "cycles" if "cycles_min" in first else "instructions"
    count = f"{first[unit + '_min']} to {first[unit + '_max']} {unit}"
    return (f"{first['robot']} on {first['board']} in {first.get('emulator', 'QEMU')}: {first['set_points']} set-points at 1 kHz, "
            f"{first.get('scalar', 'float')}, {count} per torque")


def draw_pair(axes, data, joints, column, heading, units):
    """Revolute joints on the left scale; prismatic ones, dashed, on the right."""
    axes.set_title(heading)
    right = axes.twinx() if len({joint["unit"] for joint in joints}) > 1 else None
    lines = []
    for index, joint in enumerate(joints):
        slides = joint["unit"] == "N" and right is not None
        target = right if slides else axes
        lines += target.plot(data["time"], data[f"{column}{index + 1}"], color=style.COLOURS[index],
                             linestyle=(0, (5, 1.5)) if slides else "-",
                             label=f"{joint.get('values_of', 'joint')} {index + 1}" + (" (right scale)" if slides else ""))
        target.set_ylabel(units[joint["unit"]])
    if right is not None:
        right.spines["right"].set_visible(True)
        right.grid(False)
    return lines


def draw_errors(axes, data, joints):
    axes.set_title("Largest error of every 10 ms against the oracle, relative to the largest torque of each")
    for index, joint in enumerate(joints):
        time, error = largest_of_each(10, data["time"], np.abs(data[f"error{index + 1}"]))
        relative = np.maximum(error / (joint["torque_scale"] or 1.0), FLOOR)
        axes.step(time, relative, where="post", color=style.COLOURS[index], linewidth=1.0)
    bound = max(joint["error_bound_relative"] for joint in joints)
    axes.axhline(bound, color=style.INK, linewidth=1.0, linestyle=(0, (2, 2)))
    axes.annotate(f"bound {bound:g}", (data["time"][-1], bound), xytext=(-4, 3), textcoords="offset points", ha="right")
    axes.set_yscale("log")
    axes.set_ylim(FLOOR, 3 * bound)
    axes.set_ylabel("relative error")


def largest_of_each(count, time, values):
    """Splits both into groups of count samples: the groups' first times and largest values."""
    starts = np.arange(0, len(values), count)
    return time[starts], np.maximum.reduceat(values, starts)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
