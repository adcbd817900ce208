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
import doubts
import least_squares
import program
import recording
import report
import robot as robots
import smoothing

PLOT = pathlib.Path(__file__).resolve().parents[2] / "figures/plot/identification.py"
RESIDUAL_LIMIT = 5.0  # %
SURE = 4.0  # standard deviations of a noise's own variance
SUSPICIOUS = 0.2  # of the limit: above, what would mend the log is told although it is taken
HOPELESS = 1.0  # of the torque: what is left above is not asked about noise of positions and speeds
FIXED = {"rotors": ("rotor",), "friction": ("viscous", "forward", "backward")}


def scale(text):
    """Raises ValueError, which the parser tells."""
    if not 0.0 < abs(value := float(text)) < np.inf:
        raise ValueError
    return value


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="identify", description=__doc__, allow_abbrev=False)
    parser.add_argument("log")
    parser.add_argument("--program", required=True, help="robot_regressor")
    parser.add_argument("--robot", required=True)
    parser.add_argument("--tip", default="")
    parser.add_argument("-o", dest="header")
    parser.add_argument("--cutoff", type=float)
    parser.add_argument("--torque-scale", type=scale)
    parser.add_argument("--keep", action="append", default=[], choices=sorted(FIXED))
    parser.add_argument("--validate")
    parser.add_argument("--residual-limit", type=float, default=RESIDUAL_LIMIT)
    parser.add_argument("--output", default="output/identify")
    parser.add_argument("--json")
    return parser.parse_args(arguments)


def free_parameters(robot, keep):
    """Links without a drive of their own have neither rotor nor friction."""
    kept = {kind for name in keep for kind in FIXED[name]}
    drives = {kind for kinds in FIXED.values() for kind in kinds}
    return np.array([i for i, kind in enumerate(robot.kinds) if kind not in kept and (robot.drives[i] is not None or kind not in drives)])


def drive_scales(robot, log):
    """A size of each standard parameter of a drive: what would take the joint's RMS torque alone, or the prior's value."""
    effort, speed = (np.sqrt(np.mean(values ** 2, axis=0)) for values in (log.tau, np.gradient(log.q, log.step, axis=0)))
    acceleration = speed * speed / np.maximum(np.std(log.q, axis=0), 1e-9)
    sizes = {"rotor": effort / acceleration, "viscous": effort / speed, "forward": effort, "backward": effort}
    scale = np.ones(len(robot.names))
    for i, kind in enumerate(robot.kinds):
        if kind in sizes and robot.drives[i] is not None:
            scale[i] = max(abs(robot.prior[i]), sizes[kind][robot.drives[i]])
    return scale


class Fit:
    """The base parameters that a log has, whether or not bodies have them."""

    def __init__(self, robot, log, keep=(), cutoff=None):
        self.robot, self.log, self.keep, self.cutoff = robot, log, keep, cutoff
        self.free = free_parameters(robot, keep)
        self.base = base_parameters.base_of(robot, self.free)
        self.columns, self.known = self.free[self.base.columns], np.setdiff1d(np.arange(len(robot.names)), self.free)
        self.equations, self.smoother = smoothing.equations(robot, log, self.columns, self.known, cutoff)
        self.fit = least_squares.fit(self.equations)


class Identification(Fit):
    """Everything that is found out about a robot from a log. Raises consistency.NotFound, and doubts.OtherUnits unless the units are told."""

    def __init__(self, robot, log, keep=(), cutoff=None, units_are_told=False):
        super().__init__(robot, log, keep, cutoff)
        self.prior = self.base.combinations @ robot.prior[self.free]
        self.doubts = [] if units_are_told else doubts.check_units(*doubts.shared_scale(self.equations, self.prior))
        self.consistent = consistency.nearest(robot, self.free, self.base, self.fit, drive_scales(robot, log))

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

    def residuals(self, equations=None):
        """What the header's parameters leave of each joint's torque, over its RMS."""
        return self.errors(self.equations if equations is None else equations)[1]["identified"]

    def unexplained(self, equations=None):
        """What is left beyond noise, over the RMS: what a mistake may explain."""
        equations = self.equations if equations is None else equations
        size, errors = self.errors(equations)
        sure = 1.0 + SURE * np.sqrt(2.0 / equations.valid.sum(axis=0))
        beyond = lambda noise: np.sqrt(np.maximum(0.0, errors["identified"] ** 2 - sure * (noise / size) ** 2))
        left = beyond(equations.noise)
        return beyond(equations.noise_of_all(self.consistent.base)) if doubts.NOTHING < left.max() < HOPELESS else left

    def on(self, log):
        """The equations of another log in the same base parameters."""
        return smoothing.equations(self.robot, log, self.columns, self.known, self.cutoff)[0]


def read(path, robot, torque_scale=None):
    try:
        return recording.read(path, robot, torque_scale or 1.0)
    except recording.RecordingError as error:
        raise ValueError(f"{path}: {error}") from error


def identified(robot, log, options):
    """Raises ValueError where bodies have nothing like the log's parameters."""
    try:
        return Identification(robot, log, options.keep, options.cutoff, options.torque_scale is not None)
    except doubts.OtherUnits as error:
        raise ValueError(f"{options.log}: no header is written; {error}") from error
    except consistency.NotFound as error:
        reason = diagnosis(Fit(robot, log, options.keep, options.cutoff), np.inf, 0.01 * options.residual_limit)
        raise ValueError(f"{options.log}: {error}; no header is written; {reason}") from error


def refuse(found, judged, options):
    """Raises ValueError for logs that the parameters do not explain, with the single mistake that does."""
    limit = 0.01 * options.residual_limit
    for path, equations in judged.items():
        residuals = found.unexplained(equations)
        joint, worst = int(np.argmax(residuals)), residuals.max()
        if worst <= limit:
            continue
        text = f"{path}: {100 * worst:.3g} % of tau{joint + 1} is left unexplained, the limit is {options.residual_limit:g} % (--residual-limit); no header is written"
        if path == options.log:
            text += "; " + diagnosis(found, worst, limit)
        raise ValueError(text)


def suspicion(found, options):
    """Of a log that is taken: doubts about its units; the single mistake without which far less would be left."""
    limit, worst = 0.01 * options.residual_limit, found.unexplained().max()
    if not SUSPICIOUS * limit < worst <= limit:
        return found.doubts
    remedy = best_remedy(found)
    return found.doubts + [doubts.sentence(found.robot, worst, remedy, limit)] if doubts.mends(worst, remedy, limit) else []


def diagnosis(found, worst, limit):
    """The sentence that names the single mistake."""
    return doubts.sentence(found.robot, worst, best_remedy(found), limit)


def best_remedy(found):
    print("looking for exchanged columns, signs, zeros, scales and units", file=sys.stderr, flush=True)

    def residual_of(log):
        try:
            other = Identification(found.robot, log, found.keep, found.cutoff)
            return float(other.residuals().max()), float(other.unexplained().max())
        except ValueError:
            return np.inf, np.inf

    doubted = doubts.Doubts(found.robot, found.log, found.columns, found.known, found.cutoff)
    return doubts.best_remedy(doubted, found.log, residual_of)


def write_torques(path, found, equations):
    joints, torques = len(found.robot), found.torques(equations)
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["time"] + [f"{name}{i + 1}" for name in ("measured", *torques) for i in range(joints)])
        table = np.column_stack([equations.time, equations.tau, *torques.values()])
        writer.writerows([f"{value:.7g}" for value in row] for row in table)


def write_header(found, path, judged):
    content = report.header_content(found, pathlib.Path(path).stem, judged)
    with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
        json.dump({**content, "parameters": found.consistent.standard.tolist()}, file)
        file.flush()
        found.robot.write_header(path, file.name)


def identify(options):
    with robots.Robot(options.program, options.robot, options.tip) as robot:
        log = read(options.log, robot, options.torque_scale)
        print(f"{len(log.time)} rows of {len(robot)} {robot.noun}s; fitting", file=sys.stderr, flush=True)
        found = identified(robot, log, options)
        judged = {options.log: found.equations}
        if options.validate:
            judged[options.validate] = found.on(read(options.validate, robot, options.torque_scale))
        folder = pathlib.Path(options.output)
        folder.mkdir(parents=True, exist_ok=True)
        print(report.text(found, judged, suspicion(found, options)))
        rows = report.rows(found, judged)
        for target in filter(None, [folder / "identification.json", options.json]):
            pathlib.Path(target).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
        write_torques(folder / "torques.csv", found, list(judged.values())[-1])
        subprocess.run(["/usr/bin/python3", "-E", "-B", PLOT, folder / "torques.csv"], check=True)
        print(f"report {folder}/identification.json, picture {folder}/torques.png")
        refuse(found, judged, options)
        if options.header:
            write_header(found, options.header, judged)
            print(f"header {options.header}")


def main(arguments):
    return program.run("identify", lambda: identify(parsed(arguments)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
