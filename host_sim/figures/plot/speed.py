"""Draws a host benchmark: ratios of every robot, and time against the number of joints.

usage: speed.py FOLDER BENCH.json... [--json FILE] [--provenance FILE]

Writes FOLDER/speed-ratios.png and FOLDER/speed-joints.png from the rows of axial_bench (tests/bench), a file
a compiler, and prints the exponents of N. --json: all rows in one file. --provenance: processor, packages, flags, commit.
"""

import argparse
import json
import math
import pathlib
import subprocess

import matplotlib.pyplot as plt
from matplotlib.ticker import NullFormatter, ScalarFormatter

import style

ROOT = pathlib.Path(__file__).resolve().parents[3]
ALGORITHMS = {"inverse_dynamics": "Inverse dynamics", "forward_dynamics": "Forward dynamics",
              "articulated_body": "ABA", "split_articulated_body": "Split ABA",
              "composite_body": "Composite bodies", "mass_matrix": "Mass matrix", "bias": "Bias torque", "gravity": "Gravity torque"}
ROUTES = ["articulated_body", "split_articulated_body", "composite_body"]  # of forward dynamics, by name
PEERS = {"kdl": "KDL", "kdl_vereshchagin": "KDL, Vereshchagin", "dart": "DART"}
ONE_STATE = "one state"  # the peer of our batches: ours
OF_DERIVATIVES = {"inverse_dynamics_derivatives": "inverse dynamics", "forward_dynamics_derivatives": "forward dynamics"}  # their peers: ours
PACKAGES = ["liborocos-kdl1.5", "libdart6.12"]


def load(files):
    return [row for file in files for row in json.loads(pathlib.Path(file).read_text(encoding="utf-8"))]


def unique(values):
    return list(dict.fromkeys(values))


def is_serial(row):
    return row["robot"].startswith("serial_")


def against_others(rows):
    return [row for row in rows if row["peer"] not in (ONE_STATE, *OF_DERIVATIVES.values())]


def worse_compiler(rows):
    """One row per robot, algorithm, scalar and peer: that of the compiler with the smaller ratio."""
    worst = {}
    for row in rows:
        key = row["robot"], row["algorithm"], row["scalar"], row["peer"]
        if key not in worst or row["ratio"] < worst[key]["ratio"]:
            worst[key] = row
    return worst


def draw_ratios(rows, stem):
    chosen = {key: row for key, row in worse_compiler(rows).items() if row["scalar"] == "double" and not is_serial(row)}
    algorithms = [name for name in ALGORITHMS if name not in ROUTES and any(key[1] == name for key in chosen)]
    robots = unique(key[0] for key in chosen)
    if not algorithms:
        return
    figure, panels = plt.subplots(1, len(algorithms), figsize=(2.4 * len(algorithms) + 1.2, 3.8), sharey=True, squeeze=False)
    for panel, algorithm in zip(panels[0], algorithms):
        draw_bars(panel, [row for key, row in chosen.items() if key[1] == algorithm], robots)
        panel.set_title(ALGORITHMS[algorithm])
    panels[0][0].set_yticks(range(len(robots)), robots)
    panels[0][0].invert_yaxis()
    handles = [plt.Rectangle((0, 0), 1, 1, color=style.COLOURS[i]) for i in range(len(PEERS))]
    figure.supxlabel("peer's time over axial's, double, the worse of gcc and clang; lines: 95 % interval", fontsize=9)
    figure.legend(handles, PEERS.values(), loc="upper right", ncols=len(PEERS))
    figure.tight_layout(rect=(0, 0, 1, 0.92))
    style.save(figure, stem, "How many times as fast as other libraries, on the host")


def draw_bars(panel, rows, robots):
    height = 0.8 / len(PEERS)
    panel.set_xscale("log")
    panel.axvline(1.0, color=style.INK, linewidth=0.8)
    panel.grid(axis="y", visible=False)
    for row in rows:
        peer = list(PEERS).index(row["peer"])
        y = robots.index(row["robot"]) + (peer - (len(PEERS) - 1) / 2) * height
        panel.barh(y, row["ratio"] - 1, height, left=1, color=style.COLOURS[peer])
        panel.plot([row["ratio_low"], row["ratio_high"]], [y, y], color=style.INK, linewidth=1)
        panel.text(row["ratio_high"] * 1.1, y, f"{row['ratio']:.0f}", va="center", fontsize=7)
    panel.set_xlim(0.8, max(row["ratio_high"] for row in rows) * 2.2)


def curves(rows):
    """{(compiler, label): [(joints, ns)]} of forward dynamics; ours once a route."""
    found = {}

    def add(row, label, time):
        found.setdefault((row["compiler"], label), []).append((row["joints"], row[time]))

    for row in filter(is_serial, rows):
        if row["algorithm"] == "composite_body":
            add(row, "axial, composite bodies", "ns_noise")
        elif row["algorithm"] == "forward_dynamics":
            add(row, PEERS[row["peer"]], "peer_ns_noise")
            if row["peer"] == "kdl_vereshchagin":
                add(row, "axial, ABA", "ns_noise")
    return found


def exponent(points, smallest=8):
    """Slope of log time over log N, by least squares, where N is large."""
    logs = [(math.log(n), math.log(t)) for n, t in points if n >= smallest]
    if len(logs) < 2:
        return None
    mean_x, mean_y = (sum(column) / len(logs) for column in zip(*logs))
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs)


def draw_joints(rows, stem):
    found = curves(rows)
    if not found:
        return
    compilers = unique(compiler for compiler, _ in found)
    labels = sorted(unique(label for _, label in found), key=lambda label: not label.startswith("axial"))
    figure, panels = plt.subplots(1, len(compilers), figsize=(4.4 * len(compilers) + 0.6, 3.8), sharey=True, squeeze=False)
    for panel, compiler in zip(panels[0], compilers):
        panel.set_title(compiler)
        for label in labels:
            points = sorted(found.get((compiler, label), []))
            if points:
                power = exponent(points)
                text = label if power is None else f"{label}: N^{power:.2f}"
                panel.plot([n for n, _ in points], [t / n for n, t in points], "o-", markersize=4, label=text,
                           color=style.COLOURS[labels.index(label)], linewidth=2.2 if label.startswith("axial") else 1.2)
        log_axes(panel, sorted({n for points in found.values() for n, _ in points}))
        panel.legend(fontsize=8, loc="upper left")
    panels[0][0].set_ylim(top=panels[0][0].get_ylim()[1] * 4)  # room for the legend
    panels[0][0].set_ylabel("ns per joint (this machine)")
    figure.tight_layout()
    style.save(figure, stem, "Time per joint of forward dynamics, against the number of joints")


def log_axes(panel, joints):
    panel.set_xscale("log", base=2)
    panel.set_yscale("log")
    panel.set_xticks(joints)
    panel.xaxis.set_major_formatter(ScalarFormatter())
    panel.yaxis.set_major_formatter(ScalarFormatter())
    panel.yaxis.set_minor_formatter(NullFormatter())
    panel.set_xlabel("joints, forward dynamics in double")


def print_summary(rows):
    lowest = min(worse_compiler(rows).values(), key=lambda row: row["ratio"])
    print(f"smallest ratio: {lowest['ratio']:.2f} ({lowest['algorithm']}, {lowest['robot']}, {lowest['scalar']}, "
          f"{lowest['peer']}, {lowest['compiler']})")
    for (compiler, label), points in curves(rows).items():
        power = exponent(points)
        if power is not None:
            print(f"forward dynamics of N joints, {compiler}, {label}: time ~ N^{power:.2f} from 8 joints on")


def output_of(*command):
    result = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    return result.stdout.strip()


def commit():
    """Dirty if anything but a generated document differs from it."""
    changed = output_of("git", "status", "--porcelain", "--untracked-files=no", "--", ".", ":!doc")
    return output_of("git", "describe", "--always") + ("-dirty" if changed else "")


def provenance(rows):
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        processor = next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), "unknown")
    versions = [output_of("dpkg-query", "-W", "-f", "${Package} ${Version}", package) for package in PACKAGES]
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
    bench = next(preset for preset in presets if preset["name"] == "bench-gcc")
    return {"processor": processor, "packages": versions, "compilers": unique(row["compiler"] for row in rows),
            "flags": bench["cacheVariables"]["AXIAL_BENCH_KERNEL_FLAGS"] + " -march=native",
            "commit": commit()}


def write(file, value):
    pathlib.Path(file).write_text(json.dumps(value, indent=2) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--json")
    parser.add_argument("--provenance")
    options = parser.parse_args()
    rows = load(options.files)
    style.use()
    draw_ratios(against_others(rows), str(options.folder / "speed-ratios"))
    draw_joints(rows, str(options.folder / "speed-joints"))
    if against_others(rows):
        print_summary(against_others(rows))
    for row in rows:
        if row["peer"] == ONE_STATE:
            print(f"batches, {row['algorithm']}, {row['robot']}, {row['scalar']}, {row['compiler']}: {row['ratio']:.2f} times one state")
        if row["algorithm"] in OF_DERIVATIVES:
            print(f"{row['algorithm']}, {row['robot']}, {row['scalar']}, {row['compiler']}: {1 / row['ratio']:.2f} times {row['peer']}")
    if options.json:
        write(options.json, rows)
    if options.provenance:
        write(options.provenance, provenance(rows))


if __name__ == "__main__":
    main()
