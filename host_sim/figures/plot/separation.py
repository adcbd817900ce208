"""Draws instructions of the ways to a torque, and the error of a slow refresh.

usage: separation.py SEPARATION.json   (writes SEPARATION.png beside it)
"""

import json
import sys

import matplotlib.pyplot as plt
from matplotlib.ticker import MaxNLocator

import style

BARS = [("newton_euler", "each", "Newton-Euler"), ("separation", "once", "separation, once per q"),
        ("separation", "each", "torque from the terms"), ("closed_form", "each", "closed form")]
BOARDS = {"stm32f405": "Cortex-M4F", "nrf51": "Cortex-M0, soft float"}


def bars(panel, board, methods, robots):
    rows = {(row["robot"], row["method"]): row for row in methods}
    for place, (method, part, label) in enumerate(BARS):
        values = [(rows.get((robot, method)) or {}).get(f"{board}_{part}") or 0 for robot in robots]
        panel.barh([i + 0.2 * (place - 1.5) for i in range(len(robots))], values, height=0.19,
                   color=style.COLOURS[(0, 6, 4, 2)[place]], label=label)
    panel.set_yticks(range(len(robots)), robots)
    panel.invert_yaxis()
    panel.xaxis.set_major_locator(MaxNLocator(4))
    panel.set_xlabel("instructions (QEMU)")
    panel.set_title(BOARDS[board], fontsize=9.5)


def rates(panel, rows, robots):
    for i, robot in enumerate(robots):
        own = [row for row in rows if row["robot"] == robot and row["ticks"] > 1]
        ticks = [row["ticks"] for row in own]
        panel.loglog(ticks, [row["error"] for row in own], "o-", color=style.COLOURS[2 * i], label=robot)
        panel.loglog(ticks, [row["error_ahead"] for row in own], "x:", color=style.COLOURS[2 * i])
    panel.set_xlabel("ms between refreshes; crosses: half of it ahead")
    panel.set_ylabel("largest error / largest torque")
    panel.set_title("Two rates along a pick-and-place cycle", fontsize=9.5)
    panel.legend()


def main(file):
    data = json.load(open(file, encoding="utf-8"))
    robots = list(dict.fromkeys(row["robot"] for row in data["two_rate"]))
    style.use()
    figure, panels = plt.subplots(1, 3, figsize=(13.5, 4.2))
    for panel, board in zip(panels, BOARDS):
        bars(panel, board, data["methods"], robots)
    panels[0].legend()
    rates(panels[2], data["two_rate"], robots)
    figure.tight_layout()
    style.save(figure, file.removesuffix(".json"), "Newton-Euler, separation and closed form; what slow refreshes of separated terms lose")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
