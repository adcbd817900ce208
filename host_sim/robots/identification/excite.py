"""Excitation trajectories for ./axial identify, optimised for the condition of the regressor; ./axial excite --help says how."""

import argparse
import json
import pathlib
import subprocess
import sys
import time

import numpy as np
import scipy.optimize

import base_parameters
import fourier
import program
import robot as robots

INSTANTS = 60  # at which the regressor is weighed
CHECKED = 400  # at which limits are held while optimising
CANDIDATES = 60
PENALTY = 10.0  # on the squared excess of torque over its limit, over the limit
PLOT = pathlib.Path(__file__).resolve().parents[2] / "figures/plot/excitation.py"


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="excite", description=__doc__, allow_abbrev=False)
    parser.add_argument("--program", required=True, help="robot_regressor")
    parser.add_argument("--robot", required=True)
    parser.add_argument("--tip", default="")
    parser.add_argument("-o", dest="path", default="excitation.csv")
    parser.add_argument("--duration", type=float, default=10.0)
    parser.add_argument("--rate", type=float, default=1000.0)
    parser.add_argument("--harmonics", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--json")
    options = parser.parse_args(arguments)
    for name, least, most in (("duration", 1.0, 600.0), ("rate", 10.0, 20000.0), ("harmonics", 2, 20), ("rounds", 0, 1000), ("seed", 0, 2**31)):
        if not least <= getattr(options, name) <= most:
            parser.error(f"--{name} {getattr(options, name):g}: give {least:g} to {most:g}")
    return options


class Excitation:
    """What is minimised: the logarithm of the regressor's condition number, with a penalty on torque beyond its limits."""

    def __init__(self, robot, duration, harmonics):
        self.robot = robot
        self.limits, self.missing = fourier.limits_of(robot)
        self.series = fourier.series_of(robot, self.limits, duration, harmonics)
        self.columns = base_parameters.base_of(robot, np.arange(len(robot.names))).columns
        self.basis = self.series.basis(np.linspace(0.0, duration, CHECKED, endpoint=False))
        self.some = np.arange(0, CHECKED, max(1, CHECKED // INSTANTS))
        self.effort_scale = None
        self.effort_scale = self._effort_scale()

    def _effort_scale(self):
        """Of a joint's rows: the limit of its torque, or the prior's over random states."""
        _, torque = self._regressor(base_parameters.random_states(self.robot))
        size = np.sqrt(np.mean(torque ** 2, axis=0))
        return np.where(np.isfinite(self.limits.effort), self.limits.effort, np.where(size > 0.0, size, 1.0))

    def _regressor(self, motion):
        everything, known = self.robot.regressor(*motion)
        return everything[:, :, self.columns], known + everything @ self.robot.prior

    def weigh(self, shape, instants=None):
        """Condition number, and each joint's greatest torque over its limit."""
        motion = self.series.motion(shape, self.basis)
        chosen = self.some if instants is None else instants
        regressor, torque = self._regressor([each[chosen] for each in motion])
        rows = (regressor / self.effort_scale[:, None]).reshape(-1, len(self.columns))
        return np.linalg.cond(rows), np.abs(torque).max(axis=0) / self.limits.effort

    def cost(self, shape):
        condition, effort = self.weigh(shape)
        return np.log(condition) + PENALTY * np.sum(np.maximum(effort - fourier.MARGIN, 0.0) ** 2)

    def best(self, seed, rounds):
        """The best of random shapes, improved; and the conditions of that one before and after."""
        random = np.random.default_rng(seed)
        shapes = random.normal(size=(CANDIDATES, self.series.joints * self.series.size))
        first = min(shapes, key=self.cost)
        if rounds == 0:
            return first, first
        progress = _Progress(rounds)
        result = scipy.optimize.minimize(self.cost, first, method="L-BFGS-B", callback=progress, options={"maxiter": rounds, "maxfun": 10 ** 6})
        return first, result.x


class _Progress:
    def __init__(self, rounds):
        self.rounds, self.done, self.said = rounds, 0, time.monotonic()

    def __call__(self, _):
        self.done += 1
        if time.monotonic() - self.said > 3.0:
            self.said = time.monotonic()
            print(f"optimising: round {self.done} of at most {self.rounds}", file=sys.stderr, flush=True)


def checked(excitation, motion):
    """Peaks over limits at every instant that is written; raises ValueError where a limit is left."""
    lim, names = excitation.limits, ("speed", "acceleration")
    q, qd, qdd = motion
    _, torque = excitation._regressor(motion)
    effort = np.abs(torque).max(axis=0) / lim.effort
    peaks = {name: (np.abs(values).max(axis=0) / limit) for name, values, limit in zip(names, (qd, qdd), (lim.speed, lim.acceleration))}
    peaks["effort"] = effort
    joints = fourier.beyond_joints(excitation.robot, motion)
    if np.any(q < lim.low) or np.any(q > lim.high) or any(np.any(each > 1.0) for each in peaks.values()) or joints:
        noun = excitation.robot.noun
        where = [f"{name} of {noun} {i + 1} at {each[i]:.3g} of its limit" for name, each in peaks.items() for i in np.flatnonzero(each > 1.0)] + joints
        raise ValueError("no trajectory inside the limits was found: " + (", ".join(where) or "positions") +
                         "; a longer --duration, fewer --harmonics or another --seed may do (a torque of gravity alone may be too large)")
    return peaks


def write(path, time_s, motion):
    joints = motion[0].shape[1]
    header = ",".join(["time"] + [f"{name}{i + 1}" for name in ("q", "qd", "qdd") for i in range(joints)])
    np.savetxt(path, np.column_stack([time_s, *motion]), fmt="%.17g", delimiter=",", header=header, comments="")


def rows(robot, excitation, peaks, conditions, options):
    return [{"robot": robot.name, "joint": i + 1, "duration_s": options.duration, "rate_Hz": options.rate, "harmonics": options.harmonics,
             "condition_random": conditions[0], "condition": conditions[1], "parameters": len(excitation.columns),
             **{f"{name}_over_limit": float(each[i]) for name, each in peaks.items()}} for i in range(len(robot))]


def excite(options):
    with robots.Robot(options.program, options.robot, options.tip) as robot:
        excitation = Excitation(robot, options.duration, options.harmonics)
        first, shape = excitation.best(options.seed, options.rounds)
        instants = np.arange(CHECKED)
        conditions = [float(excitation.weigh(each, instants)[0]) for each in (first, shape)]
        time_s = np.arange(int(round(options.duration * options.rate)) + 1) / options.rate
        # Scaled as it was while optimising, so that both are one motion.
        motion = motion_at(excitation, shape, time_s)
        peaks = checked(excitation, motion)
        write(options.path, time_s, motion)
        result = rows(robot, excitation, peaks, conditions, options)
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    say(result, excitation, options)
    subprocess.run(["/usr/bin/python3", "-E", "-B", PLOT, options.path], check=True)
    print(f"trajectory {options.path}, picture {pathlib.Path(options.path).with_suffix('.png')}")


def motion_at(excitation, shape, time_s):
    """The motion of a shape at any instants: the basis is linear, so that the optimised motion is scaled alike."""
    series = excitation.series
    coefficients = np.reshape(shape, (series.joints, series.size))[:, :-2]
    optimised, raw = series.motion(shape, excitation.basis), excitation.basis[1] @ coefficients.T
    scale = np.abs(optimised[1]).max(axis=0) / np.abs(raw).max(axis=0)
    shift = optimised[0][0] - scale * (excitation.basis[0][0] @ coefficients.T)
    q, qd, qdd = (each @ coefficients.T for each in series.basis(time_s))
    return scale * q + shift, scale * qd, scale * qdd


def say(result, excitation, options):
    print(f"{result[0]['robot']}: {options.duration:g} s, {options.harmonics} harmonics; condition of the regressor of {result[0]['parameters']} "
          f"base parameters {result[0]['condition']:.3g} (best random one {result[0]['condition_random']:.3g}), rows over the torque limits")
    print(f"{excitation.robot.noun:<6} {'speed':>7} {'acceleration':>13} {'effort':>7}   greatest, of the limit")
    for row in result:
        print(f"{row['joint']:<6} {row['speed_over_limit']:>7.2f} {row['acceleration_over_limit']:>13.2f} {row['effort_over_limit']:>7.2f}")
    if excitation.missing:
        print("note: assumed, as the description has no " + ", ".join(excitation.missing) + ": half a turn (0.25 m) either way, 2 rad/s, 5 rad/s^2")


def main(arguments):
    return program.run("excite", lambda: excite(parsed(arguments)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
