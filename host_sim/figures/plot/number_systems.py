"""Draws error against instructions of every number system, a panel per kernel.

usage: number_systems.py NUMBER_SYSTEMS.json   (writes NUMBER_SYSTEMS.png beside it)
"""

import json
import sys

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

import style

MARKERS = ["o", "s", "^", "D", "v", "P"]  # boards
NAMES = {"fixed16": "16 bits", "fixed32_down": "32 bits, down", "fixed32": "32 bits, nearest",
         "fixed32_high": "32 bits, upper words", "float": "float", "double": "double"}


def unique(values):
    return list(dict.fromkeys(values))


def main(file):
    with open(file, encoding="utf-8") as text:
        rows = json.load(text)
    kernels, boards = unique((row["robot"], row["algorithm"]) for row in rows), unique(row["board"] for row in rows)
    style.use()
    figure, panels = plt.subplots(2, (len(kernels) + 1) // 2, figsize=(9, 7.6), sharex=True, sharey=True, squeeze=False)
    for panel, (robot, algorithm) in zip(panels.flat, kernels):
        draw(panel, [row for row in rows if (row["robot"], row["algorithm"]) == (robot, algorithm)], boards)
        panel.set_title(f"{robot}, {algorithm.replace('_', ' ')}")
    for panel in panels[:, 0]:
        panel.set_ylabel("largest error / largest torque")
    for panel in panels[-1]:
        panel.set_xlabel("instructions (QEMU)")
    entries = [Line2D([], [], color=style.COLOURS[i], marker="s", linestyle="", label=name)
               for i, name in enumerate(NAMES.values())]
    entries += [Line2D([], [], color=style.INK, marker=MARKERS[i], markerfacecolor="white", linestyle="", label=board)
                for i, board in enumerate(boards)]
    figure.legend(handles=entries, loc="lower center", ncols=5)
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    style.save(figure, file.removesuffix(".json"), "Error against instructions of fixed point, float and double on each board")


def draw(panel, rows, boards):
    panel.set_xscale("log")
    panel.set_yscale("log")
    for i, scalar in enumerate(NAMES):
        own = [row for row in rows if row["scalar"] == scalar]
        panel.plot([row["instructions"] for row in own], [row["error"] for row in own], color=style.COLOURS[i], linewidth=0.8,
                   alpha=0.6)
        for row in own:
            panel.plot(row["instructions"], row["error"], MARKERS[boards.index(row["board"])], color=style.COLOURS[i],
                       markersize=6)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
