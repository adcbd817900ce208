"""Pictures of what each robot costs: microseconds against joints, a panel per board; the torque's error against microseconds, a panel per robot.

usage: gallery.py ROWS.json STEM     writes STEM-joints.png and STEM-errors.png
"""

import json
import pathlib
import sys

import style
from style import plt

KERNELS = (("inverse_dynamics", "torque", style.COLOURS[0]), ("forward_dynamics", "forward dynamics", style.COLOURS[1]))
NUMBERS = (("float", "o", True), ("fixed32", "s", False))  # name, marker, filled
COLUMNS = 4  # panels of robots in a line
TICK_US = 1000.0


def look(colour, marker, filled, size):
    return {"marker": marker, "color": colour, "markerfacecolor": colour if filled else "white", "markersize": size, "linestyle": "none", "markeredgewidth": 1.2}


def legend_of(axes, entries, **options):
    """Entries (text, look) of a legend, drawn nowhere else."""
    axes.legend(handles=[plt.Line2D([], [], label=text, **given) for text, given in entries], **options)


def points(rows, algorithm, number):
    return [row for row in rows if (row["algorithm"], row["number"]) == (algorithm, number) and row.get("joints")]


def draw_board(axes, rows, board):
    """Robots of as many joints stand beside each other: number systems to either side."""
    for algorithm, _, colour in KERNELS:
        for (number, marker, filled), aside in zip(NUMBERS, (-0.12, 0.12)):
            found = points(rows, algorithm, number)
            axes.plot([row["joints"] + aside for row in found], [row["microseconds"] for row in found], **look(colour, marker, filled, 5))
    axes.axhline(TICK_US, color=style.INK, linewidth=0.8, linestyle="--")
    axes.set(title=board, yscale="log", xlabel="joints")


def draw_joints(rows, boards, stem):
    figure, grid = plt.subplots((len(boards) + 2) // 2, 2, figsize=(7.6, 8.6), sharex=True, sharey=True, squeeze=False)
    panels = list(grid.flat)
    for axes, board in zip(panels, boards):
        draw_board(axes, [row for row in rows if row["board"] == board], board)
        axes.xaxis.set_major_locator(plt.MaxNLocator(integer=True))
        axes.tick_params(labelbottom=True, labelleft=True)
    for axes in panels[len(boards):]:
        axes.axis("off")
    for axes in grid[:, 0]:
        axes.set_ylabel("microseconds")
    entries = [(f"{text}, {number}", look(colour, marker, filled, 6)) for _, text, colour in KERNELS for number, marker, filled in NUMBERS]
    legend_of(panels[len(boards)], [*entries, ("a tick of 1 ms", {"color": style.INK, "linewidth": 0.8, "linestyle": "--"})], loc="center left", fontsize=11)
    figure.tight_layout()
    style.save(figure, stem, "Microseconds of a call by the cores' models; nothing ran on silicon")


def draw_robot(axes, rows, name, boards):
    for board, colour in zip(boards, style.COLOURS):
        for number, marker, filled in NUMBERS:
            found = [row for row in points(rows, "inverse_dynamics", number) if row["board"] == board and row.get("error")]
            axes.plot([row["microseconds"] for row in found], [row["error"] for row in found], **look(colour, marker, filled, 5))
    axes.set(xscale="log", yscale="log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(plt.LogLocator(base=100.0 if axis is axes.xaxis else 10.0, numticks=9))
        axis.set_minor_locator(plt.NullLocator())
    axes.tick_params(labelbottom=True, labelleft=True, labelsize=8)
    axes.set_title(name, fontsize=10)


def limits(values):
    """Whole decades around all values, and a little more."""
    return 10.0 ** (min(map(exponent, values)) - 0.2), 10.0 ** (max(map(exponent, values)) + 1.2)


def exponent(value):
    return int(f"{value:e}".partition("e")[2])


def draw_errors(rows, boards, stem):
    rows = [row for row in rows if row["algorithm"] == "inverse_dynamics" and row.get("error")]
    names = list(dict.fromkeys(row["robot"] for row in rows))
    lines = -(-len(names) // COLUMNS)
    figure, grid = plt.subplots(lines, COLUMNS, figsize=(7.6, 1.2 + 1.55 * lines), sharex=True, sharey=True, squeeze=False)
    for axes, name in zip(grid.flat, names):
        draw_robot(axes, [row for row in rows if row["robot"] == name], name, boards)
    for axes in list(grid.flat)[len(names):]:
        axes.axis("off")
    grid[0, 0].set(xlim=limits([row["microseconds"] for row in rows]), ylim=limits([row["error"] for row in rows]))
    entries = [(board, look(colour, "o", True, 6)) for board, colour in zip(boards, style.COLOURS)]
    entries += [(number, look(style.INK, marker, filled, 6)) for number, marker, filled in NUMBERS]
    figure.tight_layout(rect=(0.03, 0.25 / figure.get_figheight(), 1, 1 - 0.6 / figure.get_figheight()))
    legend_of(figure, entries, loc="upper center", ncol=4, bbox_to_anchor=(0.5, 1.0), handletextpad=0.2, columnspacing=1.2)
    figure.supxlabel("microseconds of a torque", fontsize=10, y=0.0)
    figure.supylabel("error over the joint's largest torque", fontsize=10, x=0.0)
    style.save(figure, stem, "The torque's error against its time")


def main():
    rows = [row for row in json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")) if "why" not in row]
    boards = list(dict.fromkeys(row["board"] for row in rows))
    style.use()
    draw_joints(rows, boards, sys.argv[2] + "-joints")
    draw_errors(rows, boards, sys.argv[2] + "-errors")


if __name__ == "__main__":
    main()
