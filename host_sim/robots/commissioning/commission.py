"""Finds what is wrong with an arm's drives, axes, zeros and table from held poses; ./axial commission --help says how."""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import design
from engine import Arm, program
import poses as files
from report import Report
from statics import Statics
from verdict import Verdict

PLOT = pathlib.Path(__file__).resolve().parents[2] / "figures/plot/commissioning.py"
RESIDUAL_LIMIT = 10.0  # %


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="commission", description=__doc__, allow_abbrev=False)
    parser.add_argument("robot")
    parser.add_argument("poses", nargs="*")
    parser.add_argument("--program", required=True, help="gravity_parts, or gravity_parts-own")
    parser.add_argument("--tip", default="")
    parser.add_argument("--at", default="0,0,0")
    parser.add_argument("--suggest", action="store_true")
    parser.add_argument("--mass", type=float)
    parser.add_argument("--poses", dest="count", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", dest="target")
    parser.add_argument("--residual-limit", type=float, default=RESIDUAL_LIMIT)
    parser.add_argument("--output", default="output/commission")
    parser.add_argument("--json")
    return parser.parse_args(arguments)


def point(text):
    try:
        values = tuple(float(each) for each in text.split(","))
    except ValueError:
        values = ()
    if len(values) != 3 or not np.all(np.isfinite(values)):
        raise ValueError(f"--at is '{text}'; give three numbers with commas, metres in the tool's axes")
    return values


def tell(text):
    print(text, file=sys.stderr, flush=True)


def read(paths, arm):
    """One table of one or several files."""
    found = []
    for path in paths:
        try:
            found.append(files.read(path, arm))
        except files.PosesError as error:
            raise ValueError(f"{path}: {error}") from error
    return files.joined(found)


def gravity_checked(arm):
    if not np.linalg.norm(arm.gravity) > 0.1:
        raise ValueError(f"{arm.name} has no gravity in its description; poses tell nothing without")


def suggest(arm, options):
    if not options.mass or options.mass <= 0.0:
        raise ValueError("--suggest needs --mass, the known mass at the tool in kg")
    if options.count < files.LEAST_POSES:
        raise ValueError(f"--poses is {options.count}; at least {files.LEAST_POSES} are needed")
    statics = Statics(arm)
    designer = design.Designer(statics, options.mass, options.seed)
    tell(f"choosing {options.count} of {len(designer.poses)} poses")
    chosen = designer.chosen(options.count)
    path = pathlib.Path(options.target or "poses.csv")
    if path.exists():
        raise ValueError(f"{path} is there already; take another name (-o), lest measurements are lost")
    write_suggestion(path, designer.poses[chosen], options.mass)
    deviations, condition = designer.deviations(chosen)
    rows = expected_rows(arm, statics, deviations, condition)
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    print(suggestion_text(path, rows, options, arm.noun))


def write_suggestion(path, poses, mass):
    """Bare holds of every pose first, then those with the mass: it is fixed to the tool once."""
    joints = poses.shape[1]
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["pose", "mass", "side", *(f"q{j + 1}" for j in range(joints)), *(f"tau{j + 1}" for j in range(joints))])
        for load in (0.0, mass):
            for k, pose in enumerate(poses):
                for side in (1, -1):
                    writer.writerow([k + 1, f"{load:g}", side, *(f"{value:.4f}" for value in pose), *[""] * joints])


def expected_rows(arm, statics, deviations, condition):
    of = statics.unknowns.index
    drives = [{"kind": "expected", "robot": arm.name, "joint": j + 1, "scale_deviation": float(deviations[of("scale", j)]),
               "zero_deviation": float(deviations[of("zero", j)]), "unit": "m" if arm.prismatic[j] else "rad"} for j in range(len(arm))]
    tilt = float(np.max(deviations[statics.unknowns.of("tilt")]))
    return drives + [{"kind": "expected gravity", "robot": arm.name, "tilt_deviation": tilt, "condition": condition}]


def suggestion_text(path, rows, options, noun):
    *drives, whole = rows
    lines = [f"{options.count} poses in {path}; condition number {whole['condition']:.3g} (columns of one length)",
             f"to expect at {100 * design.NOISE:g} % of noise, standard deviations; tilt {np.degrees(whole['tilt_deviation']):.2g} degrees"]
    for row in drives:
        slides = row["unit"] == "m"
        zero = f"{1000 * row['zero_deviation']:.2g} mm" if slides else f"{np.degrees(row['zero_deviation']):.2g} degrees"
        lines.append(f"{noun} {row['joint']}: torque scale {100 * row['scale_deviation']:.2g} %{_hardly(row['scale_deviation'], 0.1)}, "
                     f"zero {zero}{_hardly(row['zero_deviation'], 0.02 if slides else 0.035)}")
    return "\n".join([*lines, *how_to_fill(options.mass)])


def _hardly(deviation, limit):
    return " (these poses will not tell it)" if deviation > limit else " (its meaning: the tilt's direction)" if deviation == 0.0 else ""


def how_to_fill(mass):
    return ["", "How to fill it in, a row a hold; more rows of one hold (samples) are welcome, noise then averages:",
            f"  mass  kg at the tool, 0 bare; {mass:g} when the mass is fixed on",
            "  side  +1: every joint came to rest while its position grew, -1: while it fell (or side1, side2, ... of each joint)",
            "  q     positions as the drives report them, rad or m; set-points stand there now",
            "  tau   what the drives report while they hold, N m or N; empty now",
            "Nobody has checked these poses for collisions: move to each slowly, with a hand on the stop."]


def write_header(arm, report, path, log):
    with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
        json.dump(report.header(pathlib.Path(path).stem, log), file)
        file.flush()
        arm.write_header(path, file.name)


def write_torques(path, verdict):
    """Measured, as described, as found: a row a hold."""
    statics, rows, n = verdict.statics, verdict.rows, len(verdict.arm)
    nominal = np.zeros(len(verdict.fit.x))
    nominal[statics.unknowns.of("scale")] = 1.0
    described = statics.predicted(verdict.poses, nominal)
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["pose", "mass", "side", *(f"{name}{j + 1}" for name in ("measured", "described", "reported", "found") for j in range(n))])
        for k in range(len(rows.mass)):
            values = [*verdict.poses.tau[k], *described[k], *rows.tau[k], *(rows.tau[k] - verdict.fit.residual[k])]
            writer.writerow([int(verdict.poses.pose[k]) + 1, f"{rows.mass[k]:g}", f"{verdict.poses.side[k, 0]:g}", *(f"{value:.7g}" for value in values)])


def draw(torques):
    subprocess.run(["/usr/bin/python3", "-E", "-B", PLOT, torques], check=True)


def judge(arm, options):
    measured = read(options.poses, arm)
    if measured.mass.max() > 0.0:
        tell(f"{len(measured)} holds of {measured.count()} poses, {len(arm)} {arm.noun}s")
    verdict = Verdict(Statics(arm), measured, tell)
    report = Report(verdict, 0.01 * options.residual_limit)
    folder = pathlib.Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    print(report.text())
    for target in filter(None, [folder / "commissioning.json", options.json]):
        pathlib.Path(target).write_text(json.dumps(report.rows(), indent=1) + "\n", encoding="utf-8")
    write_torques(folder / "torques.csv", verdict)
    draw(folder / "torques.csv")
    print(f"report {folder}/commissioning.json, picture {folder}/torques.png")
    conclude(arm, report, options)


def conclude(arm, report, options):
    """Writes the header; raises ValueError for what it cannot mend."""
    log = ", ".join(pathlib.Path(path).name for path in options.poses)
    unexplained = report.unexplained()
    if unexplained:
        raise ValueError(f"{log}: {unexplained}; no header is written; no exchange of drives, axis, sign, scale, zero or tilt explains it; is it this robot, "
                         "are its masses right (./axial identify), is the mass where --at says, does something touch or bend?")
    if report.of_file():
        raise ValueError(f"{log}: {'; '.join(report.of_file())}; no header is written")
    if report.either:
        raise ValueError(f"{log}: {'; '.join(report.mistakes())}; no header is written")
    if options.target:
        write_header(arm, report, options.target, log)
        print(f"header {options.target}")
    drives = report.drives_to_mend()
    if drives:
        raise ValueError(f"{log}: no header mends this, the drives or the wiring must be: {'; '.join(drives)}")


def commission(options):
    at = point(options.at)
    with Arm(options.program, options.robot, options.tip, at) as arm:
        gravity_checked(arm)
        if options.suggest:
            suggest(arm, options)
        elif not options.poses:
            raise ValueError("which poses? give a CSV of measured ones, or --suggest with --mass")
        else:
            judge(arm, options)


def main(arguments):
    return program.run("commission", lambda: commission(parsed(arguments)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
