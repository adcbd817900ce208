"""A robot as the library sees it, from programs: limits, standard parameters, the regressor."""

import contextlib
import json
import subprocess
import sys

import numpy as np

CHUNK = 2000  # states a request


class RobotError(ValueError):
    """The program refused the robot; its own message."""


class Service:
    """A program that describes a robot in JSON and answers requests about its states. joints: dictionaries of limits (None where there is none),
    of what has values: joints, or the drives that they share, as `noun` says."""

    def __init__(self, command):
        self.command = command
        self.described = json.loads(self.tell("describe"))
        self.name, self.joints = self.described["name"], self.described["joints"]
        self.noun = "drive" if self.described.get("shares_drives") else "joint"
        self.service = subprocess.Popen([*self.command, "answer"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE)  # little: what it refuses

    def __enter__(self):
        return self

    def __exit__(self, *_):
        with contextlib.suppress(BrokenPipeError):
            self.service.stdin.close()
        self.service.wait()
        self.service.stdout.close()
        self.service.stderr.close()

    def __len__(self):
        return len(self.joints)

    def tell(self, *arguments):
        """Runs the program with these arguments; what it prints. Raises RobotError."""
        done = subprocess.run([*self.command, *arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RobotError(done.stderr.strip().split(": ", 1)[-1])
        sys.stderr.write(done.stderr)  # of a header: what was kept, and what was not
        return done.stdout

    def ask(self, states, columns):
        """The answer of each state: states x joints x columns."""
        return np.concatenate([self._ask_some(states[i:i + CHUNK], columns) for i in range(0, len(states), CHUNK)])

    def _ask_some(self, states, columns):
        with contextlib.suppress(BrokenPipeError):  # it has ended, and says why
            self.service.stdin.write(np.int64(len(states)).tobytes() + np.ascontiguousarray(states, dtype=float).tobytes())
            self.service.stdin.flush()
        shape = (len(states), len(self), columns)
        answer = self.service.stdout.read(8 * int(np.prod(shape)))
        if len(answer) < 8 * int(np.prod(shape)):
            raise RobotError(self.service.stderr.read().decode().strip().split(": ", 1)[-1])
        return np.frombuffer(answer).reshape(shape)

    def unit(self, joint):
        return "N" if self.joints[joint]["prismatic"] else "N m"

    def limits(self, name, missing):
        """One limit of every joint, `missing` (a number or one per joint) where the description has none."""
        missing = np.broadcast_to(missing, len(self))
        return np.array([other if joint[name] is None else joint[name] for joint, other in zip(self.joints, missing)])


class Robot(Service):
    """prior: standard parameters of every link and its drive; names: "m1", "mx1", ... by links. links: dictionaries with the drive that a link
    owns (None: it has neither rotor nor friction), ratios and offset of q = ratios u + offset, limits."""

    def __init__(self, program, robot, tip=""):
        super().__init__([str(program), "--robot", str(robot), *(["--tip", tip] if tip else [])])
        self.links, kinds = self.described["links"], self.described["parameters"]
        self.kinds = kinds * len(self.links)
        self.names = [f"{kind}{link + 1}" for link in range(len(self.links)) for kind in kinds]
        self.prior = np.array([value for link in self.links for value in link["parameters"]], dtype=float)
        self.drives = [link["drive"] for link in self.links for _ in kinds]  # of each parameter's link
        self.ratios = np.array([link["ratios"] for link in self.links], dtype=float)
        self.offsets = np.array([link["offset"] for link in self.links], dtype=float)

    def write_header(self, path, values):
        """values: a JSON file of name, source, parameters, notes, rotors_fitted, fitted, figures."""
        self.tell("header", "--values", str(values), "-o", str(path))

    def regressor(self, q, qd, qdd, columns=None):
        """Y (states x joints x columns) and the torque beside Y theta (states x joints): springs, static friction."""
        columns = np.arange(len(self.names)) if columns is None else np.asarray(columns)
        rows = self.ask(np.hstack([q, qd, qdd]), len(self.names) + 1)
        return rows[:, :, columns], rows[:, :, -1]
