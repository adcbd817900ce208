"""Single mistakes of wiring, signs, zeros and units that make positions and torques those of another robot, and the search for the one that
explains them, as ./axial identify asks. Joints count from 0 here and from 1 in sentences.
"""

import dataclasses
import itertools

import numpy as np
import scipy.optimize

TURN = 2.0 * np.pi
ZEROS = 12  # of a revolute joint, a turn's parts that are tried; of a slide, of its range
LIKELY = 3  # joints whose zero is refined
SLIDE = 0.5  # m: the range of a slide without limits
MASSES = {1e-3: "looks given in grams", 0.45359237: "looks given in pounds", 0.0: "has no effect: was it there?"}  # by the factor that undoes it
LEAST_SCALE = 0.2  # a torque that is scaled by less explains nothing: it only gets small


@dataclasses.dataclass(frozen=True)
class Suspect:
    """What may have happened to a recording. `undone` tells the motion and the torques that it would have been without."""

    kind: str
    joints: tuple
    value: float = 0.0

    def undone(self, motion, tau):
        """motion: arrays of q and its derivatives, columns joints; tau likewise. All are copied."""
        motion, tau = [np.array(each) for each in motion], np.array(tau)
        changed = {"mass": [], "sides negated": motion[1:], "torques exchanged": [tau], "positions exchanged": motion, "drives exchanged": [*motion, tau], "torque negated": [tau],
                   "position negated": motion, "axis turned": [*motion, tau], "degrees": motion, "torque scaled": [tau], "zero off": motion[:1]}
        for values in changed[self.kind]:
            self._undo(values)
        return motion, tau

    def _undo(self, values):
        joints = list(self.joints)
        if "exchanged" in self.kind:
            values[:, joints] = values[:, joints[::-1]]
        elif self.kind == "zero off":
            values[:, joints] -= self.value
        else:
            factor = {"degrees": np.pi / 180.0, "torque scaled": 1.0 / self.value if self.value else 1.0}
            values[:, joints] *= factor.get(self.kind, -1.0)

    def sentence(self, units, noun="joint"):
        """units: of each joint's torque, "N m" or "N"; noun: what has values, joints or the drives that they share."""
        if self.kind == "mass":
            return f"the mass at the tool {MASSES[self.value]}"
        first, last = self.joints[0] + 1, self.joints[-1] + 1
        every = len(self.joints) > 1
        return {"sides negated": f"friction helps the motion at every {noun}: the sides look exchanged in the file",
                "torques exchanged": f"columns tau{first} and tau{last} look exchanged",
                "positions exchanged": f"columns q{first} and q{last} look exchanged",
                "drives exchanged": f"drives {first} and {last} look exchanged, positions and torques",
                "torque negated": "every tau looks negated" if every else f"tau{first} looks negated",
                "position negated": f"q{first} looks negated",
                "axis turned": f"the {'axis of joint' if noun == 'joint' else noun} {first} looks turned around: q{first} and tau{first} are both negated",
                "degrees": "every angle looks given in degrees" if every else f"q{first} looks given in degrees",
                "torque scaled": f"tau{first} looks scaled by {self.value:.4g}",
                "zero off": f"the zero of {noun} {first} looks off: q{first} is {_offset(self.value, units[first - 1])} too large"}[self.kind]


def _offset(value, unit):
    return f"{1000 * value:.3g} mm" if unit == "N" else f"{np.degrees(value):.3g} degrees"


def wirings(joints):
    """Every pair exchanged: torques, positions, both."""
    return [Suspect(kind, pair) for kind in ("torques exchanged", "drives exchanged", "positions exchanged")
            for pair in itertools.combinations(range(joints), 2)]


def signs(joints):
    """Every sign turned: of a torque, of all, of a position, of an axis."""
    one = [Suspect(kind, (joint,)) for kind in ("torque negated", "axis turned", "position negated") for joint in range(joints)]
    return one + ([Suspect("torque negated", tuple(range(joints)))] if joints > 1 else [])


def degrees(prismatic):
    turning = tuple(joint for joint, slides in enumerate(prismatic) if not slides)
    return [Suspect("degrees", turning)] if turning else []


def periodic(joint):
    """Whether a turn of a joint, or of a drive, leaves the robot as it was."""
    return joint.get("periodic", not joint["prismatic"])


def zeros(robot, score):
    """The best zero of each of the likeliest joints. score(suspect): smaller is better."""
    coarse = []
    for joint in range(len(robot)):
        limits = [robot.joints[joint][name] for name in ("position_min", "position_max")]
        span = TURN if periodic(robot.joints[joint]) else (SLIDE if robot.joints[joint]["prismatic"] else TURN) if None in limits else limits[1] - limits[0]
        step = span / ZEROS
        tried = [Suspect("zero off", (joint,), step * k) for k in range(-ZEROS // 2, ZEROS // 2 + 1)]
        scores = [score(each) for each in tried]
        best = int(np.argmin(scores))
        coarse.append((scores[best], joint, tried[best].value, step))
    return [_refined(joint, value, step, score) for _, joint, value, step in sorted(coarse)[:LIKELY]]


def _refined(joint, value, step, score):
    found = scipy.optimize.minimize_scalar(lambda zero: score(Suspect("zero off", (joint,), zero)), bounds=(value - step, value + step),
                                           method="bounded", options={"xatol": 1e-5 * step})
    return Suspect("zero off", (joint,), float(found.x))
