"""What measured poses tell of each unknown: how sure each is, what is faulty, which pose would tell more."""

import dataclasses

import numpy as np

import design
import wiring
from statics import SURE, Fitter

# By kind: the standard deviation above which the poses do not tell an unknown; above which it counts as poorly told; the least error that is a fault.
UNTOLD = {"zero": np.radians(2.0), "slide": 0.02, "tilt": np.radians(2.0), "scale": 0.15, "offset": 0.3, "coulomb": np.inf}
# Of a scale a third of 2 %: one that a small tilt alone tells may well be off by two of its standard errors.
POOR = {"zero": np.radians(0.2), "slide": 2e-3, "tilt": np.radians(0.1), "scale": 0.007, "offset": 0.1, "coulomb": np.inf}
FAULT = {"zero": np.radians(0.5), "slide": 2e-3, "tilt": np.radians(0.3), "scale": 0.03, "offset": 0.05}
NOISY = 0.03  # of a drive's limit, or of the arm's largest torque: more is no drive's noise
TOGETHER = 0.8  # correlation of errors from which two unknowns are mixed up
APART = 3.0 * wiring.ALIKE  # of evidence against another hypothesis: less is no pose worth naming
TRIED = 60  # poses that are tried for it
HELPS = 0.6  # of a standard deviation: a pose that leaves no more is worth naming


@dataclasses.dataclass
class Untold:
    kind: str
    index: int
    partners: list  # kinds and indices of what it cannot be told from
    pose: np.ndarray  # that would tell, or None


class Verdict:
    """The whole of what is found. tell(text): a line of progress."""

    def __init__(self, statics, poses, tell=lambda text: None, seed=1):
        self.statics, self.poses, self.arm = statics, poses, statics.arm
        search = wiring.Search(statics, poses, tell)
        self.hypothesis = search.best()
        self.alike = search.alike(self.hypothesis)
        self.rows = wiring.undone(poses, self.hypothesis.mistakes)
        self.places = np.flatnonzero(statics.free)
        self._settle(np.array(self.hypothesis.fit.x), self.hypothesis.fit.free)
        untold = np.array([i for i in self.places if statics.unknowns.kind(i)[0] in ("zero", "scale") and self.doubt(self.deviation, i, UNTOLD) > 1.0], int)
        if len(untold) > 0:  # what the poses do not tell is as described, lest noise chooses it and all that it is mixed up with
            start, free = np.array(self.fit.x), self.fit.free.copy()
            of = statics.unknowns.of("scale")
            start[untold], free[untold] = np.where((untold >= of.start) & (untold < of.stop), np.sign(start[untold]), 0.0), False
            self._settle(start, free)
        self.designer = design.Designer(statics, float(np.median(poses.mass[poses.mass > 0.0])), seed, self.fit.x,
                                        np.sqrt(np.mean(self.fit.sigma ** 2, axis=0)), held=False)
        ratios = {i: (self.doubt(self.deviation, i, UNTOLD), self.doubt(self.deviation, i, POOR)) for i in self.places}
        self.told = np.array([i in ratios and ratios[i][0] <= 1.0 for i in range(len(self.fit.x))])
        self.untold = [self._explained(i) for i in self.places if ratios[i][0] > 1.0]
        self.poor = [self._explained(i) for i in self.places if ratios[i][0] <= 1.0 < ratios[i][1]]

    def _settle(self, start, free):
        """The fit from there, and how sure it is."""
        self.fit = Fitter(self.statics).fit(self.rows, start, free)
        self.covariance = self._covariance(self.fit.information)
        self.deviation = self._deviations()
        if not self._tilt_is_sure():  # what tells a scale by a tilt that may not be there tells nothing
            self.covariance = self._covariance(self._information_without_tilt())
            self.deviation = self._deviations()

    def _covariance(self, information):
        """What is likely counts as measured: far too little to matter where the poses tell."""
        return inverse(information[np.ix_(self.places, self.places)] + np.diag(self.weak(self.places)))

    def _deviations(self):
        result = np.zeros(len(self.fit.x))
        result[self.places] = np.sqrt(np.diag(self.covariance))
        return result

    def _tilt_is_sure(self):
        of = self.statics.unknowns.of("tilt")
        return bool(np.any(np.abs(self.fit.x[of]) > SURE * self.deviation[of]))

    def _information_without_tilt(self):
        x = np.array(self.fit.x)
        x[self.statics.unknowns.of("tilt")] = 0.0
        jacobian = (self.statics.jacobian(self.rows, x) / self.fit.sigma[:, :, None]).reshape(-1, len(x))
        return jacobian.T @ jacobian

    def weak(self, places):
        """Information that sizes of errors have before anything is measured."""
        n, size = len(self.arm), 10.0 * self.rows.size
        likely = np.where(np.isfinite(self.statics.likely), self.statics.likely, np.concatenate([np.ones(2 * n + 2), size, size]))
        return 1.0 / likely[places] ** 2

    def name(self, i):
        """Kind, with slides' zeros apart, and joint."""
        kind, joint = self.statics.unknowns.kind(i)
        return ("slide" if kind == "zero" and self.arm.prismatic[joint] else kind), joint

    def ratio(self, values, i, limits):
        """Of an unknown's value over its kind's limit; torques over the joint's own."""
        kind, joint = self.name(i)
        unit = self.rows.size[joint] if kind in ("offset", "coulomb") else 1.0
        return abs(values[i]) / (limits[kind] * unit)

    def doubt(self, values, i, limits):
        """That of a standard deviation; of a scale far above 1, which torques in other units have, over the scale."""
        size = max(1.0, abs(self.fit.x[i])) if self.name(i)[0] == "scale" else 1.0
        return self.ratio(values, i, limits) / size

    def _explained(self, i):
        kind, joint = self.statics.unknowns.kind(i)
        where = int(np.flatnonzero(self.places == i)[0])
        information = self.fit.information[np.ix_(self.places, self.places)]
        blocks = self.designer.blocks()[:, self.places][:, :, self.places]
        after = design.after_one_more(information + np.diag(self.weak(self.places)), blocks, where)
        best, values = int(np.argmin(after)), np.zeros(len(self.fit.x))
        values[i] = after[best]
        limits = POOR if self.told[i] else UNTOLD
        tells = self.doubt(values, i, limits) < 1.0 or after[best] < HELPS * self.deviation[i]
        return Untold(kind, joint, self._partners(where), self.designer.poses[best] if tells else None)

    def _partners(self, where):
        """What an unknown is mixed up with: errors that go together."""
        deviation = np.sqrt(np.diag(self.covariance))
        together = np.abs(self.covariance[where] / (deviation * deviation[where]))
        together[where] = 0.0
        return [self.statics.unknowns.kind(self.places[k]) for k in np.argsort(-together)[:2] if together[k] > TOGETHER]

    def pose_apart_from(self, other):
        """The pose that would speak most against another hypothesis if this one is right, all that the other has not settled free; None where no held
        pose does."""
        count, places = min(TRIED, len(self.designer.poses)), np.flatnonzero(other.fit.free)
        rows = self.designer.rows(self.designer.poses[:count])
        rows.tau = wiring.redone(self.statics.predicted(wiring.undone(rows, self.hypothesis.mistakes), self.fit.x), self.hypothesis.mistakes)
        rows, sigma = wiring.undone(rows, other.mistakes), np.sqrt(np.mean(other.fit.sigma ** 2, axis=0))
        by_pose = lambda values: np.moveaxis((values.reshape(4, count, len(self.arm), -1) / sigma[:, None]), 1, 0).reshape(count, 4 * len(self.arm), -1)
        apart = by_pose(rows.tau - self.statics.predicted(rows, other.fit.x))
        slope = by_pose(self.statics.jacobian(rows, other.fit.x)[:, :, places])
        settled = inverse(other.fit.information[np.ix_(places, places)] + np.diag(self.weak(places)))
        spread = np.eye(apart.shape[1]) + slope @ settled @ slope.swapaxes(1, 2)
        against = np.sum(apart * np.linalg.solve(spread, apart), axis=(1, 2))
        return self.designer.poses[np.argmax(against)] if against.max() > APART else None

    def value(self, kind, joint):
        """The unknown and its standard deviation; None where the poses do not tell it."""
        i = self.statics.unknowns.index(kind, joint)
        return (float(self.fit.x[i]), float(self.deviation[i])) if self.told[i] else None

    def friction(self, joint):
        """Coulomb level on the joint's side, and its standard deviation: what the drive reports over its scale, where that is told."""
        place = self.statics.unknowns.index("scale", joint)
        scale = abs(self.fit.x[place]) if self.told[place] else 1.0
        level, deviation = self.value("coulomb", joint)
        sign = np.sign(self.fit.x[place])
        return float(sign * level / scale), float(deviation / scale)

    def is_fault(self, kind, joint):
        """Beyond noise, and large enough to matter."""
        i, n = self.statics.unknowns.index(kind, joint), self.statics.unknowns.of("scale")
        if not self.told[i]:
            return False
        off = np.array(self.fit.x)
        off[n] = np.abs(off[n]) - 1.0
        return abs(off[i]) > SURE * self.deviation[i] and self.ratio(off, i, FAULT) > 1.0

    def mistakes(self):
        return wiring.named(self.hypothesis, self.statics)

    def residuals(self):
        """What is left of each joint's torque beyond its noise, over its RMS (or a twentieth of the joint's limit, where it has little to do)."""
        limits = self.arm.limits("effort", 0.0)
        noise = np.minimum(self.rows.noise(SURE), np.maximum(NOISY * limits, NOISY * self.rows.size.max()))
        return np.sqrt(np.maximum(0.0, np.mean(self.fit.residual ** 2, axis=0) - noise ** 2)) / np.maximum(self.rows.size, 0.05 * limits)

    def gravity(self):
        of = self.statics.unknowns.of("tilt")
        return self.statics.fallen(np.where(self.told[of], self.fit.x[of], 0.0))

    def tilt(self):
        """Angle of gravity to where the description has it, and its standard deviation; None where no tilt is told."""
        places = [self.statics.unknowns.index("tilt", k) for k in range(2) if self.told[self.statics.unknowns.index("tilt", k)]]
        if not places:
            return None
        angle = float(np.linalg.norm(self.fit.x[places]))
        deviation = self.deviation[places]
        if angle < 1e-12:
            return angle, float(deviation.max())
        return angle, float(np.linalg.norm(self.fit.x[places] / angle * deviation))

    def tilt_is_fault(self):
        found = self.tilt()
        return found is not None and found[0] > SURE * found[1] and found[0] > FAULT["tilt"]


def inverse(information):
    """Of a matrix whose rows differ by many orders."""
    scale = 1.0 / np.sqrt(np.maximum(np.diag(information), 1e-300))
    return scale[:, None] * np.linalg.pinv(information * np.outer(scale, scale), rcond=1e-13, hermitian=True) * scale
