"""A robot as the library sees it: limits, standard parameters, and the regressor, from the program robot_regressor."""

import json
import subprocess
import sys

import numpy as np

CHUNK = 2000  # states a request


class RobotError(ValueError):
    """The program refused the robot; its own message."""


class Robot:
    """joints: dictionaries of limits (None where there is none); prior: standard parameters; names: "m1", "mx1", ..."""

    def __init__(self, program, robot, tip=""):
        self.command = [str(program), "--robot", str(robot), *(["--tip", tip] if tip else [])]
        described = json.loads(self._ask("describe"))
        self.name, self.joints = described["name"], described["joints"]
        self.kinds = described["parameters"] * len(self.joints)
        self.names = [f"{kind}{joint + 1}" for joint in range(len(self.joints)) for kind in described["parameters"]]
        self.prior = np.array([value for joint in self.joints for value in joint["parameters"]], dtype=float)
        self.service = subprocess.Popen([*self.command, "answer"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.service.stdin.close()
        self.service.wait()
        self.service.stdout.close()

    def __len__(self):
        return len(self.joints)

    def _ask(self, *arguments):
        done = subprocess.run([*self.command, *arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RobotError(done.stderr.strip().removeprefix("robot_regressor: "))
        sys.stderr.write(done.stderr)  # of a header: what was kept, and what was not
        return done.stdout

    def write_header(self, path, values):
        """values: a JSON file of name, source, parameters, notes, figures."""
        self._ask("header", "--values", str(values), "-o", str(path))

    def unit(self, joint):
        return "N" if self.joints[joint]["prismatic"] else "N m"

    def limits(self, name, missing):
        """One limit of every joint, `missing` (a number or one per joint) where the description has none."""
        missing = np.broadcast_to(missing, len(self))
        return np.array([other if joint[name] is None else joint[name] for joint, other in zip(self.joints, missing)])

    def regressor(self, q, qd, qdd, columns=None):
        """Y (states x joints x columns) and the torque beside Y theta (states x joints): springs, static friction."""
        columns = np.arange(len(self.names)) if columns is None else np.asarray(columns)
        parts = [self._evaluate(np.hstack([q[i:i + CHUNK], qd[i:i + CHUNK], qdd[i:i + CHUNK]])) for i in range(0, len(q), CHUNK)]
        return np.concatenate([part[:, :, columns] for part in parts]), np.concatenate([part[:, :, -1] for part in parts])

    def _evaluate(self, states):
        self.service.stdin.write(np.int64(len(states)).tobytes() + np.ascontiguousarray(states, dtype=float).tobytes())
        self.service.stdin.flush()
        shape = (len(states), len(self), len(self.names) + 1)
        answer = self.service.stdout.read(8 * int(np.prod(shape)))
        return np.frombuffer(answer).reshape(shape)
