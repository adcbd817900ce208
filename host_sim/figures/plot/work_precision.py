"""Draws error against work: kernels in time (in instructions where cycles are an estimate) and in bytes, feed-forward at two rates, simulations.

usage: work_precision.py WORK_PRECISION.json
Writes WORK_PRECISION, _bytes, _two_rate and _simulation (.png) beside it, as far as there are such rows.
"""

import json
import multiprocessing
import sys

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

import style
from number_systems import NAMES

JOBS = {"inverse_dynamics": "Inverse dynamics", "forward_dynamics": "Forward dynamics", "mass_matrix": "Mass matrix", "bias": "Bias torque",
        "gravity": "Gravity torque", "forward_kinematics": "Forward kinematics", "jacobian": "Jacobian",
        "inverse_dynamics_derivatives": "ID derivatives", "forward_dynamics_derivatives": "FD derivatives", "elastic_feedforward": "Elastic joints"}
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "h"]  # robots
FLOOR = 1e-17  # of the error axis; exact results are drawn there
CLOSED = ("closed_form",)
BOARDS = ("stm32f405", "stm32f100", "nrf51", "rp2040", "rv32_virt")  # others repeat one of them


DRAWN = ("scara", "puma560", "panda")  # in every number system; the page's tables have the others


def unique(values):
    return list(dict.fromkeys(values))


def draw_kernels(rows, unit, stem):
    """A row of panels a job, a column per board; colour: number system, marker: robot. A line joins a robot's front."""
    rows = [row for row in rows if row.get("job") in JOBS and row["unit_of_work"] == unit_of(row, unit) and row["robot"] in DRAWN]
    if not rows:
        return
    jobs = [job for job in JOBS if any(row["job"] == job for row in rows)]
    there, robots = {row["board"] for row in rows}, unique(row["robot"] for row in rows)
    boards = [board for board in BOARDS if board in there] or sorted(there)
    figure, grid = plt.subplots(len(jobs), len(boards), figsize=(max(2.5 * len(boards) + 0.6, 7), 1.9 * len(jobs) + 1.2), sharex="col",
                                sharey=True, squeeze=False)
    for job, line in zip(jobs, grid):
        for board, panel in zip(boards, line):
            own = [row for row in rows if (row["job"], row["board"]) == (job, board)]
            draw_panel(panel, own, robots) if own else panel.set_axis_off()
        line[0].set_ylabel(f"{JOBS[job]}\nlargest error")
    for board, panel in zip(boards, grid[0]):
        panel.set_title(board)
    for board, column in zip(boards, grid.T):
        lowest = [panel for panel in column if panel.axison][-1]
        lowest.set_xlabel(label_of(next(row for row in rows if row["board"] == board)))
        lowest.tick_params(labelbottom=True)
    explain(figure, robots)
    style.save(figure, stem, f"Error against {unit} of each job on each board")


def unit_of(row, unit):
    """Time where cycles are known; elsewhere instructions stand for it."""
    if unit != "time":
        return unit
    return "instructions" if row["cycles_kind"] == "estimate" else "microseconds"


def label_of(row):
    return {"instructions": "instructions (QEMU)", "bytes": "bytes: flash, RAM, stack",
            "microseconds": f"us, {row['core']}, {row['cycles_kind']}"}[row["unit_of_work"]]


def draw_panel(panel, rows, robots):
    panel.set_xscale("log")
    panel.set_yscale("log")
    for robot in robots:
        own = [row for row in rows if row["robot"] == robot]
        front = sorted(point(row) for row in own if row["pareto"])
        panel.plot([x for x, _ in front], [y for _, y in front], color=style.INK, linewidth=0.7, alpha=0.5)
        for row in own:
            colour = style.COLOURS[list(NAMES).index(row["scalar"])]
            star = row["subject"] in CLOSED
            panel.plot(*point(row), "*" if star else MARKERS[robots.index(robot)], color=colour, markersize=8 if star else 5,
                       markerfacecolor=colour if row["pareto"] else "white")


def point(row):
    return row["work"], max(row["error"], FLOOR)


def explain(figure, robots):
    entries = [Line2D([], [], color=style.COLOURS[i], marker="s", linestyle="", label=name) for i, name in enumerate(NAMES.values())]
    entries += [Line2D([], [], color=style.INK, marker=MARKERS[i], markerfacecolor="white", linestyle="", label=robot)
                for i, robot in enumerate(robots)]
    entries += [Line2D([], [], color=style.INK, marker="*", linestyle="", markersize=9, label="closed form"),
                Line2D([], [], color=style.INK, marker="o", linewidth=0.7, label="filled, joined: the robot's Pareto front")]
    columns = int(figure.get_size_inches()[0] / 2.1)
    figure.legend(handles=entries, loc="lower center", ncols=columns)
    bottom = (0.15 + 0.2 * -(-len(entries) // columns)) / figure.get_size_inches()[1]
    figure.tight_layout(rect=(0, bottom, 1, 1))


def draw_two_rate(rows, stem):
    """Error against the refresh, and against the work of a tick: average, and the one that refreshes."""
    rows = [row for row in rows if row["subject"] == "two_rate_feedforward" and row["ticks"] > 1]
    if not rows:
        return
    board = rows[0]["board"]
    rows = [row for row in rows if row["board"] == board]
    robots = unique(row["robot"] for row in rows)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4.2), sharey=True)
    for i, robot in enumerate(robots):
        for ahead, dash in ((False, "-"), (True, "--")):
            own = [row for row in rows if row["robot"] == robot and ("ahead" in row["variant"]) == ahead]
            left.plot([row["ticks"] for row in own], [row["error"] for row in own], dash, color=style.COLOURS[i], marker=MARKERS[i],
                      label=None if ahead else robot)
            right.plot([row["work"] for row in own], [row["error"] for row in own], dash, color=style.COLOURS[i], marker=MARKERS[i])
        right.axvline(own[0]["work_full_rate"], color=style.COLOURS[i], linewidth=0.7, linestyle=":")
        right.plot(own[-1]["work_worst"], own[-1]["error"], ">", color=style.COLOURS[i], markerfacecolor="white")
    for panel in (left, right):
        panel.set_xscale("log")
        panel.set_yscale("log")
    left.set_ylabel("largest error / largest torque")
    left.set_xlabel("ticks of 1 ms between refreshes (dashed: ahead)")
    right.set_xlabel(f"instructions per tick, average ({board}, QEMU)\ndotted: full rate; hollow: the tick that refreshes")
    ticks = unique(row["ticks"] for row in rows)
    left.set_xticks(ticks, map(str, ticks))
    left.minorticks_off()
    left.legend()
    figure.tight_layout()
    style.save(figure, stem, "Feed-forward with terms that are refreshed slowly: error, and work per tick")


def draw_simulation(rows, stem):
    """A panel per robot or scenario and unit of work; a line an integrator."""
    rows = [row for row in rows if "job" not in row and row["subject"] != "two_rate_feedforward" and not row.get("diverged")]
    panels = unique((row["subject"], row["robot"], row["unit_of_work"]) for row in rows)
    if not panels:
        return
    columns = min(3, len(panels))
    lines = -(-len(panels) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(3.6 * columns + 1, 3.2 * lines + 0.6), squeeze=False)
    for panel in list(grid.flat)[len(panels):]:
        panel.set_axis_off()
    names = unique(curve(row) for row in rows)
    for panel, key in zip(grid.flat, panels):
        own = [row for row in rows if (row["subject"], row["robot"], row["unit_of_work"]) == key]
        for name in unique(curve(row) for row in own):
            points = sorted(point(row) for row in own if curve(row) == name)
            i = names.index(name)
            panel.plot([x for x, _ in points], [y for _, y in points], marker=MARKERS[i % len(MARKERS)], color=style.COLOURS[i % len(style.COLOURS)],
                       linestyle="-" if i < len(style.COLOURS) else "--", markersize=4, label=name)
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.set_title(f"{key[0].replace('simulation, ', '').replace('_', ' ').capitalize()}, {key[1]}", fontsize=9)
        panel.set_xlabel(key[2])
    grid[0, 0].set_ylabel("global error")
    handles = {label: handle for panel in grid.flat for handle, label in zip(*panel.get_legend_handles_labels())}
    figure.legend(handles.values(), handles.keys(), loc="lower center", ncols=3)
    figure.tight_layout(rect=(0, (0.3 + 0.2 * -(-len(handles) // 3)) / figure.get_size_inches()[1], 1, 1))
    style.save(figure, stem, "Simulations: error against work")


def curve(row):
    return f"{row['variant'].replace('_', ' ')}, {row['scalar']}"


def main(file):
    with open(file, encoding="utf-8") as text:
        rows = json.load(text)
    style.use()
    plt.rcParams.update({"font.size": 8, "axes.titlesize": 9})
    stem = file.removesuffix(".json")
    pictures = [(draw_kernels, rows, "time", stem), (draw_kernels, rows, "bytes", stem + "_bytes"), (draw_simulation, rows, stem + "_simulation"),
                (draw_two_rate, rows, stem + "_two_rate")]
    with multiprocessing.Pool() as pool:  # the first two take ten seconds each
        pool.map(draw, pictures, chunksize=1)


def draw(picture):
    function, *arguments = picture
    function(*arguments)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
