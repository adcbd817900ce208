"""Fits a robot's inertial parameters and friction to recorded motion; ./axial identify --help says how."""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import base_parameters
import consistency
import least_squares
import program
import recording
import report
import robot as robots
import smoothing

PLOT = pathlib.Path(__file__).resolve().parents[1] / "plot/identification.py"
FIXED = {"rotors": ("rotor",), "friction": ("viscous", "forward", "backward")}


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="identify", description=__doc__, allow_abbrev=False)
    parser.add_argument("log")
    parser.add_argument("--program", required=True, help="robot_regressor")
    parser.add_argument("--robot", required=True)
    parser.add_argument("--tip", default="")
    parser.add_argument("-o", dest="header")
    parser.add_argument("--cutoff", type=float)
    parser.add_argument("--keep", action="append", default=[], choices=sorted(FIXED))
    parser.add_argument("--validate")
    parser.add_argument("--output", default="output/identify")
    parser.add_argument("--json")
    return parser.parse_args(arguments)


def free_parameters(robot, keep):
    kept = {kind for name in keep for kind in FIXED[name]}
    return np.array([i for i, kind in enumerate(robot.kinds) if kind not in kept])


def drive_scales(robot, log):
    """A size of each standard parameter of a drive: what would take the joint's RMS torque alone, or the prior's value."""
    effort, speed = (np.sqrt(np.mean(values ** 2, axis=0)) for values in (log.tau, np.gradient(log.q, log.step, axis=0)))
    acceleration = speed * speed / np.maximum(np.std(log.q, axis=0), 1e-9)
    sizes = {"rotor": effort / acceleration, "viscous": effort / speed, "forward": effort, "backward": effort}
    scale = np.ones(len(robot.names))
    for i, kind in enumerate(robot.kinds):
        if kind in sizes:
            scale[i] = max(abs(robot.prior[i]), sizes[kind][i * len(robot) // len(robot.names)])
    return scale


class Identification:
    """Everything that is found out about a robot from a log."""

    def __init__(self, robot, log, keep=(), cutoff=None):
        self.robot, self.log, self.cutoff = robot, log, cutoff
        self.free = free_parameters(robot, keep)
        self.base = base_parameters.base_of(robot, self.free)
        self.columns, self.known = self.free[self.base.columns], np.setdiff1d(np.arange(len(robot.names)), self.free)
        self.equations, self.smoother = smoothing.equations(robot, log, self.columns, self.known, cutoff)
        self.fit = least_squares.fit(self.equations)
        self.consistent = consistency.nearest(robot, self.free, self.base, self.fit, drive_scales(robot, log))
        self.prior = self.base.combinations @ robot.prior[self.free]

    def torques(self, equations):
        """What the prior, the base parameters and the consistent parameters predict."""
        values = {"prior": self.prior, "base": self.fit.values, "identified": self.consistent.base}
        return {name: equations.regressor @ each for name, each in values.items()}

    def errors(self, equations):
        """RMS of each joint's torque, and of predicted less measured over it, by prediction."""
        valid = equations.valid
        rms = lambda values: np.sqrt(np.sum(np.where(valid, values, 0.0) ** 2, axis=0) / valid.sum(axis=0))
        size = rms(equations.tau)
        return size, {name: rms(tau - equations.tau) / size for name, tau in self.torques(equations).items()}

    def on(self, log):
        """The equations of another log in the same base parameters."""
        return smoothing.equations(self.robot, log, self.columns, self.known, self.cutoff)[0]


def read(path, robot):
    try:
        return recording.read(path, robot)
    except recording.RecordingError as error:
        raise ValueError(f"{path}: {error}") from error


def write_torques(path, found, equations):
    joints, torques = len(found.robot), found.torques(equations)
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["time"] + [f"{name}{i + 1}" for name in ("measured", *torques) for i in range(joints)])
        table = np.column_stack([equations.time, equations.tau, *torques.values()])
        writer.writerows([f"{value:.7g}" for value in row] for row in table)


def write_header(found, path, log):
    content = report.header_content(found, pathlib.Path(path).stem, log)
    with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
        json.dump({**content, "parameters": found.consistent.standard.tolist()}, file)
        file.flush()
        found.robot.write_header(path, file.name)


def identify(options):
    with robots.Robot(options.program, options.robot, options.tip) as robot:
        log = read(options.log, robot)
        print(f"{len(log.time)} rows of {len(robot)} joints; fitting", file=sys.stderr, flush=True)
        found = Identification(robot, log, options.keep, options.cutoff)
        judged = {options.log: found.equations}
        if options.validate:
            judged[options.validate] = found.on(read(options.validate, robot))
        folder = pathlib.Path(options.output)
        folder.mkdir(parents=True, exist_ok=True)
        print(report.text(found, judged))
        rows = report.rows(found, judged)
        for target in filter(None, [folder / "identification.json", options.json]):
            pathlib.Path(target).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
        write_torques(folder / "torques.csv", found, list(judged.values())[-1])
        subprocess.run(["/usr/bin/python3", "-E", "-B", PLOT, folder / "torques.csv"], check=True)
        print(f"report {folder}/identification.json, picture {folder}/torques.png")
        if options.header:
            write_header(found, options.header, options.log)
            print(f"header {options.header}")


def main(arguments):
    return program.run("identify", lambda: identify(parsed(arguments)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
