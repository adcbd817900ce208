"""Draws error against work of the integrators, a panel per motion.

usage: simulation.py SIMULATION.json   (writes SIMULATION.png beside it)
"""

import json
import sys

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

import style

INTEGRATORS = {"semi_implicit_euler": "semi-implicit Euler", "rk4": "Runge-Kutta, 4th order",
               "linearly_implicit_euler": "linearly implicit Euler"}
LINES = {"double": "-", "float": ":", "float, compensated": "--"}


def unique(values):
    return list(dict.fromkeys(values))


def kind(row):
    return row["scalar"] + (", compensated" if "compensated" in row["variant"] else "")


def main(file):
    with open(file, encoding="utf-8") as text:
        rows = json.load(text)
    motions = unique((row["subject"], row["robot"]) for row in rows)
    style.use()
    figure, panels = plt.subplots((len(motions) + 1) // 2, 2, figsize=(9, 3.4 * ((len(motions) + 1) // 2)), squeeze=False)
    for panel, motion in zip(panels.flat, motions):
        draw(panel, [row for row in rows if (row["subject"], row["robot"]) == motion])
        panel.set_title(f"{motion[0].removeprefix('simulation, ').replace('_', ' ')}, {motion[1]}")
    for panel in panels[:, 0]:
        panel.set_ylabel("error at the end, rad or m")
    for panel in panels[-1]:
        panel.set_xlabel("evaluations of forward dynamics")
    entries = [Line2D([], [], color=style.COLOURS[i], label=name) for i, name in enumerate(INTEGRATORS.values())]
    entries += [Line2D([], [], color=style.INK, linestyle=line, label=name) for name, line in LINES.items()]
    figure.legend(handles=entries, loc="lower center", ncols=3)
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    style.save(figure, file.removesuffix(".json"), "Error against work of each integrator, on smooth and stiff motions")


def draw(panel, rows):
    panel.set_xscale("log")
    panel.set_yscale("log")
    for i, integrator in enumerate(INTEGRATORS):
        for name, line in LINES.items():
            own = [row for row in rows if row["variant"].split(",")[0] == integrator and kind(row) == name and not row["diverged"]]
            panel.plot([row["work"] for row in own], [row["error"] for row in own], line, color=style.COLOURS[i],
                       marker="o" if name == "double" else None, markersize=3.5)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
