"""Zero-phase smoothing and differentiation of a recording, and the same smoothing of its regressor.

A Butterworth low-pass of order 4, forward and backward (no phase; attenuation 1 / (1 + (f/cutoff)^8)), on q and on the measured qd;
derivatives by the central difference that is exact for polynomials of degree 8 (a Savitzky-Golay filter of nine points). Torque and every
column of the regressor pass the same low-pass ("parallel filtering", M. Gautier, IEEE ICRA 1997), so that friction's jumps and harmonics of
the motion are weakened alike on both sides; then rows are thinned to about twice the cut-off, where they are nearly independent.
"""

import dataclasses
import typing

import numpy as np
import scipy.signal
import scipy.special
import scipy.stats

ORDER = 4
DEFAULT_CUTOFF = 10.0  # Hz
SETTLING = 2.0  # cut-off periods that are dropped at either end
DIFFERENCES = 4  # of neighbours, in which noise is seen: smooth motion has next to none, friction's jumps are few
NOISY = 0.05  # of the largest RMS torque: more is no drive's noise, and no encoder's
SLOW = 0.01  # of a joint's greatest speed: below, friction's direction is not known and the joint's row is left out


@dataclasses.dataclass
class Motion:
    q: np.ndarray
    qd: np.ndarray
    qdd: np.ndarray


class Smoother:
    """cutoff: Hz; None: 10 Hz, or less where the rate is low; 0: no smoothing."""

    def __init__(self, rate, cutoff=None):
        if cutoff is None:
            cutoff = min(DEFAULT_CUTOFF, 0.1 * rate)
        if cutoff and not 0.0 < cutoff < 0.5 * rate:
            raise ValueError(f"--cutoff {cutoff:g}: between 0 and {0.5 * rate:g} Hz, half the log's rate")
        self.rate, self.cutoff = rate, cutoff
        self.sections = scipy.signal.butter(ORDER, cutoff, fs=rate, output="sos") if cutoff else None

    def low_pass(self, values):
        return values if self.sections is None else scipy.signal.sosfiltfilt(self.sections, values, axis=0)

    def derivative(self, values, order=1):
        return scipy.signal.savgol_filter(values, 9, 8, deriv=order, delta=1.0 / self.rate, axis=0)

    def motion(self, recording):
        q = self.low_pass(recording.q)
        if recording.qd is None:
            return Motion(q, self.derivative(q), self.derivative(q, 2))
        qd = self.low_pass(recording.qd)
        return Motion(q, qd, self.derivative(qd))

    def noise(self, tau):
        """Standard deviation, in the smoothed torques, of the noise that neighbouring torques differ by, by joint; white noise is taken for it."""
        raw = _rough(tau)
        passed = 1.0 if self.sections is None else np.mean(np.abs(scipy.signal.sosfreqz(self.sections)[1]) ** 4)  # there and back
        return np.sqrt(passed) * np.minimum(raw, NOISY * np.sqrt(np.mean(tau ** 2, axis=0)).max())

    def shaken(self, recording):
        """The recording with as much noise again on positions and speeds as they have: what neighbours differ by, a count's rounding at least."""
        random = np.random.default_rng(0)
        again = lambda values: values + np.maximum(_rough(values), _count(values) / np.sqrt(12.0)) * random.normal(size=values.shape)
        return dataclasses.replace(recording, q=again(recording.q), qd=None if recording.qd is None else again(recording.qd))

    def kept(self, rows):
        """Which rows stay after thinning."""
        edge = max(8, int(np.ceil(SETTLING * self.rate / self.cutoff)) if self.cutoff else 0)
        step = max(1, int(self.rate / (2 * self.cutoff))) if self.cutoff else 1
        return np.arange(edge, rows - edge, step)


def _rough(values):
    """Standard deviation of the white noise that neighbours differ by, by column."""
    rough = scipy.stats.median_abs_deviation(np.diff(values, DIFFERENCES, axis=0), axis=0, scale="normal")
    return rough / np.sqrt(scipy.special.comb(2 * DIFFERENCES, DIFFERENCES))


def _count(values):
    """What an encoder counts by: the smallest step between neighbours, by column; 0 where nothing moves."""
    steps = np.abs(np.diff(values, axis=0))
    least = np.min(np.where(steps > 0.0, steps, np.inf), axis=0)
    return np.where(np.isfinite(least), least, 0.0)


@dataclasses.dataclass
class Equations:
    """tau = regressor @ standard parameters; [instant, joint, ...] throughout; `valid` where a row counts."""

    time: np.ndarray
    regressor: np.ndarray
    tau: np.ndarray
    valid: np.ndarray
    noise: np.ndarray  # standard deviation of each joint's tau, as far as it is noise
    shaken: typing.Callable  # what the regressor of positions and speeds with as much noise again has more

    def noise_of_all(self, values):
        """`noise` with what the noise of positions and speeds, an encoder's counts among it, makes of the torques of parameters."""
        moved = np.where(self.valid, self.shaken() @ values, 0.0)
        rms = lambda each: np.sqrt(np.sum(np.where(self.valid, each, 0.0) ** 2, axis=0) / self.valid.sum(axis=0))
        return np.hypot(self.noise, np.minimum(rms(moved), NOISY * rms(self.tau).max()))

    def of_joint(self, joint):
        valid = self.valid[:, joint]
        return self.regressor[valid, joint], self.tau[valid, joint]


def equations(robot, recording, columns, known, cutoff=None):
    """The linear equations of a recording in the standard parameters `columns`; those in `known` are as the prior has them."""
    smoother = Smoother(1.0 / recording.step, cutoff)
    motion, kept = smoother.motion(recording), smoother.kept(len(recording.time))
    if len(kept) < 10:
        raise ValueError(f"the log is too short: of {len(recording.time)} rows {len(kept)} are left after smoothing; record longer")
    regressor, tau = _linear(robot, motion, recording.tau, columns, known)

    def shaken():
        return smoother.low_pass(_linear(robot, smoother.motion(smoother.shaken(recording)), recording.tau, columns, known)[0] - regressor)[kept]

    valid = np.abs(motion.qd) > SLOW * np.abs(motion.qd).max(axis=0)
    return Equations(recording.time[kept], smoother.low_pass(regressor)[kept], smoother.low_pass(tau)[kept], valid[kept],
                     smoother.noise(recording.tau), shaken), smoother


def _linear(robot, motion, tau, columns, known):
    regressor, torque = robot.regressor(motion.q, motion.qd, motion.qdd, np.concatenate([columns, known]))
    torque = torque + regressor[:, :, len(columns):] @ robot.prior[known]
    return np.ascontiguousarray(regressor[:, :, :len(columns)]), tau - torque
