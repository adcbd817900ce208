"""Standard parameters that matter can have, as near to the prior as the data allows.

A link's pseudo-inertia P = [[S, h], [h', m]], with the second moments S = tr(I)/2 1 - I about the origin, the first moment h = m c and the
mass m, is positive definite exactly where a body of positive density has these parameters (P. Wensing, S. Kim, J.-J. Slotine, IEEE RA-L
3(1), 2018). The distance from the prior P0 is the log-determinant divergence tr(P0^-1 P) - log det(P0^-1 P) - 4 (T. Lee, P. Wensing, F.
Park, IEEE T-RO 36(2), 2020): frame and units cancel, it is convex, and infinite where P is not positive definite, so that no other
constraint is needed. Parameters of drives, which are positive, have its scalar form x/x0 - log(x/x0) - 1. A deviation of the prior's own
size costs about as much as one standard deviation of the data: the prior decides what the data does not. The sum with the data's squares is
strictly convex; Newton's method with backtracking finds its one minimum, along the path of a growing weight of the data.
"""

import dataclasses

import numpy as np
import scipy.linalg

INERTIAL = 10
LEAST_MASS = 0.01  # of the heaviest link: of a prior link, as the prior's scale
LEAST_RADIUS = 0.05  # of the arm's radius of gyration: of a prior link about its centre of mass
LEAST_DRIVE = 0.01  # of what takes the joint's RMS torque alone: of a drive's parameter, where the prior has none
MOST_STEPS = 100
GROWTH = 10.0  # of the data's weight, from one minimum to the next
CONVERGED = 1e-12  # squared Newton decrement: a share of the sum of squares and divergences


class NotFound(ValueError):
    """Newton's method did not end: the data is far from everything that bodies can do."""


def pseudo_inertia(link):
    """Of m, mx, my, mz, Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the origin."""
    m, x, y, z, xx, yy, zz, xy, xz, yz = link
    inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    second = 0.5 * np.trace(inertia) * np.eye(3) - inertia
    first = np.array([[x], [y], [z]])
    return np.block([[second, first], [first.T, np.array([[m]])]])


UNITS = np.array([pseudo_inertia(unit) for unit in np.eye(INERTIAL)])  # P is linear in the parameters


def link_of(pseudo):
    """The inverse of pseudo_inertia."""
    inertia = np.trace(pseudo[:3, :3]) * np.eye(3) - pseudo[:3, :3]
    return np.array([pseudo[3, 3], *pseudo[:3, 3], inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1], inertia[0, 2], inertia[1, 2]])


def consistent_prior(links):
    """Pseudo-inertias of the links; what no matter has is made thick and heavy enough. Also which links were changed."""
    masses = np.array([link[0] for link in links])
    spread = sum(max(0.0, 0.5 * (link[4] + link[5] + link[6])) for link in links)
    radius2 = LEAST_RADIUS ** 2 * spread / max(masses.sum(), 1e-12) or 1e-6
    result, changed = [], []
    for i, link in enumerate(links):
        pseudo = pseudo_inertia(link)
        mass = max(masses[i], LEAST_MASS * masses.max(), 1e-6)
        com = pseudo[:3, 3] / masses[i] if masses[i] > 0.0 else np.zeros(3)
        size, axes = np.linalg.eigh(pseudo[:3, :3] - masses[i] * np.outer(com, com))
        if masses[i] <= 0.0 or size.min() < -1e-9 * np.abs(size).max():
            changed.append(i)
        central = axes @ np.diag(np.maximum(size, mass * radius2)) @ axes.T
        result.append(np.block([[central + mass * np.outer(com, com), mass * com[:, None]], [mass * com[None, :], np.array([[mass]])]]))
    return result, changed


@dataclasses.dataclass
class Consistent:
    standard: np.ndarray  # all standard parameters of the robot
    base: np.ndarray  # and their base parameters
    cost: float  # mean square deviation from the estimate, in its standard deviations
    changed_prior: list  # links whose prior was not consistent


def nearest(robot, free, base, fit, drive_scale):
    """free: indices of the standard parameters that are sought; drive_scale: of every standard parameter of a drive."""
    problem = _Problem(robot, free, base, fit, drive_scale)
    standard = robot.prior.copy()
    standard[free] = _minimised(problem)
    values = base.combinations @ standard[free]
    return Consistent(standard, values, float(np.mean((fit.information @ (values - fit.values)) ** 2)), problem.changed)


class _Problem:
    """The function to minimise, over the free standard parameters: half the data's squares, and a divergence a link and a drive."""

    def __init__(self, robot, free, base, fit, drive_scale):
        kind = np.arange(len(robot.names)) % (len(robot.names) // len(robot.links))
        self.inertial = np.flatnonzero(kind[free] < INERTIAL).reshape(len(robot.links), INERTIAL)
        self.drives = np.flatnonzero(kind[free] >= INERTIAL)
        self.matrix, self.target = fit.information @ base.combinations, fit.information @ fit.values
        self.pseudo, self.changed = consistent_prior(robot.prior[free][self.inertial])
        self.inverse = [np.linalg.inv(pseudo) for pseudo in self.pseudo]
        self.sign = np.array([-1.0 if robot.kinds[i] == "backward" else 1.0 for i in free[self.drives]])
        self.size = np.maximum(self.sign * robot.prior[free[self.drives]], LEAST_DRIVE * drive_scale[free[self.drives]])

    def start(self):
        x = np.zeros(self.matrix.shape[1])
        for where, pseudo in zip(self.inertial, self.pseudo):
            x[where] = link_of(pseudo)
        x[self.drives] = self.sign * self.size
        return x

    def value(self, x):
        """Infinite where a link is not positive definite or a drive's parameter not positive."""
        share = self.sign * x[self.drives] / self.size
        if np.any(share <= 0.0):
            return np.inf
        total = 0.5 * np.sum((self.matrix @ x - self.target) ** 2) + np.sum(share - np.log(share) - 1.0)
        for where, inverse in zip(self.inertial, self.inverse):
            pseudo = np.tensordot(x[where], UNITS, 1)
            try:
                root = np.linalg.cholesky(pseudo)
            except np.linalg.LinAlgError:
                return np.inf
            total += np.sum(inverse * pseudo) - 2.0 * np.sum(np.log(np.diag(root)))
        return total

    def step(self, x):
        """Newton's step and the slope along it. With roots B of the Hessians, B' B, and r such that B' r are the gradients, it is a problem
        of least squares, B step = -r, and has the root of the Hessian's condition."""
        roots, residuals = [self.matrix], [self.matrix @ x - self.target]
        for where, inverse in zip(self.inertial, self.inverse):
            lower = np.linalg.cholesky(np.tensordot(x[where], UNITS, 1))
            whitening = np.linalg.inv(lower)
            root = np.zeros((16, len(x)))
            root[:, where] = (whitening @ UNITS @ whitening.T).reshape(-1, 16).T
            roots.append(root)
            residuals.append((lower.T @ inverse @ lower - np.eye(4)).ravel())
        drives = np.zeros((len(self.drives), len(x)))
        drives[np.arange(len(self.drives)), self.drives] = 1.0 / x[self.drives]
        root = np.vstack([*roots, drives])
        residual = np.concatenate([*residuals, self.sign * x[self.drives] / self.size - 1.0])
        step = scipy.linalg.lstsq(root, -residual, lapack_driver="gelsy", cond=0.0)[0]
        return step, residual @ root @ step


def _minimised(problem):
    """The weight of the data grows to 1 from where it is about the divergences': an interior-point method's path."""
    x, matrix, target = problem.start(), problem.matrix, problem.target
    weight = min(1.0, 1.0 / np.sum((matrix @ x - target) ** 2))
    while True:
        problem.matrix, problem.target = np.sqrt(weight) * matrix, np.sqrt(weight) * target
        x = _newton(problem, x)
        if weight == 1.0:
            return x
        weight = min(1.0, GROWTH * weight)


def _newton(problem, x):
    value = problem.value(x)
    for _ in range(MOST_STEPS):
        step, slope = problem.step(x)
        length = 1.0
        while (following := problem.value(x + length * step)) > value + 0.1 * length * slope and length > 1e-12:
            length *= 0.5
        if -slope < CONVERGED * (1.0 + abs(value)) or length <= 1e-12:
            return x
        x, value = x + length * step, following
    raise NotFound(f"no physically consistent parameters were found in {MOST_STEPS} steps")
