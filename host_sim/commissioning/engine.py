"""The modules of host_sim/identification that commissioning shares: suspects, the service, logs, how programs end."""

import pathlib
import sys

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

    def parts(self, q):
        """States x joints x PARTS: bare along x y z, the mass along x y z, springs."""
        return self.ask(q, PARTS)

    def units(self):
        return [self.unit(joint) for joint in range(len(self))]

    def write_header(self, path, values):
        self.tell("header", "--values", str(values), "-o", str(path))
