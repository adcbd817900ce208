"""What commissioning finds of simulated arms, whose torques Orocos KDL computes: the rows of doc/measurements/commissioned_arms.md.

usage: study.py --program gravity_parts --simulator simulated_log --output FOLDER [--documents DOC] [--arms N,N...]

Every arm is random: six or seven joints, bodies, limits, where its tool is. What is wrong with it is planted here: wires and signs (PLANTED), and
scales, offsets, zeros, a tilted table. Poses are those of --suggest. Every hold is sampled SAMPLES times, and once.
"""

import argparse
import dataclasses
import json
import pathlib
import shutil
import subprocess
import sys

import numpy as np

import commission
import design
import drawn_logs
from engine import Arm, suspects
import poses as files
from statics import Statics
from verdict import Verdict
from wiring import ALIKE

ARMS, POSES, MASS, AT = 30, 12, 4.0, (0.08, 0.03, 0.12)
NOISE, FRICTION, ENCODER = 0.02, 0.05, np.radians(0.05)  # of each joint's RMS torque, a sample; of it; rad, a hold
SLIDE_NOISE = 5e-5  # m
SAMPLES = 20
CREEP = 1e-7  # rad/s: how fast a hold is approached where friction is computed
Suspect = suspects.Suspect
PLANTED = {0: (("axis turned", (2,)),), 1: (("axis turned", (4,)),), 2: (("axis turned", (1,)),),
           3: (("torque negated", (1,)),), 4: (("torque negated", (3,)),), 5: (("position negated", (2,)),),
           6: (("drives exchanged", (1, 2)),), 7: (("drives exchanged", (3, 4)),), 8: (("torques exchanged", (2, 4)),),
           9: (("drives exchanged", (2, 3)), ("axis turned", (1,)), ("torque negated", (4,))),
           10: (("positions exchanged", (1, 3)),), 11: (("drives exchanged", (1, 4)), ("axis turned", (2,)))}
NUMBERS_FROM, CLEAN_FROM = 6, 22  # arms from the first on have scales, offsets, zeros, tilts; from the second on nothing at all


def table(seed):
    """An arm that nobody has seen, its first axis vertical or (every fifth) horizontal, one with a slide."""
    random = np.random.default_rng([seed, 23])
    joints = 7 if seed % 4 == 3 else 6
    uniform = lambda low, high, *size: np.round(random.uniform(low, high, *size), 4).tolist()
    links = []
    for i in range(joints):
        mass = round(6.0 * 0.75 ** i, 3)
        links.append({"type": "revolute", "alpha_deg": _twist(seed, i, random), "a": uniform(0.0, 0.05) if i != 2 else 0.4, "d": uniform(0.05, 0.3),
                      "theta_deg": float(random.integers(-1, 2) * 90), "mass": mass, "com": uniform(-0.08, 0.12, 3),
                      "inertia_com": [0.05 * mass, 0.05 * mass, 0.05 * mass], "position_limits": [-2.6, 2.6], "speed_limit": 2.0,
                      "acceleration_limit": 10.0, "effort_limit": 300.0})
    if seed % 10 == 8:
        links[2].update(type="prismatic", position_limits=[0.0, 0.4], theta_deg=90.0)
    return {"name": f"arm_{seed + 1}", "convention": "modified", "gravity": [0, 0, -9.81], "tool": {"xyz": [0, 0, 0.08]}, "links": links}


def _twist(seed, i, random):
    if i == 0:
        return 90.0 if seed % 5 == 4 else 0.0
    return float([90, -90][random.integers(2)] if i != 2 else [0, 90][random.integers(2)])


@dataclasses.dataclass
class Truth:
    mistakes: tuple
    zero: np.ndarray
    scale: np.ndarray
    offset: np.ndarray  # of the joint's RMS torque
    tilt: np.ndarray


def truth(seed, arm):
    """What is planted."""
    random, n = np.random.default_rng([seed, 7]), len(arm)
    mistakes = tuple(Suspect(*each) for each in PLANTED.get(seed, ()))
    none = Truth(mistakes, np.zeros(n), np.ones(n), np.zeros(n), np.zeros(2))
    if not NUMBERS_FROM <= seed < CLEAN_FROM:
        return none
    scale, zero, offset = np.ones(n), np.zeros(n), np.zeros(n)
    first, second, third = 1 + random.permutation(n - 1)[:3]
    scale[first], offset[third] = random.choice([0.7, 1.3, 1.5]), 0.2
    zero[second] = 0.015 if arm.prismatic[second] else np.radians(random.choice([-90.0, -12.0, 3.0, 7.0]) if seed % 6 == 0 else random.choice([-9.0, 2.0, 5.0]))
    tilt = np.radians(random.uniform(-2.5, 2.5, 2)) * (seed % 2)
    if seed % 5 == 4:
        tilt[0] = 0.0  # about a horizontal first axis: the same as its zero
    return dataclasses.replace(none, scale=scale, zero=zero, offset=offset, tilt=tilt)


class Simulated:
    """An arm's true torques, by Orocos KDL (tests/host_sim/robots/simulated_log.cpp): bare and with the mass, on a table that may be tilted."""

    def __init__(self, simulator, folder, described):
        self.simulator, self.folder, self.described = simulator, pathlib.Path(folder), described

    def torques(self, q, gravity, friction):
        """Bare and loaded, approached from below and above: by (mass, side)."""
        return {(mass, side): self._run(self._table(gravity, mass, friction), q, side) for mass in (0.0, MASS) for side in (1, -1)}

    def _table(self, gravity, mass, friction):
        made = json.loads(json.dumps(self.described))
        made["gravity"] = list(gravity)
        for link, level in zip(made["links"], friction):
            link["coulomb"] = level
        last, place = made["links"][-1], np.array(made["tool"]["xyz"]) + AT
        whole = last["mass"] + mass
        last["com"] = ((last["mass"] * np.array(last["com"]) + mass * place) / whole).tolist()
        last["mass"] = whole
        last["inertia_com"] = [1.0, 1.0, 1.0]  # of no effect on what holds it
        return made

    def _run(self, made, q, side):
        robot, motion, log = (self.folder / name for name in ("true.json", "motion.csv", "log.csv"))
        robot.write_text(json.dumps(made), encoding="utf-8")
        joints = q.shape[1]
        header = ["time", *(f"{name}{i + 1}" for name in ("q", "qd", "qdd") for i in range(joints))]
        rows = np.column_stack([np.arange(len(q)) * 0.01, q, np.full(q.shape, side * CREEP), np.zeros(q.shape)])
        np.savetxt(motion, rows, fmt="%.17g", delimiter=",", header=",".join(header), comments="")
        subprocess.run([self.simulator, "--robot", robot, "--motion", motion, "--log", log, "--truth", self.folder / "truth.json", "--spread", "0"], check=True)
        return np.loadtxt(log, delimiter=",", skiprows=1)[:, 1 + joints:]


def measured(arm, simulated, true, q, seed, samples, noise=NOISE):
    """Rows of a CSV: mass, sides, q, tau."""
    random, statics = np.random.default_rng([seed, 99]), Statics(arm)
    bare = simulated.torques(q, statics.fallen(true.tilt), np.full(len(arm), 1e-12))
    size = np.sqrt(np.mean(np.concatenate(list(bare.values())) ** 2, axis=0))
    size = np.maximum(size, 0.01 * size.max())
    tables = []
    for (mass, side), tau in simulated.torques(q, statics.fallen(true.tilt), (FRICTION * size).tolist()).items():
        encoder = random.normal(0.0, 1.0, q.shape) * np.where(arm.prismatic, SLIDE_NOISE, ENCODER)
        position = q + true.zero + encoder * (noise > 0.0)
        for _ in range(samples):
            reported = true.scale * (tau + noise * size * random.normal(0.0, 1.0, q.shape)) + true.offset * size
            columns = [position, reported, np.full(q.shape, float(side))]
            for mistake in reversed(true.mistakes):
                columns = drawn_logs.planted(mistake, columns)
            tables.append(np.column_stack([np.full(len(q), mass), columns[2], columns[0], columns[1]]))
    return np.concatenate(tables)


def write(path, joints, rows):
    header = ["mass", *(f"{name}{i + 1}" for name in ("side", "q", "tau") for i in range(joints))]
    np.savetxt(path, rows, fmt="%.10g", delimiter=",", header=",".join(header), comments="")


class Case:
    """One arm, as described, as it is, as it is measured."""

    def __init__(self, program, simulator, folder, seed):
        self.folder = pathlib.Path(folder)
        self.table, self.seed = table(seed), seed
        self.robot = self.folder / f"{self.table['name']}.json"
        self.robot.write_text(json.dumps(self.table), encoding="utf-8")
        self.arm = Arm(program, self.robot, at=AT)
        self.truth = truth(seed, self.arm)
        self.simulated = Simulated(simulator, folder, self.table)
        designer = design.Designer(Statics(self.arm), MASS)
        self.q = designer.poses[designer.chosen(POSES)]

    def log(self, samples=SAMPLES, noise=NOISE):
        path = self.folder / f"{self.table['name']}-{samples}.csv"
        write(path, len(self.arm), measured(self.arm, self.simulated, self.truth, self.q, self.seed, samples, noise))
        return path

    def found(self, samples=SAMPLES):
        return Verdict(Statics(self.arm), files.read(self.log(samples), self.arm))

    def row(self, samples=SAMPLES):
        return judged(self, self.found(samples), samples)


def judged(case, found, samples):
    """Errors of what is called well told; faults that were missed; faults that were invented."""
    arm, true, n = case.arm, case.truth, len(case.arm)
    poorly = {(each.kind, each.index) for each in (*found.untold, *found.poor)}
    told = lambda kind, j: found.value(kind, j) is not None and (kind, j) not in poorly and found.statics.free[found.statics.unknowns.index(kind, j)]
    sign = found.fit.x[found.statics.unknowns.of("scale")]
    scale = [abs(abs(sign[j]) / true.scale[j] - 1.0) for j in range(n) if told("scale", j)]
    zero = lambda slides: [abs(found.value("zero", j)[0] - true.zero[j]) for j in range(n) if told("zero", j) and arm.prismatic[j] == slides]
    turns, slides = zero(False), zero(True)
    tilt = np.arccos(np.clip(found.gravity() @ found.statics.fallen(true.tilt) / (found.gravity() @ found.gravity()), -1.0, 1.0))
    whole = all(told("tilt", k) for k in range(2))
    numbers = {(kind, j) for j in range(n) for kind in ("scale", "zero", "offset") if found.is_fault(kind, j)}
    real = {("scale", j) for j in range(n) if true.scale[j] != 1.0} | {("zero", j) for j in range(n) if true.zero[j] != 0.0}
    real |= {("offset", j) for j in range(n) if true.offset[j] != 0.0}
    names = {(each.kind, each.joints) for each in found.mistakes()}
    wires = {(each.kind, each.joints) for each in true.mistakes}
    unseen = {each for each in real if each not in numbers and (each in poorly or not told(*each))}
    return {"arm": case.table["name"], "joints": n, "samples": samples, "planted": [each.sentence(arm.units()) for each in true.mistakes],
            "numbers_planted": len(real), "tilt_planted": float(np.linalg.norm(true.tilt)), "scales_told": len(scale), "zeros_told": len(turns),
            "scale_error": float(max(scale, default=0.0)), "zero_error": float(max(turns, default=0.0)), "slide_error": float(max(slides, default=0.0)),
            "tilt_error": float(tilt) if whole else None, "missed": sorted(map(str, (wires - names) | (real - numbers - unseen))),
            "invented": sorted(map(str, (names - wires) | (numbers - real))), "called_untold": sorted(map(str, unseen)),
            "told_apart": not [each for each in found.alike if each.cost < found.hypothesis.cost + ALIKE],
            "residual": float(found.residuals().max()), "tilt_invented": bool(found.tilt_is_fault() and not np.any(true.tilt)),
            "tilt_missed": bool(np.linalg.norm(true.tilt) > np.radians(0.5) and whole and not found.tilt_is_fault())}


def text(rows):
    lines = [f"{'arm':<8} {'samples':>7} {'scale, %':>9} {'zero, deg':>10} {'tilt, deg':>10}  missed / invented / not told"]
    for row in rows:
        tilt = "-" if row["tilt_error"] is None else f"{np.degrees(row['tilt_error']):.3f}"
        lines.append(f"{row['arm']:<8} {row['samples']:>7} {100 * row['scale_error']:>9.2f} {np.degrees(row['zero_error']):>10.3f} {tilt:>10}  "
                     f"{row['missed']} / {row['invented']} / {row['called_untold']}{'' if row['told_apart'] else ' (or another)'}")
    return "\n".join(lines)


def main(arguments):
    parser = argparse.ArgumentParser(prog="study", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("--program", "--simulator", "--output"):
        parser.add_argument(name, required=True)
    parser.add_argument("--documents")
    parser.add_argument("--arms", default=",".join(map(str, range(1, ARMS + 1))))
    options = parser.parse_args(arguments)
    folder, rows = pathlib.Path(options.output), []
    folder.mkdir(parents=True, exist_ok=True)
    for number in map(int, options.arms.split(",")):
        print(f"arm {number} ...", file=sys.stderr, flush=True)
        case = Case(options.program, options.simulator, folder, number - 1)
        rows += [case.row(samples) for samples in (SAMPLES, 1)]
        print(text(rows[-2:]), file=sys.stderr, flush=True)
        (folder / "commissioning.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    print(text(rows))
    if options.documents:
        documents(options, folder, pathlib.Path(options.documents))


def documents(options, folder, doc):
    """Raw data, and the picture of an arm with three mistakes."""
    shutil.copy(folder / "commissioning.json", doc / "data")
    case = Case(options.program, options.simulator, folder, 9)
    commission.write_torques(folder / "commissioning.csv", case.found())
    commission.draw(folder / "commissioning.csv")
    shutil.copy(folder / "commissioning.png", doc / "pictures")


if __name__ == "__main__":
    main(sys.argv[1:])
