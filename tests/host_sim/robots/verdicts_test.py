"""Identification accuses on evidence: logs without a mistake and with one, of noise that hides what light joints do.

usage: verdicts_test.py --host BUILD_FOLDER [unittest arguments]
"""

import argparse
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "host_sim/robots" / each) for each in ("verdicts", "identification", "commissioning")]
import drawn_logs  # noqa: E402
import judged_logs  # noqa: E402
import recording  # noqa: E402
import smoothing  # noqa: E402
import verdicts  # noqa: E402

HOST = None
SEED = 5


def logs(name, folder):
    return verdicts.Logs(HOST / "host_sim/robots/identification/robot_regressor", folder, drawn_logs.ARMS.index(name))


class Noise(unittest.TestCase):
    """What is taken for noise of smoothed torques."""

    RATE, ROWS, SIZE = 500.0, 4000, 0.2

    def setUp(self):
        self.smoother = smoothing.Smoother(self.RATE)
        time = np.arange(self.ROWS) / self.RATE
        self.motion = np.column_stack([20.0 * np.sin(2.0 * time), np.sign(np.sin(3.0 * time))])  # gravity, and friction that jumps
        self.white = self.SIZE * np.random.default_rng(SEED).normal(size=self.motion.shape)

    def test_is_what_the_filter_leaves_of_white_noise(self):
        left = np.std(self.smoother.low_pass(self.white)[100:-100], axis=0)
        np.testing.assert_allclose(self.smoother.noise(self.motion + self.white), left, rtol=0.25)  # some 150 independent values

    def test_is_none_of_motion(self):
        self.assertLess(self.smoother.noise(self.motion).max(), 1e-3 * self.SIZE)

    def test_of_an_encoder_is_at_least_its_rounding(self):
        count = 2.0 * np.pi / 2 ** 13
        slow = np.round(np.column_stack([0.3 * np.sin(0.1 * np.arange(self.ROWS) / self.RATE)] * 2) / count) * count  # few counts a second
        log = smoothing.Smoother.shaken(self.smoother, recording.Recording(np.arange(self.ROWS) / self.RATE, slow, None, self.white, []))
        np.testing.assert_allclose(np.std(log.q - slow, axis=0), count / np.sqrt(12.0), rtol=0.1)
        self.assertIs(log.tau, self.white)

    def test_is_never_most_of_the_torques(self):
        self.assertLess(self.smoother.noise(100.0 * self.white).max(), smoothing.NOISY * 100.0 * self.SIZE)


class Logs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def check(self, names, logs_of_each):
        for name in names:
            with logs(name, self.folder) as made:
                for row in made.rows(logs_of_each):
                    with self.subTest(arm=row["arm"], log=row["log"], planted=row["planted"], said=row["said"]):
                        self.assertFalse(judged_logs.wrong(row))


class Sample(Logs):
    def test_is_judged_rightly(self):
        self.check(("z1", "ur3"), 1)

    def test_is_refused_where_noise_counts_as_left(self):
        """The first log of a Z1 has a wrist a quarter of whose torque is noise."""
        with logs("z1", self.folder) as made, unittest.mock.patch.object(smoothing, "NOISY", 0.0):
            self.assertIn("is left unexplained", made.row(0, guilty=False)["said"])


    def test_an_encoder_that_counts_coarsely_is_no_mistake(self):
        """The third log of this arm has 13 bits and a joint without gravity: what they make of its torque is above the limit."""
        with logs("one_heavy", self.folder) as made:
            self.assertEqual(made.row(2, guilty=True)["outcome"], "named")
            with unittest.mock.patch.object(smoothing.Equations, "noise_of_all", lambda equations, _: equations.noise):
                self.assertEqual(made.row(2, guilty=True)["outcome"], "unnamed")


class Every(Logs):
    """All of ./axial identify --documents."""

    def test_is_judged_rightly(self):
        self.check(drawn_logs.ARMS, judged_logs.LOGS)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--host", type=pathlib.Path, required=True)
    own, rest = parser.parse_known_args()
    HOST = own.host
    unittest.main(argv=[sys.argv[0], *rest])
