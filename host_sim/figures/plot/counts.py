"""Draws operations (M + A) of every count model beside published ones, and of the real robots.

usage: counts.py PUBLISHED.json COUNTS.json   (writes COUNTS.png beside it)
"""

import json
import sys

import matplotlib.pyplot as plt

import style

PANELS = [("inverse_dynamics", "base", "Inverse dynamics"), ("mass_matrix", "base", "Mass matrix"),
          ("composite_body", "base", "Forward dynamics, composite bodies"),
          ("articulated_body", "full", "Forward dynamics, ABA, full parameters")]
SERIES = [("open_symoro", "openSYMORO", 6), ("reachable", "reachable", 4), ("ours", "axial", 0)]


def main(published_file, counts_file):
    published, counts = (json.load(open(file, encoding="utf-8")) for file in (published_file, counts_file))
    bars = {(row["robot"], row["algorithm"], row["parameters"]): row for row in published["rows"]}
    robots = list(dict.fromkeys(row["robot"] for row in counts))
    style.use()
    figure, panels = plt.subplots(1, len(PANELS), figsize=(3.4 * len(PANELS), 1.2 + 0.42 * len(robots)), sharey=True)
    for panel, (algorithm, parameters, title) in zip(panels, PANELS):
        rows = {row["robot"]: row for row in counts if (row["algorithm"], row["parameters"]) == (algorithm, parameters)}
        for place, (name, label, colour) in enumerate(SERIES):
            values = [value_of(name, rows.get(robot), bars.get((robot, algorithm, parameters), {})) for robot in robots]
            panel.barh([i + 0.27 * (place - 1) for i in range(len(robots))], values, height=0.25,
                       color=style.COLOURS[colour], label=label)
        panel.set_title(title, fontsize=9.5)
        panel.set_xlabel("multiplications + additions")
    panels[0].set_yticks(range(len(robots)), robots)
    panels[0].invert_yaxis()
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=len(SERIES))
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    style.save(figure, counts_file.removesuffix(".json"), "Operations of each algorithm beside those of a symbolic generator")


def value_of(name, row, bar):
    if name == "ours":
        return row["mul"] + row["add"] if row else 0
    return sum(bar.get(name, [0]))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
