"""Weighted least squares of the base parameters, with what the data says about each.

Each joint's rows are weighted by the inverse of its residual's standard deviation, found from the fit before; the covariance of the
estimate follows (M. Gautier, Ph. Poignet, Control Engineering Practice 9(12), 2001).
"""

import dataclasses

import numpy as np
import scipy.linalg
import scipy.stats

ROUNDS = 4
EXACT = 1e-6  # of a joint's RMS torque: a smaller residual is taken for this much
OUTLIER = 5.0  # standard deviations, robustly estimated
NOTICEABLE = 0.02  # of a joint's RMS torque: a smaller residual is no outlier, however exact the others are
POOR = 0.3  # relative standard deviation above which a parameter counts as not identified by this log


@dataclasses.dataclass
class Fit:
    values: np.ndarray
    deviations: np.ndarray  # standard deviations
    intervals: np.ndarray  # half the 95 % confidence interval
    information: np.ndarray  # R: R' R is the inverse covariance
    condition: float  # of the weighted regressor
    condition_scaled: float  # with columns scaled to one length
    joint_deviations: np.ndarray  # of each joint's residual
    rows: int
    outliers: list  # of each joint: how many, and the first one's time


def fit(equations):
    joints = equations.tau.shape[1]
    blocks = [equations.of_joint(joint) for joint in range(joints)]
    size = np.array([np.sqrt(np.mean(tau ** 2)) or 1.0 for _, tau in blocks])
    deviations = size.copy()
    for _ in range(ROUNDS):
        values, upper, condition = _solve(blocks, deviations)
        residuals = [tau - regressor @ values for regressor, tau in blocks]
        freedom = np.array([max(1.0, len(r) - upper.shape[0] / joints) for r in residuals])
        deviations = np.maximum(np.array([np.sqrt(r @ r) for r in residuals]) / np.sqrt(freedom), EXACT * size)
    rows = sum(len(tau) for _, tau in blocks)
    inverse = scipy.linalg.solve_triangular(upper, np.eye(len(values)))
    spread = np.linalg.norm(inverse, axis=1)
    reach = scipy.stats.t.ppf(0.975, max(1, rows - len(values)))
    scaled = np.linalg.cond(upper / np.linalg.norm(upper, axis=0))
    return Fit(values, spread, reach * spread, upper, condition, scaled, deviations, rows, _outliers(equations, residuals))


def _solve(blocks, deviations):
    regressor = np.concatenate([block / deviation for (block, _), deviation in zip(blocks, deviations)])
    tau = np.concatenate([tau / deviation for (_, tau), deviation in zip(blocks, deviations)])
    if len(tau) <= regressor.shape[1]:
        raise ValueError(f"{len(tau)} usable rows for {regressor.shape[1]} parameters; record longer or raise --cutoff")
    length = np.linalg.norm(regressor, axis=0)
    if np.any(length == 0.0) or np.linalg.matrix_rank(regressor / np.maximum(length, 1e-300)) < len(length):
        raise ValueError("the motion leaves parameters without any effect (the regressor is rank deficient); record one of ./axial excite")
    orthogonal, upper = scipy.linalg.qr(regressor / length, mode="economic")
    values = scipy.linalg.solve_triangular(upper, orthogonal.T @ tau) / length
    return values, upper * length, np.linalg.cond(upper * length)


def _outliers(equations, residuals):
    found = []
    for joint, residual in enumerate(residuals):
        least = NOTICEABLE * np.sqrt(np.mean(equations.of_joint(joint)[1] ** 2))
        far = np.abs(residual - np.median(residual)) > max(OUTLIER * scipy.stats.median_abs_deviation(residual, scale="normal"), least)
        times = equations.time[equations.valid[:, joint]][far]
        found.append((len(times), float(times[0]) if len(times) else None))
    return found
