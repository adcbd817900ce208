"""Poses that tell most: the determinant of the information of a set of them, held from both sides, bare and with the mass (D-optimal)."""

import numpy as np

from statics import Rows

CANDIDATES = 400
MARGIN = 0.03  # of a joint's range: poses stay this far inside
TURN, SLIDE = 2.8, 0.25  # rad, m: of joints without limits
EFFORT = 0.9  # of a drive's limit: heavier poses are none
NOISE = 0.02  # of each joint's RMS torque over the candidates
UNLOADED = 1e-2  # of the largest torque: joints that bear less have this much noise
SWEEPS = 3


class Designer:
    """Candidate poses of an arm that its drives can hold, and what each of them tells."""

    def __init__(self, statics, mass, seed=1, x=None, noise=None, held=True):
        """x, noise: unknowns as they were found, and standard deviations of torques; without them as described, and NOISE. held: only poses
        that the drives hold; without, poses are none to go to before somebody has thought about it."""
        self.statics, self.mass, self.seed, self.x, self.noise = statics, mass, seed, x, noise
        self.free = np.flatnonzero(statics.free)
        self.poses = self._candidates(held)
        self._blocks = None

    def _candidates(self, only_held):
        arm, random = self.statics.arm, np.random.default_rng(self.seed)
        slides = np.array(arm.prismatic)
        low = arm.limits("position_min", np.where(slides, -SLIDE, -TURN))
        high = arm.limits("position_max", np.where(slides, SLIDE, TURN))
        q = random.uniform(low + MARGIN * (high - low), high - MARGIN * (high - low), (4 * CANDIDATES, len(arm)))
        q = q[arm.within(q)]
        torque = self.statics.torque(arm.parts(q), np.full(len(q), self.mass), self.statics.gravity)
        if not only_held:
            return np.round(q[:CANDIDATES], 4)
        held = q[np.all(np.abs(torque) <= EFFORT * arm.limits("effort", np.inf), axis=1)]
        if len(held) == 0:
            raise ValueError(f"the drives cannot hold {self.mass:g} kg in any pose inside the limits; take a smaller mass")
        return np.round(held[:CANDIDATES], 4)

    def rows(self, poses):
        """Each pose from both sides, bare and with the mass."""
        n, each = poses.shape[1], len(poses)
        mass, side = np.repeat([0.0, 0.0, self.mass, self.mass], each), np.repeat([1.0, -1.0, 1.0, -1.0], each)
        return Rows(mass, np.repeat(side[:, None], n, axis=1), np.tile(poses, (4, 1)), np.ones((4 * each, n)))

    def blocks(self):
        """The information of each candidate."""
        if self._blocks is None:
            rows, n = self.rows(self.poses), len(self.statics.arm)
            x = self.x if self.x is not None else self._described()
            size = np.sqrt(np.mean(self.statics.holding(rows, x) ** 2, axis=0))
            self.size = np.maximum(size, UNLOADED * size.max())
            noise = NOISE * self.size if self.noise is None else self.noise
            jacobian = (self.statics.jacobian(rows, x) / noise[:, None]).reshape(4, len(self.poses), n, -1)
            self._blocks = np.einsum("apni,apnj->pij", jacobian, jacobian)
        return self._blocks

    def _described(self):
        x = np.zeros(len(self.statics.unknowns))
        x[self.statics.unknowns.of("scale")] = 1.0
        return x

    def chosen(self, count):
        """Indices of so many candidates: one after the other D-optimally, then exchanged for those that leave zeros, scales and the tilt with the
        least product of their own variances."""
        blocks, weak = self.blocks(), np.diag(1.0 / self._loose() ** 2)
        found, total = [], weak.copy()
        for _ in range(count):
            gains = self._gains(total, blocks, found)
            found.append(int(np.argmax(gains)))
            total = total + blocks[found[-1]]
        for _ in range(SWEEPS):
            before = list(found)
            for k in range(count):
                without = total - blocks[found[k]]
                gains = self._own_gains(without, blocks)
                gains[found[:k] + found[k + 1:]] = -np.inf
                if gains.max() > gains[found[k]]:
                    found[k] = int(np.argmax(gains))
                total = without + blocks[found[k]]
            if before == found:
                break
        return found

    def _loose(self):
        likely, n = self.statics.likely, len(self.statics.arm)
        return np.where(np.isfinite(likely), likely, np.concatenate([np.ones(2 * n + 2), self.size, self.size]))

    @staticmethod
    def _gains(total, blocks, taken):
        gains = np.linalg.slogdet(total + blocks)[1]
        gains[taken] = -np.inf
        return gains

    def _own_gains(self, total, blocks):
        """Of zeros, scales and tilt alone, whatever else is unknown with them."""
        scale = self._loose()
        scaled = ((total + blocks) * np.outer(scale, scale))[:, self.free][:, :, self.free]
        wanted = np.flatnonzero(self.free < 2 * len(self.statics.arm) + 2)
        return -np.log(np.linalg.inv(scaled)[:, wanted, wanted]).sum(axis=1)

    def deviations(self, chosen):
        """Standard deviations to expect of the unknowns, and the condition number of what is told, columns of one length."""
        information = (self.blocks()[chosen].sum(axis=0) + np.diag(1.0 / self._loose() ** 2))[np.ix_(self.free, self.free)]
        scale = 1.0 / np.sqrt(np.diag(information))
        scaled = information * np.outer(scale, scale)
        values, deviations = np.linalg.eigvalsh(scaled), np.zeros(len(self.statics.unknowns))
        deviations[self.free] = scale * np.sqrt(np.diag(np.linalg.inv(scaled)))
        return deviations, float(np.sqrt(values[-1] / values[0]))


def after_one_more(information, blocks, where):
    """The standard deviation of one unknown once each of some poses is held as well."""
    scale = 1.0 / np.sqrt(np.diag(information))
    scaled = (information + blocks) * np.outer(scale, scale)
    return scale[where] * np.sqrt(np.linalg.inv(scaled)[:, where, where])
