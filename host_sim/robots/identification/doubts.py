"""Which single mistake explains a log that the fit does not: every suspect is judged on few rows, the likeliest by a whole fit."""

import dataclasses

import numpy as np
import scipy.linalg

import smoothing
import suspects

ROWS = 300  # instants that a suspect is judged on
FINALISTS = 4  # suspects that get a whole fit, beside negated torques, and other signs of the same score: negative masses fit those as well
SIGNS = ("axis turned", "position negated")
MENDS = 0.4  # of the residual as recorded: what a remedy must at least come to
NOTHING = 0.01  # of a torque, left beyond noise: no more than noise's own doubt; of two such fits the residual tells the better
ALIKE, EXACT = 1.05, 1e-4  # residuals by which this log does not tell two suspects apart: times the smaller, and beyond it
SCALES_ALIKE = 0.02  # a torque scaled by this much of -1 is negated
OTHER_UNITS, UNLIKELY = 30.0, 5.0  # times the torques of the description: no bodies are that far off; few are
EXPLAINED = 0.4  # of the torques, by one factor on the description's


class Doubts:
    """The smoothed rows of a log, on which suspects are tried. columns: base parameters; known: what the prior has."""

    def __init__(self, robot, log, columns, known, cutoff):
        smoother = smoothing.Smoother(1.0 / log.step, cutoff)
        motion, kept = smoother.motion(log), smoother.kept(len(log.time))
        kept = kept[::max(1, len(kept) // ROWS)]
        self.robot, self.columns, self.known = robot, columns, known
        self.motion = [each[kept] for each in (motion.q, motion.qd, motion.qdd)]
        self.tau = smoother.low_pass(log.tau)[kept]

    def score(self, suspect):
        """Of a suspect: RMS over joints of the residual of the linear fit over the joint's torque."""
        rows = self._rows(*suspect.undone(self.motion, self.tau))
        regressor, tau = (np.concatenate(each) for each in zip(*rows))
        return float(np.sqrt(np.mean(_residual(regressor, tau) ** 2)))

    def _rows(self, motion, tau):
        """The equations of each joint, over its torque's RMS."""
        regressor, known = self.robot.regressor(*motion, np.concatenate([self.columns, self.known]))
        tau = tau - known - regressor[:, :, len(self.columns):] @ self.robot.prior[self.known]
        valid = np.abs(motion[1]) > smoothing.SLOW * np.abs(motion[1]).max(axis=0)
        return [(regressor[valid[:, j], j, :len(self.columns)] / size, tau[valid[:, j], j] / size)
                for j, size in enumerate(np.sqrt(np.mean(tau ** 2, axis=0)) + 1e-300)]

    def scales(self):
        """Of each joint, the scale of its torque that fits best, a column more of the linear fit: tau / scale = Y theta."""
        found = []
        rows = self._rows(self.motion, self.tau)
        for joint in range(len(self.robot)):
            column = [tau if j == joint else np.zeros(len(tau)) for j, (_, tau) in enumerate(rows)]
            tau = np.concatenate([np.zeros(len(each)) if j == joint else each for j, (_, each) in enumerate(rows)])
            regressor = np.column_stack([np.concatenate([each for each, _ in rows]), -np.concatenate(column)])
            inverse = scipy.linalg.lstsq(regressor, tau, lapack_driver="gelsy")[0][-1]
            if suspects.LEAST_SCALE < abs(inverse) < 1.0 / suspects.LEAST_SCALE and abs(inverse + 1.0) > SCALES_ALIKE:
                found.append(suspects.Suspect("torque scaled", (joint,), 1.0 / float(inverse)))
        return found

    def ranked(self):
        """Every suspect, the best score first."""
        prismatic = [joint["prismatic"] for joint in self.robot.joints]
        tried = suspects.wirings(len(self.robot)) + suspects.signs(len(self.robot)) + suspects.degrees(prismatic)
        tried += self.scales() + suspects.zeros(self.robot, self.score)
        scores = [self.score(each) for each in tried]
        return [tried[i] for i in np.argsort(scores, kind="stable")]


class OtherUnits(ValueError):
    """Every torque is so many times what the description says that it must be in another unit."""


def shared_scale(equations, prior):
    """The one factor on the description's torques, friction and rotors that it lacks apart, that comes nearest to a log's; the part of the
    log's torques that it explains. Bodies take any factor in: no residual tells it."""
    size = np.sqrt(np.sum(np.where(equations.valid, equations.tau, 0.0) ** 2, axis=0) / equations.valid.sum(axis=0)) + 1e-300
    weight = equations.valid / size
    said, measured = equations.regressor @ prior * weight, equations.tau * weight
    scale = float(np.sum(said * measured) / max(np.sum(said * said), 1e-300))
    return scale, 1.0 - float(np.sum((measured - scale * said) ** 2) / max(np.sum(measured * measured), 1e-300))


def check_units(scale, explained):
    """Nothing, or a doubt; raises OtherUnits."""
    size = max(abs(scale), 1.0 / max(abs(scale), 1e-300))
    if size < UNLIKELY or explained < EXPLAINED:
        return []
    text = f"every tau looks scaled by {scale:.4g}: that many times the description's torques, of which it explains {100 * explained:.3g} %"
    if size < OTHER_UNITS:
        return [text + "; are they of the drives, on the joint's side, in N m?"]
    raise OtherUnits(text + f"; is the unit N m? --torque-scale {np.sign(scale) * 10.0 ** np.round(np.log10(abs(scale))):g} divides them, --torque-scale 1 takes them as they are")


def _residual(regressor, tau):
    length = np.linalg.norm(regressor, axis=0)
    scaled = regressor / np.where(length > 0.0, length, 1.0)
    return tau - scaled @ scipy.linalg.lstsq(scaled, tau, lapack_driver="gelsy")[0]


@dataclasses.dataclass
class Remedy:
    suspect: suspects.Suspect
    residual: float  # of the whole fit without the mistake
    left: float  # of that, beyond noise
    others: tuple = ()  # suspects without which as little is left: the log does not tell which it is

    def sentence(self, units, noun="joint"):
        return ", or ".join(each.sentence(units, noun) for each in (self.suspect, *self.others)) + (" (this log does not tell which)" if self.others else "")


def mended(log, suspect):
    """The log as it would be without the mistake."""
    speeds = [] if log.qd is None else [log.qd]
    motion, tau = suspect.undone([log.q, *speeds], log.tau)
    return dataclasses.replace(log, q=motion[0], qd=motion[1] if speeds else None, tau=tau)


def best_remedy(doubts, log, residual_of):
    """The best of the finalists; residual_of(log): the residual of a whole fit, and what of it is beyond noise."""
    ranked = doubts.ranked()
    least = doubts.score(ranked[0])
    finalists = ranked[:FINALISTS] + [each for each in ranked[FINALISTS:] if each.kind == "torque negated" or
                                      each.kind in SIGNS and doubts.score(each) <= ALIKE * least + EXACT]
    best, *others = sorted((Remedy(each, *residual_of(mended(log, each))) for each in finalists), key=lambda remedy: (max(remedy.left, NOTHING), remedy.residual))
    best, *others = _plain([best] + [each for each in others if each.left <= max(ALIKE * best.left + EXACT, NOTHING) and each.residual <= ALIKE * best.residual + EXACT])
    return dataclasses.replace(best, others=tuple(each.suspect for each in others))


def _plain(alike):
    """Without scales of a torque that is negated as well: a number more explains no less."""
    negated = [each.suspect.joints for each in alike if each.suspect.kind == "torque negated"]
    return [each for each in alike if each.suspect.kind != "torque scaled" or each.suspect.value > 0.0 or each.suspect.joints not in negated]


def mends(before, remedy, limit):
    return remedy.left <= min(limit, MENDS * before)


def sentence(robot, before, remedy, limit):
    """What is said of a log that does not fit."""
    units = [robot.unit(joint) for joint in range(len(robot))]
    if mends(before, remedy, limit):
        change = f"falls from {100 * before:.3g} % to" if np.isfinite(before) else "is then"
        return f"{remedy.sentence(units, robot.noun)}: the residual {change} {100 * remedy.residual:.2g} %"
    return (f"no single exchange of columns, sign, zero, scale or unit of a {robot.noun} mends it (the best one leaves "
            f"{100 * remedy.left:.3g} %); is it this robot, its gravity, its payload? is something flexible or in contact?")
