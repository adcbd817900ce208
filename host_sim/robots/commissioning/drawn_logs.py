"""Arms and logs of held poses for accusations.py: without a fault, and with one.

Robots of robots/, imported ones (tests/data/descriptions), drawn ones of the shapes that mislead. Friction is not the header's, and lessens while an
arm is held; drives differ in noise; encoders count.

usage: drawn_logs.py SEED FILE.json    the table of an arm that SEED, hexadecimal, draws, for ./axial import
"""

import dataclasses
import json
import pathlib
import sys

import numpy as np

import design
from engine import suspects
from statics import Rows

ROOT = pathlib.Path(__file__).resolve().parents[3]
ROBOTS = ("scara", "scara_rrpr", "puma560", "panda", "wrist_arm", "palletiser", "two_arm")
IMPORTED = ("z1", "ur3", "iiwa", "gen3_7dof", "fr3", "m1013", "stanford")
DRAWN = ("wall", "symmetric_wrist", "one_heavy", "idle_joints", "slides", "planar")
ARMS = (*ROBOTS, *IMPORTED, *DRAWN)
POSES = 12
WIRES = ("torques exchanged", "positions exchanged", "drives exchanged", "torque negated", "position negated", "axis turned")
FAULTS = (*WIRES, "zero", "scale", "offset", "tilt", "sides negated", "mass")


def table(shape, seed=31):
    """An arm of that shape that nobody has seen."""
    random, joints = np.random.default_rng([DRAWN.index(shape), seed]), 4 if shape == "planar" else 6
    links = [_link(shape, i, joints, random) for i in range(joints)]
    gravity = [0.0, -9.81, 0.0] if shape in ("wall", "planar") else [0.0, 0.0, -9.81]
    return {"name": shape, "convention": "modified", "gravity": gravity, "tool": {"xyz": [0.0, 0.0, 0.08] if shape == "symmetric_wrist" else [0.03, 0.0, 0.08]},
            "links": links}


def _link(shape, i, joints, random):
    draw = lambda low, high, *size: np.round(random.uniform(low, high, *size), 4).tolist()
    wrist = shape == "symmetric_wrist" and i >= joints - 3
    mass = 20.0 if shape == "one_heavy" and i == 1 else 0.3 if shape == "one_heavy" else round(5.0 * 0.7 ** i, 3)
    twist = 0.0 if shape == "planar" or i == 0 or (shape == "idle_joints" and i < 3) else 90.0 * random.choice([-1, 1])
    link = {"type": "revolute", "alpha_deg": twist, "a": 0.0 if wrist or i == 0 else draw(0.05, 0.3), "d": 0.0 if wrist else draw(0.05, 0.2), "theta_deg": 0.0,
            "mass": mass, "com": [0.0, 0.0, 0.02] if wrist else draw(-0.08, 0.12, 3), "inertia_com": [0.05 * mass] * 3, "position_limits": [-2.4, 2.4],
            "speed_limit": 2.0, "acceleration_limit": 10.0, "effort_limit": 400.0}
    if shape == "slides" and i in (1, 3):
        link.update(type="prismatic", position_limits=[0.0, 0.5], theta_deg=90.0)
    return link


def robot_of(name, folder):
    """What gravity_parts takes for it."""
    if name in IMPORTED:
        return ROOT / f"tests/data/descriptions/{name}.json"
    if name not in DRAWN:
        return name
    path = pathlib.Path(folder) / f"{name}.json"
    path.write_text(json.dumps(table(name)), encoding="utf-8")
    return path


@dataclasses.dataclass
class Honest:
    """Held poses of an arm, and all that is nobody's fault: friction, noise, encoders."""

    mass: float
    rows: Rows  # where the arm truly stands
    friction: np.ndarray  # a level per drive
    kept: np.ndarray  # rows x joints: the part of it that is there after a while
    noise: np.ndarray  # standard deviation per drive
    count: np.ndarray  # of encoders: rad or m


def honest(statics, random):
    arm, n = statics.arm, len(statics.arm)
    mass = _mass(statics)
    designer = design.Designer(statics, mass, int(random.integers(1000)))
    rows = designer.rows(designer.poses[designer.chosen(POSES)])
    rows.q = rows.q + random.normal(0.0, 1.0, rows.q.shape) * np.where(arm.prismatic, 1e-4, 1e-3)  # a drive stops near its set-point
    size = sizes(statics, rows)
    declared = np.array([0.5 * (joint["coulomb_forward"] - joint["coulomb_backward"]) for joint in arm.joints])
    friction = np.where(declared > 0.0, declared * random.uniform(0.1, 1.5, n), size.max() * random.uniform(0.005, 0.06, n))
    own = size if random.integers(2) else np.full(n, size.max() / 4)
    kept = random.uniform(1.0 - random.choice([0.0, 0.1, 0.3]), 1.0, rows.q.shape)
    count = np.where(arm.prismatic, 0.1, 2.0 * np.pi) / 2 ** random.integers(13, 18)
    return Honest(mass, rows, friction, kept, own * random.choice([0.002, 0.01]), count)


def _mass(statics):
    """A third of what the arm itself asks of its drives, in two digits."""
    poses = design.Designer(statics, 1e-3).poses
    parts = statics.arm.parts(poses)
    own, one = (np.sqrt(np.mean((parts[:, :, k:k + 3] @ statics.gravity) ** 2)) for k in (0, 3))
    return float(f"{own / (3.0 * one):.2g}")


def described(statics):
    x = np.zeros(len(statics.unknowns))
    x[statics.unknowns.of("scale")] = 1.0
    return x


def sizes(statics, rows):
    """RMS of each drive's torque, as described; of one that bears next to nothing, a fiftieth of the largest."""
    size = np.sqrt(np.mean(statics.holding(rows, described(statics)) ** 2, axis=0))
    return np.maximum(size, size.max() / 50.0)


@dataclasses.dataclass
class Fault:
    kind: str
    joints: tuple = ()
    value: float = 0.0

    def key(self):
        return (self.kind, tuple(int(j) for j in self.joints))

    def x(self, statics, size):
        """The unknowns as it has them."""
        x, of = described(statics), statics.unknowns.index
        if self.kind == "tilt":
            x[statics.unknowns.of("tilt")] = np.where(statics.free[statics.unknowns.of("tilt")], self.value * np.array([0.8, 0.6]), 0.0)
        elif self.kind in ("zero", "scale", "offset"):
            x[of(self.kind, self.joints[0])] += self.value * (size[self.joints[0]] if self.kind == "offset" else 1.0)
        return x

    def mistakes(self):
        return [suspects.Suspect(self.kind, self.joints)] if self.kind in WIRES else []


def drawn_fault(statics, random, kind):
    n = len(statics.arm)
    pair, joint = tuple(sorted(map(int, random.permutation(n)[:2]))), int(random.integers(n))
    joint = joint if statics.free[statics.unknowns.index("zero", joint)] or kind != "zero" else n - 1
    sign = random.choice([-1.0, 1.0])
    value = {"zero": sign * (random.choice([0.02, 0.05]) if statics.arm.prismatic[joint] else np.radians(random.choice([3.0, 10.0]))),
             "scale": random.choice([-0.3, 0.2, 0.5]), "offset": sign * 0.2, "tilt": np.radians(random.choice([1.5, 4.0])),
             "mass": random.choice(list(suspects.MASSES))}
    joints = {"tilt": (), "sides negated": tuple(range(n)), "mass": tuple(range(n))}.get(kind, pair if kind.endswith("exchanged") else (joint,))
    return Fault(kind, joints, float(value.get(kind, 0.0)))


def exact(statics, base, fault):
    """Rows as drives would report them without noise, before wires mix them up."""
    rows, x = base.rows, fault.x(statics, sizes(statics, base.rows))
    absent = fault.kind == "mass" and fault.value == 0.0
    held = dataclasses.replace(rows, mass=rows.mass * (not absent), q=rows.q + x[statics.unknowns.of("zero")])
    reported = statics.predicted(held, x) + x[statics.unknowns.of("scale")] * base.friction * base.kept * rows.side
    mass = rows.mass / (fault.value if fault.kind == "mass" and not absent else 1.0)
    return Rows(mass, -rows.side if fault.kind == "sides negated" else rows.side, held.q, reported)


def planted(suspect, columns):
    """Columns of positions (True) or torques (False) as the mistake has them; written apart from what undoes one."""
    result = [np.array(each) for each in columns]
    concerned = {"torques exchanged": (1,), "positions exchanged": (0, 2), "drives exchanged": (0, 1, 2), "torque negated": (1,),
                 "position negated": (0, 2), "axis turned": (0, 1, 2)}[suspect.kind]
    for k in concerned:
        if suspect.kind.endswith("exchanged"):
            i, j = suspect.joints
            result[k][:, i], result[k][:, j] = columns[k][:, j], columns[k][:, i]
        else:
            result[k][:, suspect.joints[0]] *= -1.0
    return result


def recorded(statics, base, fault, random):
    """Columns of a file: mass, sides, positions, torques."""
    rows = exact(statics, base, fault)
    q = np.round(rows.q / base.count) * base.count
    columns = [q, rows.tau + base.noise * random.normal(0.0, 1.0, rows.tau.shape), rows.side]
    for each in fault.mistakes():
        columns = planted(each, columns)
    return np.column_stack([rows.mass, columns[2], columns[0], columns[1]])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    drawn = int(sys.argv[1], 16)
    pathlib.Path(sys.argv[2]).write_text(json.dumps({**table(DRAWN[drawn % len(DRAWN)], drawn), "name": "drawn"}) + "\n", encoding="utf-8")
