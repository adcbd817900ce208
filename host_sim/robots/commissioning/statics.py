"""What drives report in held poses, as a function of what is wrong with them, and its weighted least squares.

Row by row and joint by joint: reported = s (g(q - z; gravity) + mass) + o + c side. Per joint s: torque scale, o: torque offset, c: Coulomb
level, z: how much the drive's position is too large; of the whole arm t: two angles by which gravity is tilted.
"""

import dataclasses

import numpy as np
import scipy.optimize

STEP = 1e-6  # rad or m: of derivatives by position
ZERO, SLIDE, TILT, SCALE = 0.35, 0.1, 0.1, 0.7  # how far off is likely: rad, m, rad, of 1
EXACT = 1e-3  # of a joint's RMS torque: a smaller residual is taken for this much
SURE = 4.0  # standard deviations
VERTICAL = 0.1  # sine of the angle to gravity of a first axis that counts as vertical
ROUNDS = 2  # of weights
LEAST_SHARE = 0.05  # of the mean variance: no row counts as more exact
KINDS = ("zero", "scale", "offset", "coulomb")


def rotated(vector, axis):
    """Rodrigues: axis times angle."""
    angle = np.linalg.norm(axis)
    if angle == 0.0:
        return np.array(vector)
    k = axis / angle
    return vector * np.cos(angle) + np.cross(k, vector) * np.sin(angle) + k * (k @ vector) * (1.0 - np.cos(angle))


@dataclasses.dataclass(frozen=True)
class Unknowns:
    """Places in the vector: zeros, tilt, scales, offsets, Coulomb levels."""

    joints: int

    def __len__(self):
        return 4 * self.joints + 2

    def of(self, kind):
        n = self.joints
        first = {"zero": 0, "tilt": n, "scale": n + 2, "offset": 2 * n + 2, "coulomb": 3 * n + 2}[kind]
        return slice(first, first + (2 if kind == "tilt" else n))

    def kind(self, i):
        """Kind and joint (or number of the tilt) of a place."""
        for kind in ("zero", "tilt", "scale", "offset", "coulomb"):
            where = self.of(kind)
            if where.start <= i < where.stop:
                return kind, int(i) - where.start
        raise IndexError(i)

    def index(self, kind, joint):
        return self.of(kind).start + joint


class Statics:
    """The equations of an arm; everything else is given with the rows."""

    def __init__(self, arm):
        self.arm, self.unknowns = arm, Unknowns(len(arm))
        self.gravity = np.array(arm.gravity)
        self.tilts = self._tilt_axes()
        self.asymmetry = np.array([0.5 * (joint["coulomb_forward"] + joint["coulomb_backward"]) for joint in arm.joints])
        self.likely = self._likely()
        self.free = self._free()

    def _tilt_axes(self):
        """Two axes across gravity; the first one nearest to the first joint's axis, for a turn about that is what its zero is."""
        down = self.gravity / np.linalg.norm(self.gravity)
        first = np.array(self.arm.described["first_axis"])
        first = first - (first @ down) * down
        self.vertical = bool(np.linalg.norm(first) < VERTICAL)
        if self.vertical:
            first = np.eye(3)[np.argmin(np.abs(down))]
            first = first - (first @ down) * down
        first /= np.linalg.norm(first)
        return np.array([first, np.cross(down, first)])

    def _free(self):
        """All but one: a turn of the whole arm about its first axis is as well a tilt (or, where that axis is vertical, which way the table
        is tilted). The zero of a horizontal first axis is sought, that of a vertical one is not."""
        free = np.ones(len(self.unknowns), dtype=bool)
        if not self.arm.prismatic[0] and self.arm.joints[0].get("alone", True):
            free[self.unknowns.index("zero", 0) if self.vertical else self.unknowns.index("tilt", 0)] = False
        return free

    def _likely(self):
        n = len(self.arm)
        return np.concatenate([np.where(self.arm.prismatic, SLIDE, ZERO), [TILT] * 2, [SCALE] * n, [np.inf] * 2 * n])

    def fallen(self, tilt):
        """Gravity as the tilt has it."""
        return rotated(self.gravity, tilt @ self.tilts)

    def torque(self, parts, mass, gravity):
        """What holds the arm: rows x joints."""
        return parts[:, :, :3] @ gravity + mass[:, None] * (parts[:, :, 3:6] @ gravity) + parts[:, :, 6] + self.asymmetry

    def holding(self, data, x):
        of = self.unknowns.of
        return self.torque(self.arm.parts(data.q - x[of("zero")]), data.mass, self.fallen(x[of("tilt")]))

    def predicted(self, data, x):
        of = self.unknowns.of
        return x[of("scale")] * self.holding(data, x) + x[of("offset")] + x[of("coulomb")] * data.side

    def jacobian(self, data, x):
        """Rows x joints x unknowns."""
        of, n, rows = self.unknowns.of, len(self.arm), len(data.mass)
        q, gravity, scale = data.q - x[of("zero")], self.fallen(x[of("tilt")]), x[of("scale")]
        moved = np.concatenate([q, *(q + STEP * np.eye(n)[j] for j in range(n))])
        parts = self.arm.parts(moved).reshape(n + 1, rows, n, -1)
        held = self.torque(parts[0], data.mass, gravity)
        result = np.zeros((rows, n, len(self.unknowns)))
        for j in range(n):
            result[:, :, j] = -scale * (self.torque(parts[j + 1], data.mass, gravity) - held) / STEP
        weight = parts[0][:, :, :3] + data.mass[:, None, None] * parts[0][:, :, 3:6]
        for k in range(2):
            turned = x[of("tilt")] + STEP * np.eye(2)[k]
            result[:, :, n + k] = scale * (weight @ (self.fallen(turned) - gravity)) / STEP
        for j in range(n):
            for kind, value in (("scale", held[:, j]), ("offset", 1.0), ("coulomb", data.side[:, j])):
                result[:, j, self.unknowns.index(kind, j)] = value
        return result

    def linear_start(self, data, zero, tilt, held=None):
        """Scales, offsets, Coulomb levels that fit best, joint by joint; where gravity does not tell a scale's sign, friction does."""
        if held is None:
            held = self.torque(self.arm.parts(data.q - zero), data.mass, self.fallen(tilt))
        n = len(self.arm)
        x = np.concatenate([zero, tilt, np.ones(n), np.zeros(2 * n)])
        residual = np.zeros_like(data.tau)
        for j in range(n):
            columns = np.column_stack([held[:, j], np.ones(len(held)), data.side[:, j]])
            values, spread = _ridge(columns, data.tau[:, j], data.size[j])
            if abs(values[0]) < SURE * spread[0]:
                sign = -1.0 if values[2] < -SURE * spread[2] else 1.0
                rest, _ = _ridge(columns[:, 1:], data.tau[:, j] - sign * columns[:, 0], data.size[j])
                values = np.array([sign, *rest])
            for k, kind in enumerate(("scale", "offset", "coulomb")):
                x[self.unknowns.index(kind, j)] = values[k]
            residual[:, j] = data.tau[:, j] - columns @ values
        return x, residual


def _ridge(columns, tau, size):
    """Least squares that leaves a column of nothing at nothing; values and their standard deviations."""
    normal = columns.T @ columns + 1e-9 * size * size * np.eye(columns.shape[1])
    inverse = np.linalg.inv(normal)
    values = inverse @ (columns.T @ tau)
    rest = tau - columns @ values
    variance = max(rest @ rest / max(1, len(tau) - columns.shape[1]), (EXACT * size) ** 2)
    return values, np.sqrt(variance * np.diag(inverse))


@dataclasses.dataclass
class Rows:
    """What a fit takes: poses as they would be without a mistake of wiring."""

    mass: np.ndarray
    side: np.ndarray
    q: np.ndarray
    tau: np.ndarray
    pose: np.ndarray = None

    def __post_init__(self):
        size = np.sqrt(np.mean(self.tau ** 2, axis=0))
        self.size = np.where(size > 0.0, size, max(1e-9, size.max()))  # of each joint's torque

    def noise(self, sure=0.0):
        """Standard deviation of each drive's torque between holds of one pose from both sides, of which gravity is no part: half their
        difference is friction, the same in all poses, and noise. 0 where too few poses were held from both. sure: so many deviations of its
        own variance above it."""
        halves = []
        for pose, mass in sorted({*zip(self.pose, self.mass)}) if self.pose is not None else ():
            here = (self.pose == pose) & (self.mass == mass)
            up, down = here & (self.side[:, 0] > 0.0), here & (self.side[:, 0] < 0.0)
            if up.any() and down.any():
                halves.append(0.5 * (self.tau[up].mean(axis=0) - self.tau[down].mean(axis=0)))
        if len(halves) < 3:
            return np.zeros(self.tau.shape[1])
        return np.sqrt(2.0 + 2.0 * sure * np.sqrt(2.0 / (len(halves) - 1))) * np.std(halves, axis=0, ddof=1)

    def centred_size(self):
        """RMS of each joint's torque without its mean: what an offset does not explain."""
        return np.std(self.tau, axis=0)


@dataclasses.dataclass
class Fit:
    x: np.ndarray
    free: np.ndarray  # which of the unknowns were fitted
    residual: np.ndarray  # measured less predicted, rows x joints
    sigma: np.ndarray  # standard deviation of each equation
    information: np.ndarray  # of all unknowns, by the rows alone
    evidence: float  # -2 log likelihood, less is better
    unlikely: float  # what the sizes of the errors cost beside it


class Fitter:
    """Weighted least squares of the free unknowns; others stay where the start has them."""

    def __init__(self, statics):
        self.statics = statics

    def fit(self, data, start, free, most=30, weighted=True):
        sigma = np.broadcast_to(np.maximum(0.02 * data.size, data.noise()), data.tau.shape)
        x = start
        for _ in range(ROUNDS + 1 if weighted else 1):
            x = self._solve(data, x, free, sigma, most)
            residual = data.tau - self.statics.predicted(data, x)
            sigma = self._sigma(data, residual, free) if weighted else self._plain_sigma(data, residual, free)
        jacobian = self.statics.jacobian(data, x) / sigma[:, :, None]
        flat = jacobian.reshape(-1, len(x))
        evidence = 2.0 * np.log(sigma).sum() + float(np.sum((residual / sigma) ** 2)) if weighted else 2.0 * np.log(sigma / data.size).sum()
        return Fit(x, free, residual, np.array(sigma), flat.T @ flat, float(evidence), self._unlikely(x, start))

    def _unlikely(self, x, start):
        of, likely = self.statics.unknowns.of, self.statics.likely
        offs = [x[of(kind)] / likely[of(kind)] for kind in ("zero", "tilt")]
        scales = np.log(np.maximum(np.abs(x[of("scale")]), 1e-3)) / SCALE
        return float(sum(np.sum(each ** 2) for each in (*offs, scales)))

    def _solve(self, data, start, free, sigma, most):
        statics, likely = self.statics, self.statics.likely
        centre = np.zeros(len(start))
        centre[statics.unknowns.of("scale")] = np.sign(start[statics.unknowns.of("scale")])
        wide = np.ones(len(start))
        wide[statics.unknowns.of("scale")] = np.maximum(1.0, np.abs(start[statics.unknowns.of("scale")]))  # torques in other units
        likely = likely * wide
        held_to = np.flatnonzero(free & np.isfinite(likely))
        places = np.flatnonzero(free)

        def full(values):
            x = start.copy()
            x[places] = values
            return x

        def residuals(values):
            x = full(values)
            rows = (statics.predicted(data, x) - data.tau) / sigma
            return np.concatenate([rows.ravel(), (x - centre)[held_to] / likely[held_to]])

        def jacobian(values):
            rows = (statics.jacobian(data, full(values)) / sigma[:, :, None]).reshape(-1, len(start))
            prior = np.eye(len(start))[held_to] / likely[held_to][:, None]
            return np.concatenate([rows, prior])[:, places]

        scale = np.where(np.isfinite(likely), likely, np.concatenate([np.ones(2 * len(data.size) + 2), data.size, data.size]))
        found = scipy.optimize.least_squares(residuals, start[places], jac=jacobian, method="lm", x_scale=scale[places], max_nfev=most, xtol=1e-9, ftol=1e-9)
        return full(found.x)

    def _freedom(self, data, free):
        rows, n = data.tau.shape
        return max(1.0, rows - free.sum() / n)

    def _plain_sigma(self, data, residual, free):
        sigma = np.sqrt(np.sum(residual ** 2, axis=0) / self._freedom(data, free))
        return np.broadcast_to(np.maximum(sigma, EXACT * data.size), residual.shape)

    def _sigma(self, data, residual, free):
        """Of each joint by itself; within a joint by what all of them say of how noise grows with torque."""
        plain = self._plain_sigma(data, residual, free)
        squares, sizes = (residual / plain) ** 2, ((data.tau - residual) / data.size) ** 2  # as predicted: what noise made small is not exact
        columns = np.column_stack([np.ones(squares.size), sizes.ravel()])
        shares, _ = scipy.optimize.nnls(columns, squares.ravel())
        growth = (columns @ shares).reshape(squares.shape)
        growth = np.maximum(growth, LEAST_SHARE * growth.mean()) if growth.mean() > 0.0 else np.ones_like(growth)
        weighted = np.sqrt(np.sum(residual ** 2 / growth, axis=0) / self._freedom(data, free))
        return np.maximum(np.sqrt(growth) * weighted, EXACT * data.size)
