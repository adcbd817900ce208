"""What identification finds in logs of altered arms, made by Orocos KDL (by the oracle where joints share drives): the rows of
doc/measurements/identified_arms.md.

usage: study.py --program robot_regressor --simulator simulated_log --output FOLDER [--documents DOC] [robot...]

Of every robot: an arm of which each parameter is up to 30 % off (tests/host_sim/robots/simulated_log.cpp), with a rotor and friction where the
robot declares none; the exact log, and one of encoders of 16 bits a turn (a metre) and torque noise of 2 % of each joint's RMS; a validation
trajectory of another seed, on which the predicted torque is held against KDL's exact one at every set-point.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys

import numpy as np

import consistency
import excite
import identify
import recording
import robot as robots

ROBOTS = ("planar2r", "scara", "scara_rrpr", "puma560", "scara_quill", "palletiser", "panda")
COUNTS, NOISE, SPREAD = 65536, 0.02, 0.3
EXACT_RATE, RATE = 50.0, 1000.0  # Hz
DURATION, HARMONICS = 10.0, 8
RESTS = 1e-9  # of a joint's greatest speed: below, it rests
FLOOR = 1e-3  # of the largest base parameter: smaller ones count as this large


class Arm:
    """A robot, its motions in a folder, and the simulator of the arm that it is not quite."""

    def __init__(self, robot, simulator, folder, rounds, described=None):
        """described: name or table of the robot where it is not its name."""
        self.robot, self.simulator, self.folder, self.described = robot, simulator, pathlib.Path(folder), described or robot.name
        excitation = excite.Excitation(robot, DURATION, HARMONICS)
        self.write("excitation", excitation, excitation.best(1, rounds)[1])
        self.write("validation", excitation, excitation.best(2, 0)[1])

    def write(self, name, excitation, shape):
        for rate in (EXACT_RATE, RATE):
            time_s = np.arange(int(DURATION * rate) + 1) / rate
            motion = excite.motion_at(excitation, shape, time_s)
            excite.checked(excitation, motion)
            excite.write(self.path(name, rate), time_s, motion)

    def path(self, name, rate):
        return self.folder / f"{self.robot.name}-{name}-{rate:g}.csv"

    def log(self, motion, rate, counts=0.0, noise=0.0):
        """A recording of the altered arm on a motion; the altered arm's standard parameters."""
        path, truth = self.folder / f"{self.robot.name}-log.csv", self.folder / f"{self.robot.name}-truth.json"
        subprocess.run([self.simulator, "--robot", self.described, "--motion", self.path(motion, rate), "--log", path, "--truth", truth,
                        "--seed", "3", "--spread", str(SPREAD), "--counts", str(counts), "--noise", str(noise)], check=True)
        return recording.read(path, self.robot), np.array(json.loads(truth.read_text(encoding="utf-8")))

    def set_points(self, motion, rate):
        joints = len(self.robot)
        table = np.loadtxt(self.path(motion, rate), delimiter=",", skiprows=1)
        return [table[:, 1 + k * joints:1 + (k + 1) * joints] for k in range(3)]


def prediction_errors(arm, standard):
    """Of the torque of standard parameters on the validation trajectory, where the joint moves (friction at rest is anything between its
    bounds): RMS over the RMS of KDL's torque, a joint each."""
    exact, _ = arm.log("validation", EXACT_RATE)
    q, qd, qdd = arm.set_points("validation", EXACT_RATE)
    regressor, known = arm.robot.regressor(q, qd, qdd)
    moves = np.abs(qd) > RESTS * np.abs(qd).max(axis=0)
    rms = lambda values: np.sqrt(np.sum(np.where(moves, values, 0.0) ** 2, axis=0) / moves.sum(axis=0))
    return rms(regressor @ standard + known - exact.tau) / rms(exact.tau)


def parameter_errors(found, truth):
    """Largest error of a base parameter: over the largest one, and over itself (or FLOOR of the largest)."""
    true = found.base.combinations @ truth[found.free]
    error, largest = np.abs(found.fit.values - true), np.abs(true).max()
    return error.max() / largest, (error / np.maximum(np.abs(true), FLOOR * largest)).max()


def least_eigenvalue(found):
    """Of all links' pseudo-inertias, over its trace: positive where every link is physically consistent."""
    per_link = found.consistent.standard.reshape(len(found.robot.links), -1)[:, :consistency.INERTIAL]
    pseudo = [consistency.pseudo_inertia(link) for link in per_link]
    return min(np.linalg.eigvalsh(each).min() / np.trace(each) for each in pseudo)


def case(arm, name):
    """One fit: a row."""
    noisy = name == "noisy"
    log, truth = arm.log("excitation", RATE, COUNTS, NOISE) if noisy else arm.log("excitation", EXACT_RATE)
    found = identify.Identification(arm.robot, log, cutoff=None if noisy else 0.0)
    of_largest, of_itself = parameter_errors(found, truth)
    errors = {"prior": prediction_errors(arm, arm.robot.prior), "identified": prediction_errors(arm, found.consistent.standard)}
    return found, {"robot": arm.robot.name, "case": name, "joints": len(arm.robot), "base_parameters": len(found.base),
                   "standard_parameters": len(found.free), "condition": float(found.fit.condition),
                   "base_error_over_largest": float(of_largest), "base_error_relative": float(of_itself),
                   "least_eigenvalue": float(least_eigenvalue(found)),
                   **{f"torque_error_{each}": float(values.max()) for each, values in errors.items()}}


def study(program, simulator, name, folder, rounds=20):
    """The rows of a robot, and the identification from its noisy log."""
    with robots.Robot(program, name) as robot:
        arm = Arm(robot, simulator, folder, rounds)
        rows = [case(arm, each) for each in ("exact", "noisy")]
        return [row for _, row in rows], rows[-1][0]


def text(rows):
    lines = [f"{'robot':<12} {'case':<6} {'base':>5} {'condition':>10} {'error/largest':>14} {'error, relative':>16} {'torque, prior':>14} {'identified':>11}"]
    for row in rows:
        lines.append(f"{row['robot']:<12} {row['case']:<6} {row['base_parameters']:>5} {row['condition']:>10.3g} {row['base_error_over_largest']:>14.2g} "
                     f"{row['base_error_relative']:>16.2g} {100 * row['torque_error_prior']:>12.3g} % {100 * row['torque_error_identified']:>9.2g} %")
    return "\n".join(lines)


def main(arguments):
    parser = argparse.ArgumentParser(prog="study", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("--program", "--simulator", "--output"):
        parser.add_argument(name, required=True)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--documents")
    parser.add_argument("robots", nargs="*", default=ROBOTS)
    options = parser.parse_args(arguments)
    folder, rows = pathlib.Path(options.output), []
    folder.mkdir(parents=True, exist_ok=True)
    for name in options.robots:
        print(f"{name} ...", file=sys.stderr, flush=True)
        own, found = study(options.program, options.simulator, name, folder, options.rounds)
        rows += own
        identify.write_torques(folder / f"identification-{name}.csv", found, found.equations)
    print(text(rows))
    (folder / "identification.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    if options.documents:
        documents(folder, pathlib.Path(options.documents))


def documents(folder, doc):
    """Raw data and pictures of the last robot."""
    shutil.copy(folder / "identification.json", doc / "data")
    shutil.copy(folder / "identification-panda.csv", folder / "identification.csv")
    shutil.copy(folder / "panda-excitation-50.csv", folder / "excitation.csv")
    for name in ("identification", "excitation"):
        subprocess.run(["/usr/bin/python3", "-E", "-B", identify.PLOT.with_name(f"{name}.py"), folder / f"{name}.csv"], check=True)
        shutil.copy(folder / f"{name}.png", doc / "pictures")


if __name__ == "__main__":
    main(sys.argv[1:])
