"""Joins the rows of the stability suite and draws them.

usage: stability.py FOLDER ROWS.json... --data FOLDER [--json FILE]

Writes stability.json and stability_provenance.json into the data folder, and stability-scenarios, stability-condition and, where
there are rows of other engines, stability-engines (PNG and SVG) into FOLDER. --json: the rows once more.
"""

import argparse
import json
import os
import pathlib
import re

import matplotlib.pyplot as plt

import speed
import style

ROUTES = {"articulated_body": "ABA", "split_articulated_body": "split ABA", "composite_body": "composite bodies", "default": "default route"}
ENGINES = {"kdl": "KDL", "kdl_vereshchagin": "KDL, Vereshchagin", "dart": "DART", "simbody": "Simbody", "bullet": "Bullet"}
SCALARS = ["double", "float"]
EPSILON = {"double": 2.0 ** -52, "float": 2.0 ** -23}
PACKAGES = ["liborocos-kdl1.5", "libdart6.12", "libsimbody3.7", "libbullet3.24"]
CACHED = ("CMAKE_CXX_COMPILER", "CMAKE_CXX_FLAGS", "CMAKE_CXX_FLAGS_RELEASE")


def unique(values):
    return list(dict.fromkeys(values))


def family(row):
    return int(row["family"][2:])


def gated(rows):
    """Rows of ours that have an error, by family."""
    found = [row for row in rows if row["kind"] == "gate" and row["forward_error"] is not None and
             not row["scenario"].startswith("S12_bits") and row["condition"] is not None]
    return sorted(found, key=family)


def of(rows, **wanted):
    return [row for row in rows if all(row[name] == value for name, value in wanted.items())]


def shown(error, scalar, largest=1e2):
    """Exact answers stand near the lower edge, worthless ones at the upper."""
    return min(max(error, EPSILON[scalar] / 32), largest)


def draw_scenarios(rows, stem):
    names = unique(row["scenario"] for row in gated(rows))
    if len(names) < 2:
        return
    place = {name: i for i, name in enumerate(names)}
    figure, panels = plt.subplots(2, 1, figsize=(13.0, 8.6), sharex=True)
    for panel, scalar in zip(panels, SCALARS):
        chosen = [row for row in gated(rows) if row["scalar"] == scalar]
        for colour, (route, label) in zip(style.COLOURS, ROUTES.items()):
            own = of(chosen, route=route)
            panel.semilogy([place[row["scenario"]] for row in own], [shown(row["forward_error"], scalar) for row in own],
                           "o", color=colour, markersize=4.5 if route == "articulated_body" else 3, label=label)
        gates = [row for row in of(chosen, route="articulated_body") if row["gate"]]
        panel.semilogy([place[row["scenario"]] for row in gates], [row["gate"] for row in gates], "_", color=style.INK,
                       markersize=7, label="gate of ABA")
        if scalar == "float":
            fixed = of(gated(rows), scalar="fixed32")
            panel.semilogy([place[row["scenario"]] for row in fixed], [row["forward_error"] for row in fixed], "D",
                           color=style.COLOURS[3], markersize=4, label="32-bit fixed point")
        panel.axhline(EPSILON[scalar], color=style.FAINT, linewidth=1.2)
        panel.set_ylim(EPSILON[scalar] / 50, 1e5)
        panel.set_title(f"forward error, {scalar} (line: eps; lowest: exact; 1e2: that or more)")
        panel.legend(ncols=5, loc="upper left", fontsize=8)
    panels[1].set_xticks(range(len(names)), names, rotation=90, fontsize=6.5)
    panels[1].set_xlim(-1, len(names))
    figure.tight_layout()
    style.save(figure, stem, "Forward error of each route on each scenario")


def draw_condition(rows, stem):
    chosen = [row for row in gated(rows) if not row["forward_error_absolute"] and not row["scenario"].startswith("S03_grow")]
    if not chosen:
        return
    figure, panels = plt.subplots(1, 2, figsize=(11.0, 4.4))
    for panel, scalar in zip(panels, SCALARS):
        for colour, (route, label) in zip(style.COLOURS, ROUTES.items()):
            own = [row for row in of(chosen, scalar=scalar, route=route)]
            panel.loglog([row["condition"] for row in own], [shown(row["forward_error"], scalar) for row in own], "o",
                         color=colour, markersize=4, label=label)
        limits = [1.0, 1e30]
        panel.loglog(limits, [2 * EPSILON[scalar] * x for x in limits], color=style.INK, linewidth=0.8, label="2 cond eps")
        panel.set_ylim(EPSILON[scalar] / 50, 1e3)
        panel.set_xlim(0.5, 1e30)
        panel.set_title(scalar)
        panel.set_xlabel("cond(M)")
        panel.legend(loc="upper right", fontsize=8)
    panels[0].set_ylabel("forward error")
    figure.tight_layout()
    style.save(figure, stem, "Forward error against the conditioning of M: what solves with M follows it")


def compared(rows):
    """Rows of the engines in double with their medians, by family."""
    found = [row for row in rows if row["kind"] == "peer" and row["scalar"] == "double" and not row["status"].startswith("answers")]
    return sorted(found, key=family)


def draw_engines(rows, stem):
    chosen = compared(rows)
    names = unique(row["scenario"] for row in chosen)
    if len(names) < 2:
        return
    place = {name: i for i, name in enumerate(names)}
    figure, panel = plt.subplots(figsize=(13.0, 5.2))
    for colour, (engine, label) in zip(style.COLOURS[1:], ENGINES.items()):
        own = of(chosen, route=engine)
        errors = [1e2 if row["median_error"] is None else shown(row["median_error"], "double") for row in own]
        panel.semilogy([place[row["scenario"]] for row in own], errors, "o", color=colour, markersize=3.5, label=label)
    ours = {row["scenario"]: shown(row["our_median_error"], "double") for row in chosen}
    panel.semilogy([place[name] for name in ours], list(ours.values()), "s", color=style.COLOURS[0], markersize=4.5,
                   label="axial, ABA", zorder=3)
    panel.set_ylim(EPSILON["double"] / 50, 1e4)
    panel.set_title("median forward error of perturbed instances, double (1e2: that, NaN or an end of the process)")
    panel.legend(ncols=6, loc="upper left", fontsize=8)
    panel.set_xticks(range(len(names)), names, rotation=90, fontsize=6.5)
    panel.set_xlim(-1, len(names))
    figure.tight_layout()
    style.save(figure, stem, "Forward error beside other engines, in double")


def provenance():
    cache = speed.ROOT / "build" / os.environ.get("AXIAL_HOST_PRESET", "host-release") / "CMakeCache.txt"
    entries = dict(re.findall(r"^(\w+):\w+=(.*)$", cache.read_text(encoding="utf-8"), re.MULTILINE))
    compiler = speed.output_of(entries["CMAKE_CXX_COMPILER"], "--version").split("\n")[0]
    versions = [speed.output_of("dpkg-query", "-W", "-f", "${Package} ${Version}", package) for package in PACKAGES]
    return {"compiler": compiler, "flags": " ".join(entries[name] for name in CACHED[1:]),
            "packages": [version for version in versions if version], "commit": speed.commit()}


def write_rows(path, rows):
    """A row per line."""
    lines = ",\n".join(json.dumps(row) for row in rows)
    pathlib.Path(path).write_text(f"[\n{lines}\n]\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--json")
    options = parser.parse_args()
    rows = [{"kind": "integrator", **row} for row in speed.load(options.files)]
    style.use()
    draw_scenarios(rows, str(options.folder / "stability-scenarios"))
    draw_condition(rows, str(options.folder / "stability-condition"))
    draw_engines(rows, str(options.folder / "stability-engines"))
    write_rows(options.data / "stability.json", rows)
    speed.write(options.data / "stability_provenance.json", provenance())
    if options.json:
        write_rows(options.json, rows)
    print(f"written: stability.json in {options.data}, pictures stability-*.png in {options.folder}")


if __name__ == "__main__":
    main()
