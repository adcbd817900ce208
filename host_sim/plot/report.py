"""Draws a report: error against instructions, a panel a kernel.

usage: report.py REPORT.csv   (writes REPORT.png and REPORT.svg beside it)
"""

import csv
import sys

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

import style

TITLES = {
    "inverse_dynamics": "Inverse dynamics, separation, closed form", "forward_dynamics": "Forward dynamics",
    "mass_matrix": "Mass matrix", "bias": "Bias torque", "gravity": "Gravity torque",
    "forward_kinematics": "Forward kinematics", "jacobian": "Jacobian",
}
MARKERS = ["o", "^", "s", "D", "v", "P"]  # boards
FLOOR = 1e-17  # of the error axis; exact results are drawn there


def main(csv_file):
    with open(csv_file, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    jobs = [job for job in TITLES if any(job_of(row) == job for row in rows)]
    robots = unique(row["robot"] for row in rows)
    boards = unique(row["board"] for row in rows)
    style.use()
    height = (len(jobs) + 2) // 2
    figure, grid = plt.subplots(height, 2, figsize=(9, 2.5 * height + 0.4), sharex=True, sharey=True, squeeze=False)
    panels = list(grid.flat)
    for panel, job in zip(panels, jobs):
        draw(panel, [row for row in rows if job_of(row) == job], robots, boards)
        panel.set_title(TITLES[job])
    for panel in panels[len(jobs):]:
        panel.set_axis_off()
    explain(figure, panels[len(jobs)], robots, boards)
    label_axes(grid, rows)
    figure.tight_layout()
    style.save(figure, csv_file.removesuffix(".csv"))


def job_of(row):
    return "inverse_dynamics" if row["subject"] in ("closed_form", "separation") else row["subject"]


def unique(values):
    return list(dict.fromkeys(values))


def draw(panel, rows, robots, boards):
    """Filled: float; hollow: double. A line joins the choices of one robot and board that are on the Pareto front."""
    panel.set_xscale("log")
    panel.set_yscale("log")
    for robot in robots:
        for board in boards:
            colour, marker = style.COLOURS[robots.index(robot)], MARKERS[boards.index(board)]
            here = [row for row in rows if row["robot"] == robot and row["board"] == board]
            front = sorted(point(row) for row in here if row["pareto"] == "true")
            panel.plot([x for x, _ in front], [y for _, y in front], color=colour, linewidth=0.8, alpha=0.7)
            for row in here:
                filled = colour if row["scalar"] == "float" else "white"
                star = "*" if row["subject"] == "closed_form" else marker
                panel.plot(*point(row), star, color=colour, markerfacecolor=filled, markersize=9 if star == "*" else 5.5)


def point(row):
    return float(row["work"]), max(float(row["error"]), FLOOR)


def explain(figure, panel, robots, boards):
    entries = [Line2D([], [], color=style.COLOURS[i], marker="s", linestyle="", label=robot)
               for i, robot in enumerate(robots)]
    entries += [Line2D([], [], color=style.INK, marker=MARKERS[i], linestyle="", label=board)
                for i, board in enumerate(boards)]
    entries += [
        Line2D([], [], color=style.INK, marker="*", linestyle="", markersize=9, label="closed form"),
        Line2D([], [], color=style.INK, marker="o", linestyle="", label="filled: float"),
        Line2D([], [], color=style.INK, marker="o", linestyle="", markerfacecolor="white", label="hollow: double"),
        Line2D([], [], color=style.INK, linewidth=0.8, label="Pareto front"),
    ]
    panel.legend(handles=entries, loc="center", ncols=2)


def label_axes(grid, rows):
    for panel in grid[:, 0]:
        panel.set_ylabel("largest relative error")
    for column in range(2):
        lowest = [panel for panel in grid[:, column] if panel.axison][-1]
        lowest.set_xlabel(f"{rows[0]['unit_of_work']} (largest of the states)")
        lowest.tick_params(labelbottom=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
