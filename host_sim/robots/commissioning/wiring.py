"""Which mistakes of wiring, axes and signs explain measured poses: suspects of host_sim/robots/identification, tried alone and together.

A torque's sign is a fitted scale's; so a position negated under a negative scale is an axis turned.
"""

import dataclasses
import itertools

import numpy as np

from engine import suspects
from statics import SURE, Fit, Fitter, Rows

MISTAKE = 14.0  # of evidence (-2 log likelihood) that one mistake more must buy
OF_FILE = ("sides negated", "mass")  # kinds of mistakes that are nobody's drive
LEAST_MASS = 0.02  # kg: nobody commissions with less
AT_ONCE = 3  # mistakes that are searched together
NARROW, WIDE = (8, 3), (16, 10)  # hypotheses that get a whole fit at each step; that are gone on from. Wide where narrow explains too little
ALIKE = 9.0  # of evidence: hypotheses nearer than this the poses do not tell apart
WORST_FRICTION = 60.0  # of evidence: what friction of a wrong sign costs at most
FAR_ZEROS, EXPLAINED = 3, 0.05  # zeros that are sought far off, one after the other; what is left of a torque beyond its noise that needs none
TRIAL, WHOLE = 8, 60  # evaluations of a fit that only ranks; of one that decides


def exchanges(joints):
    return suspects.wirings(joints)


def flips(joints):
    return [each for each in suspects.signs(joints) if each.kind == "position negated"]


def of_file(joints, mass):
    """What may be wrong with the whole file: sides told the other way round; masses in another unit, or not there. mass: the largest."""
    every = tuple(range(joints))
    return [suspects.Suspect("sides negated", every), *(suspects.Suspect("mass", every, factor) for factor in suspects.MASSES if factor == 0.0 or factor * mass > LEAST_MASS)]


@dataclasses.dataclass
class Hypothesis:
    """Mistakes in the order in which they are undone (exchanges, then signs), and what they leave."""

    mistakes: tuple
    fit: Fit = None
    cost: float = np.inf  # evidence, and what its mistakes cost
    raw: float = np.inf  # evidence, and friction of a wrong sign
    claims: int = 0  # mistakes of files and wires, and joints of which a position or a torque has the wrong sign

    def key(self):
        return tuple(sorted((each.kind, each.joints, each.value) for each in self.mistakes))


def undone(poses, mistakes):
    """Rows as they would be without them."""
    mass, motion, tau = poses.mass, [poses.q, poses.side], poses.tau
    for each in mistakes:
        mass = mass * each.value if each.kind == "mass" else mass
        motion, tau = each.undone(motion, tau)
    return Rows(mass, motion[1], motion[0], tau, poses.pose)


def redone(tau, mistakes):
    """Torques as drives report them, of those without mistakes."""
    for each in reversed(mistakes):
        tau = each.undone([], tau)[1]
    return tau


class Search:
    """tell(text): a line of progress."""

    def __init__(self, statics, poses, tell=lambda text: None):
        self.statics, self.poses, self.fitter, self.tell = statics, poses, Fitter(statics), tell
        self.tried = {}

    def best(self):
        """The hypothesis that explains most at least cost, or one that claims less and explains nearly as much; all that got a whole fit are in
        self.tried."""
        best = self._searched(*NARROW, far=0)
        if not self._is_explained(best):
            self.tell("too little is explained: trying zeros far off")
            for each in (self.tried[()], best):
                self.with_far_zeros(each)
            best = min(best, self.tried[()], key=lambda each: each.cost)
        if not self._is_explained(best):
            self.tell("too little is explained: searching wider")
            best = min(best, self._searched(*WIDE, far=NARROW[1]), key=lambda each: each.cost)
        return self.least(self.pruned(self.with_signs_tried(best)))

    def least(self, best):
        """Of those whose evidence is as good, one of those that claim least: a mistake is named where a model without it can not explain the poses.
        Rivals of a named one are fitted as long as it takes."""
        for each in self.tried.values() if best.claims else ():
            if each.claims <= best.claims and each.cost < best.cost + 2.0 * MISTAKE:
                self._fitted_whole(each, best)
        alike = [each for each in self.tried.values() if each.cost <= best.cost + ALIKE]
        return min(alike, key=lambda each: (each.claims, each.cost))

    def pruned(self, best):
        """Less is claimed where less explains as much: every part of the best one, fitted as long as it takes from where the best one stands."""
        for size in range(len(best.mistakes)):
            for mistakes in itertools.combinations(best.mistakes, size):
                self._fitted_whole(self.judged(Hypothesis(mistakes), best), best)
        return min(self.tried.values(), key=lambda each: each.cost)

    def _fitted_whole(self, hypothesis, best):
        """From the description, and from where the best one stands."""
        rows, of = undone(self.poses, hypothesis.mistakes), self.statics.unknowns.of
        for part in (0.0, 1.0):
            start = self.statics.linear_start(rows, part * best.fit.x[of("zero")], part * best.fit.x[of("tilt")])[0]
            self._replaced(hypothesis, rows, start, self.statics.free, WHOLE)
        for joint in negative(hypothesis.fit, self.statics):
            self._with_sign(hypothesis, rows, joint, WHOLE)

    def _is_explained(self, hypothesis):
        return _left(hypothesis.fit, undone(self.poses, hypothesis.mistakes)) < EXPLAINED

    def _searched(self, finalists, width, far):
        """far: how many of each step get zeros far off."""
        root = self.judged(Hypothesis(()), None)
        front, best = [root], root
        for step in range(AT_ONCE):
            self.tell(f"trying exchanged drives, turned axes and signs, {step + 1} at once")
            children = {child.key(): child for parent in front for child in self._children(parent, finalists)}
            front = sorted(children.values(), key=lambda each: each.cost)[:width]
            for each in front[:far]:
                self.with_far_zeros(each)
            front.sort(key=lambda each: each.cost)
            gained = bool(front) and front[0].cost < best.cost
            best = front[0] if gained else best
            if self._is_explained(best):
                if not gained:
                    break
                front = [best]
        return best

    def with_signs_tried(self, best):
        """Every axis of the best one is turned once, so that what the poses do not tell is known."""
        for flip in flips(len(self.statics.arm)):
            child = self.judged(_with(best, flip), best)
            best = child if child.cost < best.cost else best
        return best

    def _children(self, parent, finalists):
        """The likeliest of one mistake more, fitted."""
        joints = len(self.statics.arm)
        more = [_with(parent, each) for each in exchanges(joints) + flips(joints) + of_file(joints, self.poses.mass.max()) if each not in parent.mistakes]
        new = {each.key(): each for each in more}
        scores = self._quick(list(new.values()), parent)
        ranked = [each for _, each in sorted(zip(scores, new.values()), key=lambda pair: pair[0])]
        whole = [] if parent.mistakes else [each for each in ranked[finalists:] if each.mistakes[-1].kind in OF_FILE]
        return [self.judged(each, parent) for each in ranked[:finalists] + whole]

    def _quick(self, hypotheses, parent):
        """Evidence of linear fits, zeros and tilt as in the parent, or none; all positions are asked for at once."""
        of, x = self.statics.unknowns.of, parent.fit.x
        tried = [undone(self.poses, each.mistakes) for each in hypotheses]
        best = np.full(len(tried), np.inf)
        for zero, tilt in ((x[of("zero")], x[of("tilt")]), (0.0 * x[of("zero")], 0.0 * x[of("tilt")])):
            parts = self.statics.arm.parts(np.concatenate([rows.q - zero for rows in tried])) if tried else []
            for k, rows in enumerate(tried):
                own = parts[k * len(rows.mass):(k + 1) * len(rows.mass)]
                held = self.statics.torque(own, rows.mass, self.statics.fallen(tilt))
                best[k] = min(best[k], _evidence(self.statics.linear_start(rows, zero, tilt, held)[1], rows))
        return best

    def judged(self, hypothesis, parent):
        key = hypothesis.key()
        if key in self.tried:
            return self.tried[key]
        rows, of, n = undone(self.poses, hypothesis.mistakes), self.statics.unknowns.of, len(self.statics.arm)
        starts = [(np.zeros(n), np.zeros(2))]
        if parent is not None:
            starts.append((parent.fit.x[of("zero")], parent.fit.x[of("tilt")]))
        begun = [self.statics.linear_start(rows, *each) for each in starts]
        start = min(begun, key=lambda each: _evidence(each[1], rows))[0]
        hypothesis.fit = self.fitter.fit(rows, start, self.statics.free, TRIAL, weighted=False)
        self._weighed(hypothesis, rows)
        for joint in negative(hypothesis.fit, self.statics):
            self._with_sign(hypothesis, rows, joint)
        self.tried[key] = hypothesis
        return hypothesis

    def _with_sign(self, hypothesis, rows, joint, most=TRIAL):
        """Fitted anew with the joint's scale and zero as described: where gravity hardly loads it, noise chose their signs."""
        of, free, start = self.statics.unknowns.index, self.statics.free.copy(), np.array(hypothesis.fit.x)
        start[of("scale", joint)], start[of("zero", joint)] = 1.0, 0.0
        free[[of("scale", joint), of("zero", joint)]] = False
        self._replaced(hypothesis, rows, start, free, most)

    def _replaced(self, hypothesis, rows, start, free, most):
        """By a fit from there, if that costs less."""
        other = dataclasses.replace(hypothesis, fit=self.fitter.fit(rows, start, free, most, weighted=False))
        self._weighed(other, rows)
        if other.cost < hypothesis.cost:
            hypothesis.fit, hypothesis.cost, hypothesis.raw, hypothesis.claims = other.fit, other.cost, other.raw, other.claims

    def _weighed(self, hypothesis, rows):
        hypothesis.raw = hypothesis.fit.evidence + self._wrong_friction(hypothesis.fit, rows)
        hypothesis.claims = len(hypothesis.mistakes) + len(set(negative(hypothesis.fit, self.statics)) - flipped(hypothesis.mistakes))
        hypothesis.cost = hypothesis.raw + hypothesis.fit.unlikely + MISTAKE * hypothesis.claims

    def with_far_zeros(self, hypothesis):
        """Begun anew from coarse zeros, as long as that explains more: a local minimum is left."""
        rows, of = undone(self.poses, hypothesis.mistakes), self.statics.unknowns.of
        for _ in range(FAR_ZEROS):
            if _left(hypothesis.fit, rows) < EXPLAINED:
                return
            x = hypothesis.fit.x

            def begun(suspect, x=x):
                zero = np.array(x[of("zero")])
                zero[list(suspect.joints)] += suspect.value
                return self.statics.linear_start(rows, zero, x[of("tilt")])

            coarse = suspects.zeros(self.statics.arm, lambda suspect: _evidence(begun(suspect)[1], rows))
            fits = [self.fitter.fit(rows, begun(each)[0], self.statics.free, 2 * TRIAL, weighted=False) for each in coarse]
            found = min(fits, key=lambda fit: fit.evidence)
            if found.evidence > hypothesis.fit.evidence - MISTAKE:  # nothing gained
                return
            hypothesis.fit = found
            self._weighed(hypothesis, rows)

    def _wrong_friction(self, fit, rows):
        """Dry friction pushes against the motion: a level below 0 tells of a sign."""
        of = self.statics.unknowns.of
        levels = fit.x[of("coulomb")] * np.sign(fit.x[of("scale")])
        spread = fit.sigma.max(axis=0) / np.sqrt(len(rows.mass))
        return float(sum(min((level / each) ** 2, WORST_FRICTION) for level, each in zip(levels, spread) if level < -SURE * each))

    def alike(self, best):
        """Other hypotheses that the rows explain as well and that claim no more mistakes than one beside the best one's."""
        found = [each for each in self.tried.values() if each is not best and each.raw < best.raw + ALIKE
                 and each.claims <= best.claims + 1 and each.cost < best.cost + MISTAKE + 2.0 * ALIKE]
        return sorted(found, key=lambda each: each.cost)


def _with(parent, suspect):
    """One mistake more; turning a position twice is not turning it."""
    if suspect in parent.mistakes:
        return Hypothesis(tuple(each for each in parent.mistakes if each != suspect))
    exchanged = [each for each in (*parent.mistakes, suspect) if "exchanged" in each.kind]
    return Hypothesis((*exchanged, *(each for each in (*parent.mistakes, suspect) if "exchanged" not in each.kind)))


def flipped(mistakes):
    return {joint for each in mistakes if each.kind == "position negated" for joint in each.joints}


def negative(fit, statics):
    return [int(j) for j in np.flatnonzero(fit.x[statics.unknowns.of("scale")] < 0.0)]


def _left(fit, rows):
    """Of any torque, beyond its noise."""
    return float(np.max(np.sqrt(np.maximum(0.0, np.mean(fit.residual ** 2, axis=0) - rows.noise(SURE) ** 2)) / rows.size))


def _evidence(residual, rows):
    variance = np.mean(residual ** 2, axis=0) + (EXACT_TRIAL * rows.size) ** 2
    return float(len(rows.mass) * np.sum(np.log(variance / rows.size ** 2)))


EXACT_TRIAL = 1e-3


def named(hypothesis, statics):
    """Its mistakes as suspects: a position and a torque that are both negated are an axis turned."""
    others = [each for each in hypothesis.mistakes if each.kind != "position negated"]
    positions, torques = flipped(hypothesis.mistakes), set(negative(hypothesis.fit, statics))
    kinds = itertools.chain((("axis turned", j) for j in positions & torques), (("position negated", j) for j in positions - torques),
                            (("torque negated", j) for j in torques - positions))
    return others + [suspects.Suspect(kind, (j,)) for kind, j in sorted(kinds, key=lambda each: each[1])]
