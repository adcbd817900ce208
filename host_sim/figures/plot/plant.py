"""Draws a robot that a board integrated: where its joints went, and what their positions were off double.

usage: plant.py WAYS.json
Writes WAYS.png beside it.
"""

import json
import pathlib
import sys

import matplotlib.pyplot as plt

import style

FLOOR = 1e-12  # of the error axis


def label(row):
    factor = f"{row['real_time_factor']:.3g} times real time"
    return f"{row['scalar']}, {row['method'].replace('_', ' ')}, {1e3 * row['step_s']:g} ms: {factor}"


def draw(ways, stem):
    figure, (positions, errors) = plt.subplots(1, 2, figsize=(11, 4.2))
    first = ways[0]["way"]["positions"]
    time = [(k + 1) * 1e-3 for k in range(len(first))]
    for joint, q in enumerate(zip(*first)):
        positions.plot(time, q, color=style.COLOURS[joint % len(style.COLOURS)], label=f"joint {joint + 1}")
    positions.set(title="where the board has its joints", xlabel="time, s", ylabel="position, rad or m")
    positions.legend(ncol=2)
    for at, way in enumerate(ways):
        errors.semilogy(time, [max(error, FLOOR) for error in way["way"]["errors"]], color=style.COLOURS[at % len(style.COLOURS)], label=label(way["row"]))
    errors.set(title="off double, over the joint's travel", xlabel="time, s")
    errors.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2, fontsize=8)
    row = ways[0]["row"]
    figure.tight_layout()
    style.save(figure, stem, f"{row['robot']} integrated on {row['board']}, open loop, by torques held for a tick")


if __name__ == "__main__":
    style.use()
    file = pathlib.Path(sys.argv[1])
    draw(json.loads(file.read_text(encoding="utf-8")), str(file.with_suffix("")))
