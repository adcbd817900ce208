"""Draws error against work: torques and accelerations in time and in bytes, feed-forward at two rates, simulations.

usage: work_precision.py WORK_PRECISION.json
Writes WORK_PRECISION, _bytes, _forward, _two_rate and _simulation (.png) beside it, as far as there are such rows.
"""

import json
import multiprocessing
import sys

import matplotlib.pyplot as plt

import style

PICTURES = {"inverse_dynamics": "", "forward_dynamics": "_forward"}  # job: what follows the picture's stem; the page's tables have the others
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "h"]
FLOOR = 1e-17  # of the error axis; exact results are drawn there
BOARDS = {"stm32f405": "STM32F405, Cortex-M4F with a floating-point unit", "stm32f100": "STM32F100, Cortex-M3", "nrf51": "nRF51822, Cortex-M0",
          "rp2040": "Raspberry Pi Pico, Cortex-M0+", "rp2350_riscv": "Raspberry Pi Pico 2, RISC-V", "rv32_virt": "RV32IMAC"}
ROBOTS = {"scara": "SCARA", "puma560": "Puma 560", "panda": "Panda"}
BESIDE = {"scara": (-2, -15, "center"), "puma560": (-2, -15, "center"), "panda": (9, -3, "left")}  # points, of a robot's name from its last point
NUMBERS = {"fixed16": "16 bits", "fixed32_high": "upper words", "fixed32": "32 bits", "float": "float", "double": "double"}
LABELLED = "scara"  # the robot whose points say their number system: on their left, where no line is
UNITS = {"microseconds": "microseconds", "bytes": "bytes of flash, RAM and stack"}


def unique(values):
    return list(dict.fromkeys(values))


def draw_job(rows, job, unit, stem):
    """A panel a board: a line a robot through its number systems, that says which robot it is; points of one robot say their numbers."""
    rows = [row for row in rows if (row.get("job"), row["subject"], row["unit_of_work"], row.get("variant")) == (job, job, unit, "unrolled") and
            row["board"] in BOARDS and row["robot"] in ROBOTS and row["scalar"] in NUMBERS and row.get("scene") == "bare"]
    boards = [board for board in BOARDS if any(row["board"] == board for row in rows)]
    if not boards:
        return
    columns = min(3, len(boards))
    figure, grid = plt.subplots(-(-len(boards) // columns), columns, figsize=(4.6 * columns, 3.9 * -(-len(boards) // columns)), sharey=True, squeeze=False)
    for panel in list(grid.flat)[len(boards):]:
        panel.set_axis_off()
    for board, panel in zip(boards, grid.flat):
        own = [row for row in rows if row["board"] == board]
        draw_board(panel, own)
        kind = f" ({own[0]['cycles_kind']})" if unit == "microseconds" else ""
        panel.set_title(BOARDS[board])
        panel.set_xlabel(UNITS[unit] + kind)
    for line in grid:
        line[0].set_ylabel("largest error / largest value")
    figure.tight_layout()
    style.save(figure, stem, f"{job.replace('_', ' ').capitalize()}: what an error costs. Left is cheaper, down is more exact; hollow: another is both")


def draw_board(panel, rows):
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.margins(0.3, 0.12)
    for at, robot in enumerate(ROBOTS):
        points = sorted((*point(row), row["scalar"]) for row in rows if row["robot"] == robot)
        if not points:
            continue
        front = [p for p in points if not any(q[0] <= p[0] and q[1] < p[1] or q[0] < p[0] and q[1] <= p[1] for q in points)]
        colour = style.COLOURS[at]
        panel.plot([x for x, _, _ in front], [y for _, y, _ in front], color=colour, linewidth=1.2, alpha=0.6)
        for x, y, scalar in points:
            inside = (x, y, scalar) in front
            panel.plot(x, y, MARKERS[list(NUMBERS).index(scalar)], color=colour, markersize=7, markerfacecolor=colour if inside else "white")
            if robot == LABELLED:
                panel.annotate(NUMBERS[scalar], (x, y), xytext=(-7, -12 if scalar == "fixed32" else 4), textcoords="offset points", ha="right", fontsize=9)
        right, up, side = BESIDE[robot]
        panel.annotate(ROBOTS[robot], front[-1][:2], xytext=(right, up), textcoords="offset points", ha=side, fontsize=10, color=colour, fontweight="bold")


def point(row):
    return row["work"], max(row["error"], FLOOR)


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
    pictures = [(draw_job, rows, job, "microseconds", stem + more) for job, more in PICTURES.items()]
    pictures += [(draw_job, rows, "inverse_dynamics", "bytes", stem + "_bytes"), (draw_simulation, rows, stem + "_simulation"),
                (draw_two_rate, rows, stem + "_two_rate")]
    with multiprocessing.Pool() as pool:
        pool.map(draw, pictures, chunksize=1)


def draw(picture):
    function, *arguments = picture
    function(*arguments)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
