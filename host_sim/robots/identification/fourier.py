"""Finite Fourier series that start and end at rest, scaled into limits.

J. Swevers, C. Ganseman, D. B. Tukel, J. De Schutter, H. Van Brussel, "Optimal robot excitation and identification", IEEE Trans. Robotics and
Automation 13(5), 1997: a joint moves as q0 + sum_k a_k/(w k) sin(w k t) - b_k/(w k) cos(w k t). Speed and acceleration vanish at both ends of
the period where sum a_k = 0 and sum k b_k = 0, which settle the last harmonic's pair.
"""

import dataclasses

import numpy as np
import scipy.optimize

MARGIN = 0.9  # of every limit that is used
LEAST = 0.2  # of the largest amplitude that fits: what a joint moves at least


@dataclasses.dataclass
class Limits:
    """Arrays, a value per joint; rad or m, s, N m or N."""

    low: np.ndarray
    high: np.ndarray
    speed: np.ndarray
    acceleration: np.ndarray
    effort: np.ndarray  # infinite: none


def limits_of(robot):
    """Those of the description; a full turn or 0.5 m, 2 and 5 where it has none, and which those are, in words."""
    missing = [f"{name} of {robot.noun} {i + 1}" for i, joint in enumerate(robot.joints)
               for name in ("position_min", "position_max", "speed", "acceleration") if joint[name] is None]
    half = np.array([0.25 if joint["prismatic"] else np.pi for joint in robot.joints])
    values = {"low": ("position_min", -half), "high": ("position_max", half), "speed": ("speed", 2.0), "acceleration": ("acceleration", 5.0),
              "effort": ("effort", np.inf)}
    return Limits(**{name: robot.limits(*each) for name, each in values.items()}), missing


def series_of(robot, limits, duration, harmonics):
    """Of joints, or of the drives that they share."""
    if robot.noun == "joint":
        return Series(limits, duration, harmonics)
    return SharedSeries(limits, duration, harmonics, robot)


def joint_limits(robot):
    """Of the joints that drives share: a value per link, infinite where a link declares none."""
    names = {"low": ("position_min", -np.inf), "high": ("position_max", np.inf), "speed": ("speed", np.inf), "acceleration": ("acceleration", np.inf)}
    return {name: np.array([missing if link[key] is None else link[key] for link in robot.links]) for name, (key, missing) in names.items()}


def beyond_joints(robot, motion):
    """What a motion of drives does to the joints that share them beyond their own limits, in words."""
    if robot.noun == "joint":
        return []
    lim = joint_limits(robot)
    q, qd, qdd = motion[0] @ robot.ratios.T + robot.offsets, motion[1] @ robot.ratios.T, motion[2] @ robot.ratios.T
    left = {"positions": np.any((q < lim["low"]) | (q > lim["high"]), axis=0), "speed": np.any(np.abs(qd) > lim["speed"], axis=0),
            "acceleration": np.any(np.abs(qdd) > lim["acceleration"], axis=0)}
    return [f"{name} of joint {i + 1} beyond its limit" for name, each in left.items() for i in np.flatnonzero(each)]


class Series:
    """Motions of one period. A shape is a vector of any numbers: each gives a motion inside the limits of motion."""

    def __init__(self, limits, duration, harmonics):
        self.limits, self.duration, self.harmonics = limits, duration, harmonics
        self.joints = len(limits.low)
        self.size = 2 * harmonics  # of a joint: coefficients but the last pair's, amplitude, place

    def basis(self, time):
        """Position, speed and acceleration of each coefficient's own motion."""
        order = np.arange(1, self.harmonics + 1)
        w = 2 * np.pi * order / self.duration
        s, c = np.sin(np.outer(time, w)), np.cos(np.outer(time, w))
        position, speed, acceleration = np.hstack([s / w, -c / w]), np.hstack([c, s]), np.hstack([-s * w, c * w])
        return [each @ self._at_rest(order) for each in (position, speed, acceleration)]

    def _at_rest(self, order):
        n = self.harmonics
        free = np.eye(n)[:, :n - 1]
        a, b = free.copy(), free.copy()
        a[-1] = -1.0
        b[-1] = -order[:-1] / order[-1]
        return np.block([[a, np.zeros_like(a)], [np.zeros_like(b), b]])

    def motion(self, shape, basis):
        """q, qd, qdd at the basis's instants."""
        shape = np.reshape(shape, (self.joints, self.size))
        q, qd, qdd = (each @ shape[:, :-2].T for each in basis)
        low, high = q.min(axis=0), q.max(axis=0)
        lim = self.limits
        middle, width = 0.5 * (lim.low + lim.high), MARGIN * (lim.high - lim.low)
        most = np.min([width / (high - low), MARGIN * lim.speed / np.abs(qd).max(axis=0), MARGIN * lim.acceleration / np.abs(qdd).max(axis=0)], axis=0)
        scale = most * (LEAST + (1.0 - LEAST) * _share(shape[:, -2]))
        scale, room = self._within_joints(scale, q, qd, qdd, width)
        place = self._placed(middle - 0.5 * width + room * _share(shape[:, -1]), scale * (high - low))
        return scale * (q - low) + place, scale * qd, scale * qdd

    def _within_joints(self, scale, q, _qd, _qdd, width):
        """Amplitudes, and what room they leave."""
        return scale, width - scale * np.ptp(q, axis=0)

    def _placed(self, place, _range):
        """The lowest positions."""
        return place


class SharedSeries(Series):
    """Motions of drives that keep the limits of the joints too, q = G u + q0. Amplitudes shrink until what all drives of a joint add up to is
    within its limits wherever it swings about the middle; places lead away from the middle as far as every joint allows."""

    def __init__(self, limits, duration, harmonics, robot):
        super().__init__(limits, duration, harmonics)
        joints = joint_limits(robot)
        bounded = np.any(robot.ratios != 0.0, axis=1)
        self.ratios, self.offsets = robot.ratios[bounded], robot.offsets[bounded]
        self.joint = {name: each[bounded] for name, each in joints.items()}
        self.centre = self._middle()
        at = self.ratios @ self.centre + self.offsets
        self.slack = MARGIN * np.minimum(at - self.joint["low"], self.joint["high"] - at)

    def _middle(self):
        """Positions of the drives farthest from all limits, in shares of each limit's width."""
        lim, drives = self.limits, self.joints
        above, right = [], []
        for matrix, offset, low, high in ((np.eye(drives), np.zeros(drives), lim.low, lim.high), (self.ratios, self.offsets, self.joint["low"], self.joint["high"])):
            for row, own, least, most in zip(matrix, offset, low, high):
                width = most - least if np.isfinite(most - least) else 1.0
                if np.isfinite(most):
                    above.append([*row, width])
                    right.append(most - own)
                if np.isfinite(least):
                    above.append([*-row, width])
                    right.append(own - least)
        found = scipy.optimize.linprog([*np.zeros(drives), -1.0], A_ub=above, b_ub=right, bounds=[(None, None)] * drives + [(0.0, 0.5)])
        if found.x is None or found.x[-1] <= 0.0:
            raise ValueError("limits of drives and joints leave no position between them; see position_limits and drive_limits of the description")
        return found.x[:-1]

    def _within_joints(self, scale, q, qd, qdd, width):
        lim, size = self.limits, np.abs(self.ratios)
        room = 2.0 * MARGIN * np.minimum(self.centre - lim.low, lim.high - self.centre)  # about the middle
        scale = np.minimum(scale, room / np.ptp(q, axis=0))
        used = np.max([0.5 * size @ (scale * np.ptp(q, axis=0)) / self.slack, size @ (scale * np.abs(qd).max(axis=0)) / (MARGIN * self.joint["speed"]),
                       size @ (scale * np.abs(qdd).max(axis=0)) / (MARGIN * self.joint["acceleration"])], axis=0)
        over = np.maximum(used, 1.0)
        scale = scale / np.where(size > 0.0, over[:, None], 1.0).max(axis=0)
        return scale, width - scale * np.ptp(q, axis=0)

    def _placed(self, place, span):
        """From the middle towards where they were to be, until the first joint is at its limit."""
        way = place + 0.5 * span - self.centre
        moves, half = self.ratios @ way, 0.5 * np.abs(self.ratios) @ span
        at = self.ratios @ self.centre + self.offsets
        left = np.where(moves > 0.0, self.joint["high"] - at - half, at - half - self.joint["low"])
        share = min(1.0, *(MARGIN * left / np.maximum(np.abs(moves), 1e-12)))
        return self.centre + share * way - 0.5 * span


def _share(x):
    """Any number to 0 ... 1, smoothly."""
    return 0.5 * (1.0 + np.tanh(x))
