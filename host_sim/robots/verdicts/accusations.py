"""What commissioning says of arms without a fault and of arms with one: the second half of doc/measurements/commissioned_arms.md.

usage: accusations.py --program gravity_parts --output FOLDER [--documents DOC] [--arms NAME,...] [--seed N]

Twenty arms (drawn_logs.py), of each three logs without a fault and three with one. Torques are those of the model that commissioning has: what is judged
here is the verdict, by commissioning/study.py the equations.
"""

import dataclasses
import pathlib
import sys

import numpy as np
import scipy.optimize

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "commissioning"))
import commission  # noqa: E402
import drawn_logs  # noqa: E402
from engine import Arm, suspects  # noqa: E402
from judged_logs import LOGS  # noqa: E402
import judged_logs  # noqa: E402
import poses as files  # noqa: E402
from report import Report  # noqa: E402
from statics import Rows, Statics  # noqa: E402
import study  # noqa: E402
from verdict import Verdict  # noqa: E402
import wiring  # noqa: E402

SEEN = 60.0  # of chi squared: what a fault changes beyond all else that may be unknown, from which the poses can tell it


# What poses can tell, from exact rows and true noise.

def seen(statics, base, fault):
    """The least chi squared by which the log differs from what a sound arm or another single mistake makes, all other unknowns set free; which."""
    if fault.kind in ("zero", "scale", "offset", "tilt"):
        return _number_seen(statics, base, fault)
    rows = drawn_logs.exact(statics, dataclasses.replace(base, kept=np.broadcast_to(base.kept.mean(axis=0), base.kept.shape)), fault)
    columns = [rows.q, rows.tau, rows.side]
    for each in fault.mistakes():
        columns = drawn_logs.planted(each, columns)
    log, noise = Rows(rows.mass, columns[2], columns[0], columns[1]), wiring.redone(_noise(statics, base)[None, :], fault.mistakes())
    rivals = [()] + [(each,) for each in wirings(len(statics.arm), rows.mass.max()) if (each.kind, each.joints, each.value) != (*fault.key(), fault.value)]
    distances = [_distance(statics, log, np.abs(noise), each) for each in rivals]
    nearest = next(each for each, distance in zip(rivals, distances) if distance < min(distances) + 1.0)
    return min(distances), nearest[0].sentence(statics.arm.units(), statics.arm.noun) if nearest else "nothing is wrong"


def wirings(n, mass):
    return suspects.wirings(n) + [each for each in suspects.signs(n) if len(each.joints) == 1] + wiring.of_file(n, mass)


def _noise(statics, base):
    """Of each drive's torque: its own, the change of friction, the encoder's count."""
    jacobian = statics.jacobian(base.rows, drawn_logs.described(statics))[:, :, statics.unknowns.of("zero")]
    encoder = np.sqrt(np.mean(np.sum((jacobian * base.count) ** 2, axis=2), axis=0) / 12.0)
    return np.sqrt(base.noise ** 2 + encoder ** 2 + (base.friction * base.kept.std(axis=0)) ** 2)


def _distance(statics, log, noise, rival):
    """Chi squared of a log under a rival to what made it: all numbers free about the description, scales that have its sign, friction against motion."""
    rows, x = wiring.undone(log, rival), drawn_logs.described(statics)
    sigma = np.abs(wiring.redone(noise, rival))
    left = ((rows.tau - statics.predicted(rows, x)) / sigma).ravel()
    jacobian = (statics.jacobian(rows, x) / sigma[:, :, None]).reshape(-1, len(x))[:, statics.free]
    weak = np.diag(np.where(np.isfinite(statics.likely), 1.0 / statics.likely, 1e-9))[statics.free][:, statics.free]
    low = np.full(len(x), -np.inf)
    low[statics.unknowns.of("coulomb")], low[statics.unknowns.of("scale")] = 0.0, -1.0
    whole = np.concatenate([jacobian, weak])
    length = np.linalg.norm(whole, axis=0)
    found = scipy.optimize.lsq_linear(whole / length, np.concatenate([left, np.zeros(len(weak))]), (low[statics.free] * length, np.inf))
    return float(2.0 * found.cost)


def _number_seen(statics, base, fault):
    """Of one number: the square of its size over its standard deviation, other numbers free."""
    x = fault.x(statics, drawn_logs.sizes(statics, base.rows))
    off = x - drawn_logs.described(statics)
    jacobian = (statics.jacobian(base.rows, x) / _noise(statics, base)[:, None]).reshape(-1, len(off))
    weak = np.diag(np.where(np.isfinite(statics.likely), 1.0 / statics.likely ** 2, 1e-12))
    free = statics.free
    information = (jacobian.T @ jacobian + weak)[free][:, free]
    places = np.flatnonzero(off[free])
    covariance = np.linalg.pinv(information, rcond=1e-14, hermitian=True)[np.ix_(places, places)]
    return float(off[free][places] @ np.linalg.solve(covariance, off[free][places])) if len(places) else 0.0, "another number is wrong"


# Verdicts.

def claims(verdict):
    """What is said to be wrong."""
    n = range(len(verdict.arm))
    numbers = {(kind, (j,)) for j in n for kind in ("scale", "zero", "offset") if verdict.is_fault(kind, j)}
    wires = {(each.kind, each.joints) for each in verdict.mistakes()}
    tilt = {("tilt", ())} if verdict.tilt_is_fault() else set()
    return numbers | wires | tilt


def ways(verdict, report):
    """Of mistakes that the poses do not tell apart."""
    return [sorted((each.kind, each.joints) for each in wiring.named(way, verdict.statics)) for way in (verdict.hypothesis, *report.either)] if report.either else []


def judged(arm, path):
    verdict = Verdict(Statics(arm), files.read(path, arm))
    report = Report(verdict, 0.01 * commission.RESIDUAL_LIMIT)
    return {"claims": sorted(claims(verdict)), "ways": ways(verdict, report), "unexplained": report.unexplained(), "notes": report.untold()}


def outcome(row):
    """In a word, what became of a log."""
    fault = row["fault"] and tuple(row["fault"])
    if row["unexplained"]:
        return "false"
    if row["ways"]:
        return "cannot tell" if [fault] in row["ways"] else "false"
    if row["claims"] == ([fault] if fault else []):
        return "named" if fault else "nothing wrong"
    return "cannot tell" if not row["claims"] else "false"


class Logs(judged_logs.Logs):
    """The logs of one arm."""

    def __init__(self, program, folder, number, seed=1):
        super().__init__(folder, number, seed)
        self.arm = self.engine = Arm(program, drawn_logs.robot_of(self.name, folder))
        self.statics = Statics(self.arm)

    def fault(self, random, k):
        return drawn_logs.drawn_fault(self.statics, random, self.kind(k + LOGS * self.number // len(drawn_logs.FAULTS), drawn_logs.FAULTS))

    def row(self, k, guilty):
        random = self.random(k, guilty)
        base = drawn_logs.honest(self.statics, random)
        fault = self.fault(random, k) if guilty else drawn_logs.Fault("none")
        path = self.folder / f"{self.name}-{'guilty' if guilty else 'innocent'}-{k + 1}.csv"
        study.write(path, len(self.arm), drawn_logs.recorded(self.statics, base, fault, random))
        row = {"arm": self.name, "joints": len(self.arm), "log": k + 1, "fault": fault.key() if guilty else None, "value": fault.value, **judged(self.arm, path)}
        row["outcome"] = outcome(row)
        row["seen"], row["like"] = seen(self.statics, base, fault) if guilty else (0.0, "")
        return {**row, "tellable": row["seen"] >= SEEN}


def text(row):
    fault = "no fault" if row["fault"] is None else f"{row['fault'][0]} {', '.join(str(j + 1) for j in row['fault'][1])} ({row['value']:.3g}), seen {row['seen']:.3g}"
    told = "" if row["outcome"] in ("nothing wrong", "named") else f"; claims {row['claims']}, ways {row['ways']}, {row['unexplained'] or 'all explained'}"
    return f"{row['arm']:<16} {row['log']} {fault:<60} {row['outcome']}{told}"


def main(arguments):
    judged_logs.run("accusations", __doc__, Logs, text, "accusations.json", arguments)


if __name__ == "__main__":
    main(sys.argv[1:])
