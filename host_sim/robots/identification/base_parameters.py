"""Base parameters: the fewest combinations of standard parameters that torque depends on, found numerically.

M. Gautier, "Numerical calculation of the base inertial parameters of robots", J. Robotic Systems 8(4), 1991: a QR decomposition with
column pivoting of the regressor over random states; columns beyond its rank are combinations of the others.
"""

import dataclasses

import numpy as np
import scipy.linalg

RANK = 1e-9  # of a diagonal of R over the first one, all columns scaled to length 1: what is smaller is rounding
COEFFICIENT = 1e-9  # smaller ones are rounding
STATES = 200
SEED = 1991


@dataclasses.dataclass
class Base:
    """columns: the standard parameters that stand for the base; combinations: base = combinations @ standard."""

    columns: np.ndarray
    combinations: np.ndarray
    without_effect: np.ndarray  # columns that no torque depends on
    gap: tuple  # the last diagonal of R that counts, the first one that does not

    def __len__(self):
        return len(self.columns)


def random_states(robot, count=STATES, seed=SEED):
    """States inside the limits; where there is none, a turn, 2 rad/s (m/s) and 5 rad/s^2."""
    random = np.random.default_rng(seed)
    low, high = robot.limits("position_min", -np.pi), robot.limits("position_max", np.pi)
    symmetric = lambda name, missing: random.uniform(-1, 1, (count, len(robot))) * robot.limits(name, missing)
    return random.uniform(low, high, (count, len(robot))), symmetric("speed", 2.0), symmetric("acceleration", 5.0)


def base_of(robot, free):
    """Base of the standard parameters whose indices are given."""
    regressor, _ = robot.regressor(*random_states(robot), free)
    return reduced(regressor.reshape(-1, len(free)))


def reduced(regressor):
    """Base of a regressor's columns; indices are the columns'."""
    length = np.linalg.norm(regressor, axis=0)
    effective = np.flatnonzero(length > RANK * length.max())
    _, upper, order = scipy.linalg.qr(regressor[:, effective] / length[effective], mode="economic", pivoting=True)
    diagonal = np.abs(np.diag(upper))
    rank = int(np.sum(diagonal > RANK * diagonal[0]))
    columns, others = effective[order[:rank]], effective[order[rank:]]
    combinations = np.zeros((rank, regressor.shape[1]))
    combinations[np.arange(rank), columns] = 1.0
    dependent = scipy.linalg.solve_triangular(upper[:rank, :rank], upper[:rank, rank:])
    combinations[:, others] = dependent * length[others] / length[columns][:, None]
    combinations[np.abs(combinations) < COEFFICIENT] = 0.0
    sort = np.argsort(columns)
    without = np.setdiff1d(np.arange(regressor.shape[1]), effective)
    return Base(columns[sort], combinations[sort], without, (diagonal[rank - 1], diagonal[rank] if rank < len(diagonal) else 0.0))


def expression(row, names):
    """A row of combinations in words: "Izz1 + 0.25 m2"."""
    terms = []
    for i in np.argsort(np.abs(row) < 1 - 1e-9, kind="stable"):
        if row[i] != 0.0:
            size = "" if abs(abs(row[i]) - 1) < 1e-9 else f"{abs(row[i]):.6g} "
            terms.append(("- " if row[i] < 0 else "+ ") + size + names[i])
    return " ".join(terms).removeprefix("+ ")
