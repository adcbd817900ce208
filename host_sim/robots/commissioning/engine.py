"""The modules of host_sim/robots/identification that commissioning shares: suspects, the service, logs, how programs end."""

import pathlib
import sys

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "identification"))
import program  # noqa: E402
import recording  # noqa: E402
import robot as robots  # noqa: E402
import suspects  # noqa: E402

__all__ = ["program", "recording", "robots", "suspects", "Arm"]
PARTS = 7


class Arm(robots.Service):
    """A robot whose gravity is asked for, part by part (gravity.hpp)."""

    def __init__(self, program_path, robot, tip="", at=(0.0, 0.0, 0.0)):
        options = ["--robot", str(robot), *(["--tip", tip] if tip else []), "--at", " ".join(map(repr, at))]
        super().__init__([str(program_path), *options])
        self.gravity = self.described["gravity"]
        self.prismatic = [joint["prismatic"] for joint in self.joints]
        self.ratios = np.array([link["ratios"] for link in self.described["links"]], dtype=float)
        self.offsets = np.array([link["offset"] for link in self.described["links"]], dtype=float)

    def parts(self, q):
        """States x joints x PARTS: bare along x y z, the mass along x y z, springs."""
        return self.ask(q, PARTS)

    def within(self, q):
        """Of each row whether the joints that drives move stay inside their own limits."""
        limit = lambda name, missing: np.array([missing if link[name] is None else link[name] for link in self.described["links"]], dtype=float)
        stand = q @ self.ratios.T + self.offsets
        return np.all((stand >= limit("position_min", -np.inf)) & (stand <= limit("position_max", np.inf)), axis=1)

    def units(self):
        return [self.unit(joint) for joint in range(len(self))]

    def write_header(self, path, values):
        self.tell("header", "--values", str(values), "-o", str(path))
