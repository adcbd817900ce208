"""A log of recorded motion: read, checked, made even in time.

A header line, then comma separated numbers: time (s), q1... (rad or m), tau1... (N m or N, what the drives exert), and, where they were
measured, qd1... (rad/s or m/s). Columns are found by name, in any order; others are ignored. Joints count from 1. Where joints share drives
all columns are the drives', in the order of the links that own them.
"""

import csv
import dataclasses

import numpy as np
import scipy.interpolate

MOST_ROWS = 400_000
LEAST_ROWS = 100
SLOPE, ALIKE = 0.1, 0.5  # a speed's factor is one of the known ones; squared correlation with the derivative
FAR = 2.0  # of a joint's limit: positions beyond are in another unit
EVEN = 1e-6  # of the mean step: what deviates less is the same step


class RecordingError(ValueError):
    """What is wrong with a log, where, and what to do."""


@dataclasses.dataclass
class Recording:
    time: np.ndarray  # even steps
    q: np.ndarray  # a row per instant, a column per joint; so are the others
    qd: np.ndarray | None
    tau: np.ndarray
    notes: list

    @property
    def step(self):
        return (self.time[-1] - self.time[0]) / (len(self.time) - 1)


def read(path, robot, torque_scale=1.0):
    """Torques are divided by torque_scale. Raises RecordingError."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            header = [name.strip() for name in next(csv.reader(file), [])]
            columns = _columns(header, robot)
            values = _numbers(file, header)
    except OSError as error:
        raise RecordingError(f"cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise RecordingError("is not text; give comma separated numbers below a header line") from error
    _check_time(values[:, columns["time"][0]])
    groups = {name: values[:, where] for name, where in columns.items()}
    groups["tau"] = groups["tau"] / torque_scale
    notes = _doubts(groups, robot)
    return _even(groups, notes)


def _columns(header, robot):
    """Where time, q, qd (perhaps) and tau stand."""
    joints = len(robot)
    check_separator(header)
    wanted = {"time": ["time"], **{name: [f"{name}{i + 1}" for i in range(joints)] for name in ("q", "qd", "tau")}}
    if header and all(is_number(name) for name in header):
        raise RecordingError("line 1: no header line; name the columns: time,q1,...,tau1,...")
    for name in ("q", "tau"):
        if f"{name}{joints + 1}" in header:
            raise RecordingError(f"has a column {name}{joints + 1}, but the robot has {joints} {robot.noun}s; give the robot that was recorded")
    if not any(name in header for name in wanted["qd"]):
        del wanted["qd"]
    missing = [name for names in wanted.values() for name in names if name not in header]
    if missing:
        raise RecordingError(f"line 1: no column {', '.join(missing)}; needed: time, q1..q{joints}, tau1..tau{joints} and, all or none, "
                             f"qd1..qd{joints}; there are: {', '.join(header) or 'none'}")
    return {name: [header.index(each) for each in names] for name, names in wanted.items()}


def check_separator(header):
    """Names that stand in one cell are separated by something else."""
    if len(header) > 2:
        return
    text = " ".join(header)
    for mark, name in ((";", "semicolons"), ("\t", "tabs"), ("|", "bars"), (" ", "blanks")):
        names = [each for each in text.split(mark) if each]
        if len(names) > 2 and any(each.strip() in ("time", "q1", "tau1") for each in names):
            raise RecordingError(f"line 1: the columns are separated by {name}; needed: commas between them, points in the numbers")


def is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def _numbers(file, header):
    rows = []
    for number, cells in enumerate(csv.reader(file), start=2):
        if not cells:
            continue
        if len(cells) != len(header):
            raise RecordingError(f"line {number}: {len(cells)} cells under {len(header)} names; is the file complete?")
        try:
            rows.append([float(cell) for cell in cells])
        except ValueError as error:
            raise RecordingError(f"line {number}: {str(error).rsplit(': ', maxsplit=1)[-1]} is not a number") from error
        if not np.all(np.isfinite(rows[-1])):
            bad = int(np.flatnonzero(~np.isfinite(rows[-1]))[0])
            raise RecordingError(f"line {number}: {header[bad]} is {cells[bad].strip()}; remove or repair what was not measured")
        if len(rows) > MOST_ROWS:
            raise RecordingError(f"more than {MOST_ROWS} rows; cut the log: some periods of an excitation suffice")
    if len(rows) < LEAST_ROWS:
        raise RecordingError(f"{len(rows)} rows; at least {LEAST_ROWS} are needed, some seconds of motion at 100 Hz or more")
    return np.array(rows)


def _check_time(time):
    back = np.flatnonzero(np.diff(time) <= 0.0)
    if len(back):
        row = int(back[0]) + 1
        raise RecordingError(f"row {row + 1} of the numbers: time {time[row]:g} s comes after {time[row - 1]:g} s; time must grow row by row")
    steps = np.diff(time)
    widest = int(np.argmax(steps))
    if steps[widest] > 10 * np.median(steps):
        raise RecordingError(f"a gap of {steps[widest]:g} s at {time[widest]:g} s, where rows are {np.median(steps):g} s apart; cut the log there")


def _doubts(groups, robot):
    """Raises where units cannot be right; returns what is only doubtful."""
    time, notes = groups["time"][:, 0], []
    if np.median(np.diff(time)) >= 1.0:
        raise RecordingError(f"rows are {np.median(np.diff(time)):g} s apart; time is in seconds: are these milliseconds?")
    _check_speeds(groups)
    for joint in range(len(robot)):
        q, tau = groups["q"][:, joint], groups["tau"][:, joint]
        if np.ptp(q) == 0.0:
            raise RecordingError(f"{robot.noun} {joint + 1} never moves; every {robot.noun} must, see ./axial excite")
        low, high = (robot.joints[joint][name] for name in ("position_min", "position_max"))
        wide = 0.1 * (high - low) if low is not None and high is not None else np.inf
        if q.max() > (high if high is not None else 7.0) + wide or q.min() < (low if low is not None else -7.0) - wide:
            hint = "millimetres" if robot.joints[joint]["prismatic"] else "degrees"
            text = f"{robot.noun} {joint + 1} goes from {q.min():.4g} to {q.max():.4g}, outside the robot's limits; are these {hint}?"
            if np.abs(q).max() > FAR * max(abs(3.5 if each is None else each) for each in (low, high)):
                raise RecordingError(text + " Positions are in rad or m")
            notes.append(text)
        effort = robot.joints[joint]["effort"]
        if effort is not None and np.abs(tau).max() > 2 * effort:
            notes.append(f"tau{joint + 1} reaches {np.abs(tau).max():.4g} {robot.unit(joint)}, twice the robot's limit and more; on the {robot.noun}'s side?")
    return notes


def _check_speeds(groups):
    """Raises where measured speeds are not the derivatives of positions but so many times as much."""
    if "qd" not in groups:
        return
    derivative = np.gradient(groups["q"], groups["time"][:, 0], axis=0)
    wrong = ((180.0 / np.pi, "q is in degrees; positions are in rad"), (np.pi / 180.0, "qd is in degrees per second; speeds are in rad/s"),
             (-1.0, "one of them is negated"), (1e-3, "qd is in millimetres per second; speeds are in m/s"), (1e3, "q is in millimetres; positions are in m"))
    for joint, (slope, fits) in enumerate(_slopes(groups["qd"], derivative)):
        for factor, text in wrong:
            if fits and abs(slope / factor - 1.0) < SLOPE:
                raise RecordingError(f"q{joint + 1} changes {slope:.4g} times as fast as qd{joint + 1} says: {text}")


def _slopes(qd, derivative):
    """Of the derivative over the speed, and whether one is a multiple of the other, for every joint."""
    for speed, other in zip(qd.T, derivative.T):
        product, squares = speed @ other, (speed @ speed, other @ other)
        yield (product / squares[0], product ** 2 > ALIKE * squares[0] * squares[1]) if min(squares) > 0.0 else (1.0, False)


def _even(groups, notes):
    time = groups["time"][:, 0]
    even = np.linspace(time[0], time[-1], len(time))
    names = [name for name in ("q", "qd", "tau") if name in groups]
    jitter = np.abs(time - even).max() / (even[1] - even[0])
    if jitter > EVEN:
        notes = [*notes, f"time steps are uneven (up to {jitter:.2g} of a step off): interpolated by cubic splines"]
        groups = {name: scipy.interpolate.CubicSpline(time, groups[name])(even) for name in names}
    return Recording(even, groups["q"], groups.get("qd"), groups["tau"], notes)
