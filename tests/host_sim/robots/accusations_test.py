"""Commissioning accuses on evidence: logs of arms without a fault, and with one, of which poses tell or do not tell it.

usage: accusations_test.py --host BUILD_FOLDER [unittest arguments]
"""

import argparse
import contextlib
import csv
import io
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "host_sim/robots" / each) for each in ("verdicts", "commissioning")]
import accusations  # noqa: E402
import commission  # noqa: E402
import drawn_logs  # noqa: E402
from engine import Arm, suspects  # noqa: E402
import judged_logs  # noqa: E402
import poses as files  # noqa: E402
from statics import Statics  # noqa: E402
import wiring  # noqa: E402

HOST = None
Z1, INNOCENT = ROOT / "tests/data/descriptions/z1.json", ROOT / "tests/data/commissioning/innocent.csv"
THREE, WITHIN = np.radians(3.0), np.radians(0.2)
SAMPLE = ("wall", "idle_joints")


def program():
    return HOST / "host_sim/robots/commissioning/gravity_parts"


def logs(name, folder, seed=1):
    return accusations.Logs(program(), folder, drawn_logs.ARMS.index(name), seed)


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class InnocentZ1(InFolder):
    """A log of a Unitree Z1 with nothing but dry friction and noise, which was once said to have two columns exchanged."""

    def changed(self, change):
        """The log with every row changed."""
        path = self.folder / "log.csv"
        with open(INNOCENT, encoding="utf-8", newline="") as old, open(path, "w", encoding="utf-8", newline="") as new:
            rows = list(csv.DictReader(old))
            writer = csv.DictWriter(new, rows[0].keys())
            writer.writeheader()
            writer.writerows({**row, **change(row)} for row in rows)
        return path

    def judged(self, path):
        with Arm(program(), Z1) as arm:
            return accusations.judged(arm, path)

    def test_has_nothing_wrong(self):
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out), unittest.mock.patch.object(commission, "draw"):
            status = commission.main([str(Z1), str(INNOCENT), "--program", str(program()), "--output", str(self.folder)])
        self.assertEqual(status, 0, out.getvalue())
        self.assertEqual(out.getvalue().count(": nothing wrong"), 6)

    def test_is_told_which_columns_its_poses_cannot_tell_and_what_would(self):
        notes = [each for each in self.judged(INNOCENT)["notes"] if "columns tau1 and tau6 look exchanged" in each]
        self.assertEqual(len(notes), 1)
        self.assertIn("these poses cannot tell", notes[0])
        self.assertIn("no held pose tells: push each with a known force, or record a motion", notes[0])

    def test_with_a_zero_of_three_degrees_has_that_and_nothing_else(self):
        path = self.changed(lambda row: {"q3": float(row["q3"]) + THREE})
        row = self.judged(path)
        self.assertEqual((row["claims"], row["ways"], row["unexplained"]), ([("zero", (2,))], [], ""))
        with Arm(program(), Z1) as arm:
            found = accusations.Verdict(Statics(arm), files.read(path, arm))
        self.assertAlmostEqual(found.value("zero", 2)[0], THREE, delta=WITHIN)

    def test_with_exchanged_columns_that_gravity_tells_apart_has_those(self):
        row = self.judged(self.changed(lambda row: {"tau3": row["tau5"], "tau5": row["tau3"]}))
        self.assertEqual((row["claims"], row["ways"]), ([("torques exchanged", (2, 4))], []))

    def test_would_be_accused_without_a_price(self):
        with unittest.mock.patch.object(wiring, "MISTAKE", -5.0), unittest.mock.patch.object(wiring, "ALIKE", 0.0):
            self.assertNotEqual(self.judged(INNOCENT)["claims"], [])


class Remedies(InFolder):
    def remedy(self, name, pair):
        """What would tell whether these torques are exchanged in a log where they are not."""
        with logs(name, self.folder) as made:
            made.row(0, guilty=False)
            measured = files.read(self.folder / f"{name}-innocent-1.csv", made.arm)
            other = wiring.Search(made.statics, measured).judged(wiring.Hypothesis((suspects.Suspect("torques exchanged", pair),)), None)
            return accusations.Verdict(made.statics, measured).pose_apart_from(other)

    def test_are_a_pose_where_gravity_tells(self):
        self.assertIsNotNone(self.remedy("wall", (1, 2)))

    def test_are_no_pose_where_it_does_not(self):
        self.assertIsNone(self.remedy("idle_joints", (0, 1)))


class Evidence(InFolder):
    """What poses can tell, apart from the search."""

    def seen(self, name, fault):
        with logs(name, self.folder) as made:
            return accusations.seen(made.statics, drawn_logs.honest(made.statics, np.random.default_rng(4)), fault)[0]

    def test_is_none_of_joints_that_bear_no_gravity(self):
        for fault in (drawn_logs.Fault("torques exchanged", (0, 1)), drawn_logs.Fault("scale", (1,), 0.5), drawn_logs.Fault("axis turned", (2,))):
            self.assertLess(self.seen("idle_joints", fault), 1.0, fault)

    def test_is_plain_of_joints_that_do(self):
        for fault in (drawn_logs.Fault("torques exchanged", (1, 2)), drawn_logs.Fault("scale", (1,), 0.5), drawn_logs.Fault("axis turned", (2,))):
            self.assertGreater(self.seen("wall", fault), 10.0 * accusations.SEEN, fault)


class Files(InFolder):
    def test_whose_sides_or_masses_are_wrong_are_told_from_wrong_drives(self):
        for kind, value in (("sides negated", 0.0), ("mass", 1e-3), ("mass", 0.45359237), ("mass", 0.0)):
            with logs("one_heavy", self.folder) as made, self.subTest(kind=kind, value=value):
                every = tuple(range(len(made.arm)))
                random = np.random.default_rng(3)
                base, path = drawn_logs.honest(made.statics, random), self.folder / "log.csv"
                accusations.study.write(path, len(made.arm), drawn_logs.recorded(made.statics, base, drawn_logs.Fault(kind, every, value), random))
                row = accusations.judged(made.arm, path)
                self.assertEqual((row["claims"], row["ways"]), ([(kind, every)], []))

    def test_of_exchanged_positions_are_not_taken_for_degrees(self):
        with Arm(program(), ROOT / "tests/data/descriptions/m1013.json") as arm:
            q = np.zeros((4, 6))
            q[:, 2] = 6.0  # as far as others go
            files._check_units({"q": q}, arm)
            with self.assertRaises(files.PosesError):
                files._check_units({"q": 10.0 * q}, arm)


class Sample(InFolder):
    """A log without a fault and one with one of some arms of the study."""

    def check(self, names, logs_of_each):
        for name in names:
            with logs(name, self.folder) as made:
                for row in made.rows(logs_of_each):
                    with self.subTest(accusations.text(row)):
                        self.assertFalse(judged_logs.wrong(row))

    def test_is_judged_rightly(self):
        self.check(SAMPLE, 1)


class Every(Sample):
    """The sixty and sixty of ./axial commission --documents."""

    def test_is_judged_rightly(self):
        self.check(drawn_logs.ARMS, judged_logs.LOGS)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--host", type=pathlib.Path, required=True)
    own, rest = parser.parse_known_args()
    HOST = own.host
    unittest.main(argv=[sys.argv[0], *rest])
