"""Draws flash against instructions of every kernel, and what a scene's features add.

usage: size.py SIZE.json   (writes SIZE.png beside it)
"""

import json
import pathlib
import sys

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D
from matplotlib.ticker import StrMethodFormatter

import style

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "boards/size"))
import routes  # noqa: E402

# Gravity and bias torque are parts of inverse dynamics: not drawn.
MARKERS = {"inverse_dynamics": "o", "closed_form": "*", "mass_matrix": "s",
           "forward_dynamics": "D", "inverse_dynamics_derivatives": "v", "forward_dynamics_derivatives": "^",
           "forward_kinematics": "P", "jacobian": "X", "feedforward": "h"}
SCENES = ["bare", "without_gravity", "without_rotors", "friction", "payload", "tip_wrench"]


def main(json_file):
    with open(json_file, encoding="utf-8") as file:
        rows = [row for row in json.load(file) if (row["scalar"], row["contract"]) == ("float", "off")]
    if not rows:
        return
    boards, robots = unique(row["board"] for row in rows), unique(row["robot"] for row in rows)
    style.use()
    described = [board for board in boards if any(
        (row["board"], row["algorithm"]) == (board, "inverse_dynamics") and row["scene"] in SCENES[1:] for row in rows)]
    columns = min(3, len(boards))
    lines = -(-len(boards) // columns)
    figure, grid = plt.subplots(lines + bool(described), columns, figsize=(3.8 * columns, 3.3 * (lines + 1)), squeeze=False)
    panels = iter(grid[:lines].flat)
    for board, panel in zip(boards, panels):
        here = [row for row in rows if row["board"] == board and row["scene"] == "bare" and marker_of(row)]
        draw_kernels(panel, here, robots)
        panel.set_title(board)
    last = iter(grid[lines] if described else ())
    for board, panel in zip(described, last):
        draw_scenes(panel, [row for row in rows if row["board"] == board and row["algorithm"] == "inverse_dynamics"], robots)
        panel.set_title(f"{board}, inverse dynamics", fontsize=10)
    for panel in (*panels, *last):
        panel.set_axis_off()
    for line in grid[:lines]:
        line[0].set_ylabel("flash, bytes (hollow: compact)")
    explain(figure, rows, robots)
    figure.tight_layout(rect=(0, 0.075, 1, 1))
    style.save(figure, json_file.removesuffix(".json"), "Flash against instructions of each kernel in float, and what features of a scene add")


def unique(values):
    return list(dict.fromkeys(values))


def draw_kernels(panel, rows, robots):
    """Filled: unrolled; hollow: compact."""
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlabel("instructions per call")
    for row in rows:
        colour = style.COLOURS[robots.index(row["robot"])]
        panel.plot(row["instructions"], row["flash_bytes"], marker_of(row), color=colour, markersize=6, markeredgewidth=0.9,
                   markerfacecolor=colour if row["variant"] == "unrolled" else "white", zorder=3)


def marker_of(row):
    """Routes of an algorithm share its marker."""
    return MARKERS.get(routes.job_of(row["algorithm"]))


def draw_scenes(panel, rows, robots):
    rows = [row for row in rows if row["variant"] == "unrolled"]
    shown = [robot for robot in robots if any(row["robot"] == robot and row["scene"] != "bare" for row in rows)]
    scenes = [scene for scene in SCENES if any(row["scene"] == scene for row in rows)]
    for at, robot in enumerate(shown):
        found = {row["scene"]: row["instructions"] for row in rows if row["robot"] == robot}
        bare = found.get("bare", 1)
        panel.barh([i + 0.26 * (at - (len(shown) - 1) / 2) for i in range(len(scenes))],
                   [100 * found.get(scene, 0) / bare for scene in scenes], height=0.24,
                   color=style.COLOURS[robots.index(robot)])
    panel.set_yticks(range(len(scenes)), [scene.replace("_", " ") for scene in scenes])
    panel.invert_yaxis()
    panel.xaxis.set_major_formatter(StrMethodFormatter("{x:.0f} %"))
    panel.set_xlabel("instructions, relative to the bare scene")


def explain(figure, rows, robots):
    algorithms = [name for name in MARKERS if any(routes.job_of(row["algorithm"]) == name for row in rows)]
    entries = [Line2D([], [], color=style.COLOURS[i], marker="s", linestyle="", label=robot)
               for i, robot in enumerate(robots)]
    entries += [Line2D([], [], color=style.INK, marker=MARKERS[name], linestyle="", label=name.replace("_", " "))
                for name in algorithms]
    figure.legend(handles=entries, loc="lower center", ncols=5)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
