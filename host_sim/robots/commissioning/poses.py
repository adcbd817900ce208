"""Measured poses: a CSV of held positions and torques, read, checked, refused with line and remedy.

A header line, then comma separated numbers: mass (kg at the tool, 0: bare), side (+1 or -1: the sign of the motion that ended in the pose, of
every joint; or side1, side2, ... of each), q1... (rad or m, measured), tau1... (N m or N, what the drives report). Others are ignored.
"""

import csv
import dataclasses

import numpy as np

from engine import recording

PosesError = recording.RecordingError
LEAST_POSES = 6
SAME = 0.03  # rad, or m / 10: rows that are nearer are of one pose
MOST_ROWS = 20_000
TURNS = 7.0  # rad: what stands beyond, without limits, is in degrees
BEYOND = 0.1  # of a joint's range


@dataclasses.dataclass
class Poses:
    mass: np.ndarray  # a number per row
    side: np.ndarray  # rows x joints, as q and tau are
    q: np.ndarray
    tau: np.ndarray
    pose: np.ndarray  # index of the pose of each row
    notes: list

    def __len__(self):
        return len(self.mass)

    def count(self):
        return int(self.pose.max()) + 1


def read(path, arm):
    """Raises PosesError."""
    try:
        with open(path, encoding="utf-8-sig", newline="") as file:
            header = [name.strip() for name in next(csv.reader(file), [])]
            columns = _columns(header, len(arm))
            values = _numbers(file, header, {where for each in columns.values() for where in each})
    except OSError as error:
        raise PosesError(f"cannot be read: {error.strerror}") from error
    except (UnicodeDecodeError, csv.Error) as error:
        raise PosesError("is not text; give comma separated numbers below a header line") from error
    groups = {name: values[:, where] for name, where in columns.items()}
    _check_mass(groups["mass"][:, 0])
    _check_sides(groups["side"])
    _check_units(groups, arm)
    side = np.broadcast_to(groups["side"], groups["q"].shape)
    pose = _poses_of(groups["q"], arm)
    _check_poses(pose, groups, arm)
    notes = _notes(pose, side, groups["mass"][:, 0]) + _unmoved(groups, arm)
    return _held(Poses(groups["mass"][:, 0], np.array(side), groups["q"], groups["tau"], pose, notes))


def needed(joints):
    return f"needed: mass (kg), side (+1 or -1), q1..q{joints}, tau1..tau{joints}"


def _columns(header, joints):
    recording.check_separator(header)
    if header and all(recording.is_number(name) for name in header):
        raise PosesError("line 1: no header line; name the columns: mass,side,q1,...,tau1,...")
    for name in ("q", "tau"):
        if f"{name}{joints + 1}" in header:
            raise PosesError(f"has a column {name}{joints + 1}, but the robot has {joints} joints; give the robot that was measured")
    repeated = [name for name in header if name and header.count(name) > 1]
    if repeated:
        raise PosesError(f"line 1: the column {repeated[0]} stands twice")
    each_side = [f"side{i + 1}" for i in range(joints)]
    wanted = {"mass": ["mass"], "side": each_side if "side" not in header and "side1" in header else ["side"],
              **{name: [f"{name}{i + 1}" for i in range(joints)] for name in ("q", "tau")}}
    missing = [name for names in wanted.values() for name in names if name not in header]
    if missing:
        hint = "; mass is 0 in rows without a load" if "mass" in missing else ""
        raise PosesError(f"line 1: no column {', '.join(missing)}; {needed(joints)}; there are: {', '.join(header) or 'none'}{hint}")
    return {name: [header.index(each) for each in names] for name, names in wanted.items()}


def _numbers(file, header, used):
    """The rows; a cell of a column that nobody asks for may hold anything."""
    rows = []
    reader = csv.reader(file)
    for cells in reader:
        number = reader.line_num + 1
        if not any(cell.strip() for cell in cells):
            continue
        if len(cells) != len(header):
            raise PosesError(f"line {number}: {len(cells)} cells under {len(header)} names; is the file complete, are there commas inside numbers?")
        rows.append([_number(cell.strip(), number, header[k]) if k in used else 0.0 for k, cell in enumerate(cells)])
        if len(rows) > MOST_ROWS:
            raise PosesError(f"more than {MOST_ROWS} rows; give a row or a few per pose, side and mass")
    if not rows:
        raise PosesError("has no rows below its header line")
    return np.array(rows)


def _number(cell, line, name):
    if not cell:
        raise PosesError(f"line {line}: {name} is empty; fill it in or take the row out")
    try:
        value = float(cell)
    except ValueError as error:
        raise PosesError(f"line {line}: {name} is '{cell}', which is not a number") from error
    if not np.isfinite(value):
        raise PosesError(f"line {line}: {name} is {cell}; repair or take out the row that was not measured")
    return value


def _check_mass(mass):
    if np.any(mass < 0.0):
        raise PosesError(f"a mass is {mass.min():g} kg; masses at the tool are 0 or more")
    if not np.any(mass > 0.0):
        raise PosesError("no row has a mass: hold the poses once more with a known mass at the tool, and give it in the column mass, in kg")
    if not np.any(mass == 0.0):
        raise PosesError("every row has a mass: hold the poses once more without it, with 0 in the column mass")


def _check_sides(side):
    if np.any(np.abs(np.abs(side) - 1.0) > 1e-6):
        wrong = side[np.abs(np.abs(side) - 1.0) > 1e-6][0]
        raise PosesError(f"a side is {wrong:g}; it is +1 where the pose was approached with growing positions, -1 where with falling ones")
    for column in side.T:
        if np.all(column == column[0]):
            raise PosesError("every row is approached from one side; approach each pose from the other side, too, for friction changes its sign there")


def _check_units(groups, arm):
    """Positions that would be beyond any joint's limits: columns may be exchanged."""
    limits = [_limits(joint) for joint in arm.joints]
    furthest = max(max(abs(low), abs(high)) for low, high in limits)
    for j, (low, high) in enumerate(limits):
        q, wide = groups["q"][:, j], BEYOND * (high - low)
        if q.max() > high + wide or q.min() < low - wide:
            unit = "metres, and these look like millimetres" if arm.joints[j]["prismatic"] else "radians, and these look like degrees"
            if np.abs(q).max() > 2.0 * furthest:
                raise PosesError(f"q{j + 1} goes from {q.min():.4g} to {q.max():.4g}, the robot's limits are {low:.4g} and {high:.4g}; positions are in {unit}")


def _limits(joint):
    low, high = joint["position_min"], joint["position_max"]
    return (low, high) if None not in (low, high) else (-10.0, 10.0) if joint["prismatic"] else (-TURNS, TURNS)


def _poses_of(q, arm):
    """Of each row the index of its pose: the first one that is near."""
    scale = np.where(arm.prismatic, 0.1, 1.0) * SAME
    found, index = [], []
    for row in q:
        near = [k for k, other in enumerate(found) if np.all(np.abs(row - other) < scale)]
        if not near:
            found.append(row)
        index.append(near[0] if near else len(found) - 1)
    return np.array(index)


def _held(poses):
    """Rows of one hold (pose, mass, sides) as their mean."""
    _, index = np.unique(np.column_stack([poses.pose, poses.mass, poses.side]), axis=0, return_inverse=True)
    index = index.ravel()
    count = np.bincount(index).astype(float)
    mean = lambda values: np.stack([np.bincount(index, column) / count for column in values.T], axis=1)
    first = np.array([np.flatnonzero(index == k)[0] for k in range(len(count))])
    return Poses(poses.mass[first], poses.side[first], mean(poses.q), mean(poses.tau), poses.pose[first], poses.notes)


def _check_poses(pose, groups, arm):
    count = int(pose.max()) + 1
    if count < LEAST_POSES:
        raise PosesError(f"{count} different poses; at least {LEAST_POSES} are needed, and twelve are better: ./axial commission --suggest chooses them")
    rows, unknown = len(pose), 4 * len(arm) + 2
    if rows * len(arm) <= 2 * unknown:
        raise PosesError(f"{rows} rows for {unknown} unknowns; hold every pose from both sides, with and without the mass")
    tau = groups["tau"]
    if np.all(tau == 0.0):
        raise PosesError("every torque is 0; give what the drives report while they hold the arm")


def _notes(pose, side, mass):
    one_sided = [k + 1 for k in range(int(pose.max()) + 1) if np.all(side[pose == k, 0] == side[pose == k, 0][0])]
    unloaded = [k + 1 for k in range(int(pose.max()) + 1) if np.all((mass[pose == k] > 0.0) == (mass[pose == k][0] > 0.0))]
    notes = [f"approached from one side only: poses {_list(one_sided)}"] if one_sided else []
    return notes + ([f"held either bare or with the mass, not both: poses {_list(unloaded)}"] if unloaded else [])


def _unmoved(groups, arm):
    span = np.where(arm.prismatic, 0.1, 1.0) * SAME
    still = [j for j in range(len(arm)) if np.ptp(groups["q"][:, j]) < span[j]]
    return [f"{arm.noun} {j + 1} stands at one position in every pose: its zero and axis are hardly seen" for j in still]


def _list(numbers):
    return ", ".join(map(str, numbers[:8])) + (", ..." if len(numbers) > 8 else "")


def joined(tables):
    """Poses of several files, one after the other."""
    first, *others = tables
    for each in others:
        first = Poses(*(np.concatenate([getattr(first, name), getattr(each, name)]) for name in ("mass", "side", "q", "tau")),
                      np.concatenate([first.pose, each.pose + first.count()]), first.notes + each.notes)
    return first
