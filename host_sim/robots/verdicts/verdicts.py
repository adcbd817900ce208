"""What identification says of logs without a mistake and of logs with one: the last tables of doc/measurements/identified_arms.md.

usage: verdicts.py --program robot_regressor --output FOLDER [--documents DOC] [--arms NAME,...] [--seed N]

The twenty arms of commissioning's study: of robots/, imported ones (tests/data/descriptions), drawn ones of shapes that mislead. Of each three logs without a mistake and three
with one. Bodies are up to 30 % off, friction is not the header's, drives differ in noise. Torques are those of the model that identification has: what
is judged here is the verdict, by identification/study.py the equations.
"""

import argparse
import contextlib
import dataclasses
import io
import pathlib
import sys

import numpy as np

sys.path += [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("identification", "commissioning")]
import doubts  # noqa: E402
import drawn_logs  # noqa: E402
import excite  # noqa: E402
import identify  # noqa: E402
import judged_logs  # noqa: E402
import recording  # noqa: E402
import robot as robots  # noqa: E402
from suspects import Suspect  # noqa: E402

KINDS = ("torques exchanged", "positions exchanged", "drives exchanged", "torque negated", "position negated", "axis turned", "degrees", "torque scaled",
         "zero off", "every torque negated", "other units")
DURATION, HARMONICS, RATE = 8.0, 5, 250.0  # s, of the base frequency, Hz
SPREAD = 0.3
LIMIT = 0.01 * identify.RESIDUAL_LIMIT


def altered(robot, random):
    """Standard parameters of an arm that is not quite the robot: every body by a factor of its own; friction that no header knows."""
    links = len(robot.links)
    bodies = np.repeat(random.uniform(1.0 - SPREAD, 1.0 + SPREAD, links), len(robot.kinds) // links)
    return np.where([kind in ("viscous", "forward", "backward", "rotor") for kind in robot.kinds], 1.0, bodies) * robot.prior


def honest(robot, random):
    """A log without noise, and the noise of its torques."""
    excitation = excite.Excitation(robot, DURATION, HARMONICS)
    shape = excitation.best(int(random.integers(1000)), 0)[1]
    time = np.arange(int(DURATION * RATE) + 1) / RATE
    q, qd, qdd = excite.motion_at(excitation, shape, time)
    parameters = altered(robot, random)
    regressor, known = robot.regressor(q, qd, qdd)
    size = np.sqrt(np.mean((regressor @ parameters + known) ** 2, axis=0))
    for i, kind in enumerate(robot.kinds):
        if robot.drives[i] is not None and kind in ("viscous", "forward", "backward"):
            level = size.max() * random.uniform(0.005, 0.05)
            parameters[i] = level / np.abs(qd[:, robot.drives[i]]).max() if kind == "viscous" else level if kind == "forward" else -level
    tau = regressor @ parameters + known
    size = np.sqrt(np.mean(tau ** 2, axis=0))
    own = np.maximum(size, 0.02 * size.max()) if random.integers(2) else np.full(len(robot), size.max() / 4)
    return recording.Recording(time, q, None, tau, []), own * random.choice([0.002, 0.01, 0.04])


def drawn_mistake(robot, kind, random):
    n = len(robot)
    pair, joint = tuple(sorted(map(int, random.permutation(n)[:2]))), int(random.integers(n))
    turning = tuple(j for j, each in enumerate(robot.joints) if not each["prismatic"])
    joints = pair if kind.endswith("exchanged") else {"degrees": turning, "every torque negated": tuple(range(n)), "other units": tuple(range(n))}.get(kind, (joint,))
    value = {"torque scaled": random.choice([0.6, 1.5]), "zero off": 0.1 if robot.joints[joint]["prismatic"] else random.choice([-1.0, 1.0]) * random.choice([0.3, 1.0]),
             "other units": random.choice([1e3, 1e-3])}.get(kind, 0.0)
    return Suspect({"every torque negated": "torque negated", "other units": "torque scaled"}.get(kind, kind), joints, float(value))


def planted(log, mistake):
    """The log as it would be with the mistake; written apart from what undoes one."""
    q, tau, joints = log.q.copy(), log.tau.copy(), list(mistake.joints)
    concerned = {"torques exchanged": (tau,), "positions exchanged": (q,), "drives exchanged": (q, tau), "torque negated": (tau,), "position negated": (q,),
                 "axis turned": (q, tau), "degrees": (q,), "torque scaled": (tau,), "zero off": (q,)}[mistake.kind]
    for values in concerned:
        if mistake.kind.endswith("exchanged"):
            values[:, joints] = values[:, joints[::-1]]
        elif mistake.kind == "zero off":
            values[:, joints] += mistake.value
        else:
            values[:, joints] *= {"degrees": 180.0 / np.pi, "torque scaled": mistake.value}.get(mistake.kind, -1.0)
    return dataclasses.replace(log, q=q, tau=tau)


def said(robot, log):
    """What is said of a log; empty where it is taken without a note."""
    options = argparse.Namespace(log="log", keep=(), cutoff=None, residual_limit=identify.RESIDUAL_LIMIT, torque_scale=None)
    try:
        with contextlib.redirect_stderr(io.StringIO()):
            found = identify.identified(robot, log, options)
            identify.refuse(found, {"log": found.equations}, options)
            return " ".join(identify.suspicion(found, options))
    except ValueError as error:
        return str(error)


# What a log can tell, from exact torques.

def tellable(robot, log, noise, mistake):
    """Whether bodies leave more than the limit beyond noise, and each other suspect, too; what else explains the log where one does."""
    fitted = lambda suspect: _left(robot, doubts.mended(log, suspect) if suspect else log)
    needed = np.sqrt(2.0) * np.hypot(LIMIT, np.max(noise / np.sqrt(np.mean(log.tau ** 2, axis=0))))
    if fitted(None) < needed:
        return False, "bodies of other masses"
    plain = identify.Fit(robot, log)
    judge = doubts.Doubts(robot, log, plain.columns, plain.known, None)
    for each in judge.ranked():
        if judge.score(each) > needed:
            break
        if _stem(robot, each) != _stem(robot, mistake) and fitted(each) < needed:
            return False, each.sentence(_units(robot), robot.noun)
    return True, ""


def _left(robot, log):
    try:
        return identify.Identification(robot, log, units_are_told=True).residuals().max()
    except ValueError:
        return np.inf


def _units(robot):
    return [robot.unit(joint) for joint in range(len(robot))]


def _stem(robot, mistake):
    """A sentence without its number."""
    if mistake.kind == "torque scaled" and len(mistake.joints) > 1:
        return "every tau looks scaled"
    return mistake.sentence(_units(robot), robot.noun).split(" by ")[0].split(": ")[0]


def outcome(robot, mistake, text):
    """In a word, what became of a log."""
    if mistake is None:
        return "false" if text else "nothing wrong"
    if _stem(robot, mistake) in text:
        return "cannot tell" if "does not tell" in text else "named"
    return "nothing wrong" if not text else "unnamed" if "no single exchange" in text else "false"


class Logs(judged_logs.Logs):
    """The logs of one arm."""

    def __init__(self, program, folder, number, seed=1):
        super().__init__(folder, number, seed)
        self.robot = self.engine = robots.Robot(program, drawn_logs.robot_of(self.name, folder))

    def row(self, k, guilty):
        robot, random = self.robot, self.random(k, guilty)
        exact, noise = honest(robot, random)
        kind = self.kind(k, KINDS)
        mistake = drawn_mistake(robot, kind, random) if guilty else None
        count = np.where([joint["prismatic"] for joint in robot.joints], 0.1, 2.0 * np.pi) / 2 ** random.integers(13, 18)
        log = dataclasses.replace(exact, q=np.round(exact.q / count) * count, tau=exact.tau + noise * random.normal(0.0, 1.0, exact.tau.shape))
        text = said(robot, planted(log, mistake) if guilty else log)
        units = kind == "other units"  # no residual tells them: it is the description that is asked
        can, like = (units, "") if units or not guilty else tellable(robot, planted(exact, mistake), noise, mistake)
        return {"arm": self.name, "joints": len(robot), "log": k + 1, "mistake": kind if guilty else None, "planted": _stem(robot, mistake) if guilty else "",
                "said": text, "outcome": outcome(robot, mistake, text), "tellable": bool(can and guilty), "like": like}


def text(row):
    return f"{row['arm']:<16} {row['log']} {row['planted'] or 'no mistake':<60} {'told' if row['tellable'] else row['like']:<30} {row['outcome']}"


def main(arguments):
    judged_logs.run("verdicts", __doc__, Logs, text, "identification_verdicts.json", arguments)


if __name__ == "__main__":
    main(sys.argv[1:])
