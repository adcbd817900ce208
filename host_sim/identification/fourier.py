"""Finite Fourier series that start and end at rest, scaled into limits.

J. Swevers, C. Ganseman, D. B. Tukel, J. De Schutter, H. Van Brussel, "Optimal robot excitation and identification", IEEE Trans. Robotics and
Automation 13(5), 1997: a joint moves as q0 + sum_k a_k/(w k) sin(w k t) - b_k/(w k) cos(w k t). Speed and acceleration vanish at both ends of
the period where sum a_k = 0 and sum k b_k = 0, which settle the last harmonic's pair.
"""

import dataclasses

import numpy as np

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
    missing = [f"{name} of joint {i + 1}" for i, joint in enumerate(robot.joints)
               for name in ("position_min", "position_max", "speed", "acceleration") if joint[name] is None]
    half = np.array([0.25 if joint["prismatic"] else np.pi for joint in robot.joints])
    values = {"low": ("position_min", -half), "high": ("position_max", half), "speed": ("speed", 2.0), "acceleration": ("acceleration", 5.0),
              "effort": ("effort", np.inf)}
    return Limits(**{name: robot.limits(*each) for name, each in values.items()}), missing


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
        room = width - scale * (high - low)
        place = middle - 0.5 * width + room * _share(shape[:, -1])
        return scale * (q - low) + place, scale * qd, scale * qdd


def _share(x):
    """Any number to 0 ... 1, smoothly."""
    return 0.5 * (1.0 + np.tanh(x))
