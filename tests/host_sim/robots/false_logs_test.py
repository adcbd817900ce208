"""Logs with one mistake each, of altered arms by Orocos KDL (simulated_log): ./axial identify writes no header and names the mistake. Logs
without a mistake raise no alarm. Robots of robots/ and random ones.

usage: false_logs_test.py --host BUILD_FOLDER [unittest arguments]
"""

import argparse
import contextlib
import dataclasses
import io
import json
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/robots/identification"))
import doubts  # noqa: E402
import identify  # noqa: E402
import recording  # noqa: E402
import robot as robots  # noqa: E402
import study  # noqa: E402
from suspects import Suspect  # noqa: E402

HOST = None
LIMIT = 0.05
# Robot, what is done to its log (joints from 0), what is said of it.
MISTAKES = (
    ("scara", Suspect("torques exchanged", (1, 2)), "columns tau2 and tau3 look exchanged"),
    ("scara", Suspect("torques exchanged", (0, 1)), "columns tau1 and tau2 look exchanged"),
    ("scara", Suspect("torque negated", (2,)), "tau3 looks negated"),
    ("scara", Suspect("axis turned", (1,)), "the axis of joint 2 looks turned around"),
    ("scara", Suspect("position negated", (1,)), "q2 looks negated"),
    ("scara", Suspect("positions exchanged", (0, 1)), "columns q1 and q2 look exchanged"),
    ("scara", Suspect("drives exchanged", (1, 2)), "drives 2 and 3 look exchanged"),
    ("scara", Suspect("torque scaled", (1,), 1.4), "tau2 looks scaled by 1.3"),
    ("scara", Suspect("degrees", (0, 1)), "every angle looks given in degrees"),
    ("puma560", Suspect("torques exchanged", (4, 5)), "columns tau5 and tau6 look exchanged"),
    ("puma560", Suspect("torque negated", (5,)), "tau6 looks negated"),
    ("puma560", Suspect("axis turned", (1,)), "the axis of joint 2 looks turned around"),
    ("puma560", Suspect("position negated", (4,)), "q5 looks negated"),
    ("panda", Suspect("torque negated", (6,)), "tau7 looks negated"),
    ("panda", Suspect("drives exchanged", (5, 6)), "drives 6 and 7 look exchanged"),
    ("panda", Suspect("zero off", (3,), 0.5), "the zero of joint 4 looks off: q4 is 2"),
    ("panda", Suspect("zero off", (1,), -0.5 * np.pi), "the zero of joint 2 looks off: q2 is -90"),
    ("random-1", Suspect("torques exchanged", (1, 2)), "columns tau2 and tau3 look exchanged"),
    ("random-1", Suspect("torque negated", (0,)), "tau1 looks negated"),
    ("random-2", Suspect("drives exchanged", (1, 2)), "drives 2 and 3 look exchanged"),
    ("random-2", Suspect("axis turned", (2,)), "the axis of joint 3 looks turned around"),
    ("random-2", Suspect("torque negated", (0, 1, 2, 3)), "every tau looks negated"),
    # Joints that share drives: columns are the drives'.
    ("scara_quill", Suspect("torques exchanged", (2, 3)), "columns tau3 and tau4 look exchanged"),
    ("scara_quill", Suspect("drives exchanged", (2, 3)), "drives 3 and 4 look exchanged, positions and torques"),
    ("scara_quill", Suspect("torque negated", (2,)), "tau3 looks negated"),
    ("scara_quill", Suspect("torque negated", (3,)), "tau4 looks negated"),
    ("scara_quill", Suspect("axis turned", (2,)), "drive 3 looks turned around: q3 and tau3 are both negated"),
    ("scara_quill", Suspect("axis turned", (1,)), "drive 2 looks turned around"),
    ("palletiser", Suspect("torques exchanged", (1, 2)), "columns tau2 and tau3 look exchanged"),
    ("palletiser", Suspect("torque negated", (2,)), "tau3 looks negated"),
    ("palletiser", Suspect("axis turned", (2,)), "drive 3 looks turned around"),
    ("palletiser", Suspect("position negated", (1,)), "q2 looks negated"),
    ("wrist_arm", Suspect("torques exchanged", (3, 4)), "columns tau4 and tau5 look exchanged"),
    ("wrist_arm", Suspect("axis turned", (2,)), "drive 3 looks turned around"),
    ("wrist_arm", Suspect("zero off", (1,), 0.6), "the zero of drive 2 looks off: q2 is 3"),
)


def random_table(seed, joints=4):
    """An arm that nobody has seen: revolute joints with general and right-angled twists, bodies of any direction."""
    random = np.random.default_rng(seed)
    uniform = lambda low, high, *size: np.round(random.uniform(low, high, *size), 4).tolist()
    link = lambda i: {"type": "revolute", "alpha_deg": [0, 90, -90, 37][random.integers(4)] if i else 0, "a": uniform(0.1, 0.4), "d": uniform(-0.2, 0.2),
                      "mass": uniform(1, 5), "com": uniform(-0.15, 0.15, 3), "inertia_com": [*uniform(0.02, 0.03, 3), *uniform(-0.005, 0.005, 3)],
                      "position_limits": [-2.5, 2.5], "speed_limit": 3.0, "acceleration_limit": 10.0, "effort_limit": 80.0}
    return {"name": f"random-{seed}", "convention": "modified", "gravity": uniform(-6, 6, 3), "links": [link(i) for i in range(joints)]}


def planted(log, mistake):
    """The log as it would be with the mistake; written apart from what undoes one."""
    q, tau, joints = log.q.copy(), log.tau.copy(), list(mistake.joints)
    moved, measured = {"torques exchanged": ([], [tau]), "positions exchanged": ([q], []), "drives exchanged": ([q], [tau]),
                       "torque negated": ([], [tau]), "position negated": ([q], []), "axis turned": ([q], [tau]), "degrees": ([q], []),
                       "torque scaled": ([], [tau]), "zero off": ([q], [])}[mistake.kind]
    for values in moved + measured:
        if len(joints) == 2 and mistake.kind.endswith("exchanged"):
            first = values[:, joints[0]].copy()
            values[:, joints[0]] = values[:, joints[1]]
            values[:, joints[1]] = first
        elif mistake.kind == "zero off":
            values[:, joints] += mistake.value
        else:
            values[:, joints] *= {"degrees": 180.0 / np.pi, "torque scaled": mistake.value}.get(mistake.kind, -1.0)
    return dataclasses.replace(log, q=q, tau=tau)


def write_log(path, log):
    joints = log.q.shape[1]
    header = ["time"] + [f"{name}{i + 1}" for name in ("q", "tau") for i in range(joints)]
    np.savetxt(path, np.column_stack([log.time, log.q, log.tau]), fmt="%.12g", delimiter=",", header=",".join(header), comments="")


class Arms:
    """Robots with their clean, noisy logs, each made once."""

    folder = None
    made = {}

    @classmethod
    def of(cls, name):
        if name not in cls.made:
            cls.folder = cls.folder or tempfile.TemporaryDirectory()
            described = name
            if name.startswith("random"):
                described = pathlib.Path(cls.folder.name, f"{name}.json")
                described.write_text(json.dumps(random_table(int(name[-1]))), encoding="utf-8")
            robot = robots.Robot(HOST / "host_sim/robots/identification/robot_regressor", described)
            arm = Simulated(robot, described, cls.folder.name)
            cls.made[name] = robot, described, arm.log("excitation", study.RATE, study.COUNTS, study.NOISE)[0], arm
        return cls.made[name]

    @classmethod
    def forget(cls):
        for robot, *_ in cls.made.values():
            robot.__exit__()
        if cls.folder:
            cls.folder.cleanup()


class Simulated(study.Arm):
    """An arm by its name or its table, on motions that nobody optimised."""

    def __init__(self, robot, described, folder):
        super().__init__(robot, HOST / "tests/host_sim/simulated_log", folder, 0, described)


def unload():
    Arms.forget()


unittest.addModuleCleanup(unload)


def run(*arguments):
    """Status, what was printed, what was said on standard error."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = identify.main([*map(str, arguments), "--program", str(HOST / "host_sim/robots/identification/robot_regressor")])
    return status, out.getvalue(), err.getvalue()


class Mistakes(unittest.TestCase):
    def test_are_named_each(self):
        self.assertGreaterEqual(len(MISTAKES), 20)
        for name, mistake, said in MISTAKES:
            with self.subTest(robot=name, mistake=mistake):
                robot, _, log, _ = Arms.of(name)
                text = verdict(robot, planted(log, mistake))
                self.assertIn(said, text)
                self.assertRegex(text, r"the residual (falls from [0-9.e+]+ % to|is then) [0-4]\.")

    def test_that_a_log_does_not_tell_apart_are_all_named(self):
        """Mirrored, a SCARA is a SCARA: turning the one axis is turning the other and the mirror."""
        robot, _, log, _ = Arms.of("scara")
        for joint in (0, 1):
            text = verdict(robot, planted(log, Suspect("axis turned", (joint,))))
            for named in ("the axis of joint 1 looks turned around", "the axis of joint 2 looks turned around", "this log does not tell which"):
                self.assertIn(named, text)
        self.assertNotIn("does not tell", verdict(robot, planted(log, Suspect("torques exchanged", (1, 2)))))

    def test_that_are_none_are_not_named(self):
        for name in ("planar2r", "scara", "scara_rrpr", "puma560", "panda", "random-1", "random-2", "random-3", "scara_quill", "palletiser",
                     "wrist_arm"):
            with self.subTest(robot=name):
                robot, _, log, _ = Arms.of(name)
                found = identify.Identification(robot, log)
                self.assertLess(found.residuals().max(), identify.SUSPICIOUS * LIMIT)
                self.assertEqual(found.doubts, [])

    def test_of_the_unit_of_every_torque_are_named(self):
        """Bodies of a thousand times the mass explain torques in N mm, so the description is asked."""
        for name, factor in (("planar2r", 1000.0), ("puma560", 1000.0), ("panda", 0.001), ("random-1", 1000.0), ("random-3", 0.001)):
            with self.subTest(robot=name, factor=factor):
                robot, _, log, _ = Arms.of(name)
                text = verdict(robot, dataclasses.replace(log, tau=log.tau * factor))
                self.assertIn("no header is written; every tau looks scaled by ", text)
                self.assertLess(abs(np.log2(float(text.split("scaled by ")[1].split(":")[0]) / factor)), 1.0, text)
                self.assertIn(f"--torque-scale {factor:g} divides them", text)

    def test_that_may_be_rough_descriptions_are_only_told(self):
        robot, _, log, _ = Arms.of("puma560")
        self.assertIn("on the joint's side, in N m?", verdict(robot, dataclasses.replace(log, tau=log.tau * 10.0)))

    def test_that_a_robot_hides_are_no_mistakes_of_its_log(self):
        """Two parallelograms' arms are alike: exchanged, the drives are those of an arm with the other's bodies; their zeros and a quill's are other
        bodies as well. It is right to say nothing."""
        for name, mistake in (("palletiser", Suspect("drives exchanged", (1, 2))), ("palletiser", Suspect("zero off", (1,), 0.3)),
                              ("palletiser", Suspect("zero off", (2,), 0.3)), ("scara_quill", Suspect("zero off", (1,), 0.3))):
            with self.subTest(robot=name, mistake=mistake):
                robot, _, log, _ = Arms.of(name)
                hidden = identify.Identification(robot, planted(log, mistake))
                self.assertLess(hidden.residuals().max(), identify.SUSPICIOUS * LIMIT)

    def test_that_pass_are_those_of_the_guide(self):
        """Other bodies explain most of these. Found one day, they leave the guide, and join MISTAKES."""
        for name, mistake in (("palletiser", Suspect("torque scaled", (1,), 1.4)), ("palletiser", Suspect("torque scaled", (2,), 1.4)),
                              ("scara_quill", Suspect("axis turned", (3,)))):
            with self.subTest(robot=name, mistake=mistake):
                robot, _, log, _ = Arms.of(name)
                passed = identify.Identification(robot, planted(log, mistake))
                self.assertTrue(identify.SUSPICIOUS * LIMIT < passed.residuals().max() < 0.02)
                self.assertEqual(passed.doubts, [])

    def test_of_no_suspect_are_not_pinned_on_one(self):
        robot, _, log, _ = Arms.of("scara")
        strange = dataclasses.replace(log, tau=log.tau * np.sign(np.sin(7.0 * log.time))[:, None])
        self.assertIn("no single exchange", verdict(robot, strange))


class Reactions(unittest.TestCase):
    """A mistake whose suspect is struck from the list is not named: each of the list is there for something."""

    def test_are_each_needed(self):
        ranked = doubts.Doubts.ranked
        for name, mistake, said in (each for each in MISTAKES if each[0] == "scara"):
            def without(judged, kind=mistake.kind):
                return [suspect for suspect in ranked(judged) if suspect.kind != kind]

            with self.subTest(mistake=mistake), unittest.mock.patch.object(doubts.Doubts, "ranked", without):
                robot, _, log, _ = Arms.of(name)
                self.assertNotIn(said, verdict(robot, planted(log, mistake)))


def verdict(robot, log):
    """What is said of a log; empty where it is taken."""
    options = argparse.Namespace(log="log", keep=(), cutoff=None, residual_limit=100 * LIMIT, torque_scale=None)
    try:
        with contextlib.redirect_stderr(io.StringIO()):
            identify.refuse(found := identify.identified(robot, log, options), {"log": found.equations}, options)
            return " ".join(identify.suspicion(found, options))
    except ValueError as error:
        return str(error)


class Verb(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.robot, self.described, self.log, self.arm = Arms.of("scara")
        self.header, self.path = self.folder / "arm.hpp", self.folder / "log.csv"

    def identify(self, log, *more):
        write_log(self.path, log)
        return run(self.path, "--robot", self.described, "-o", self.header, "--output", self.folder / "out", *more)

    def test_writes_no_header_of_a_false_log(self):
        status, _, err = self.identify(planted(self.log, Suspect("torques exchanged", (1, 2))))
        self.assertEqual(status, 1)
        self.assertFalse(self.header.exists())
        self.assertIn("columns tau2 and tau3 look exchanged: the residual falls from", err)
        self.assertIn("no header is written", err)

    def test_takes_another_limit(self):
        status, _, err = self.identify(planted(self.log, Suspect("torques exchanged", (1, 2))), "--residual-limit", "300")
        self.assertEqual(status, 0, err)
        self.assertTrue(self.header.exists())

    def test_takes_torques_by_the_scale_that_is_told(self):
        _, self.described, log, _ = Arms.of("planar2r")
        for factor, told, taken in ((1000.0, (), False), (1000.0, ("--torque-scale", "1000"), True), (0.01, (), False), (0.01, ("--torque-scale", "1"), True)):
            with self.subTest(factor=factor, told=told):
                status, out, err = self.identify(dataclasses.replace(log, tau=log.tau * factor), *told)
                self.assertEqual(status, 0 if taken else 1, err)
                self.assertEqual(self.header.exists(), taken)
                self.assertEqual("looks scaled" in out + err, not taken)
                self.header.unlink(missing_ok=True)

    def test_says_verified_only_of_a_second_log(self):
        status, out, err = self.identify(self.log)
        self.assertEqual(status, 0, err)
        written = self.header.read_text(encoding="utf-8")
        self.assertNotIn("verified", written)
        self.assertIn("// fitted:   masses, centres of mass, inertias, rotors, friction", written)
        self.assertNotIn("beyond 5 standard deviations", out)
        second = self.folder / "second.csv"
        write_log(second, self.arm.log("validation", study.RATE, study.COUNTS, study.NOISE)[0])
        self.assertEqual(self.identify(self.log, "--validate", second)[0], 0)
        self.assertIn("// verified: RMS of predicted less measured torque of second.csv", self.header.read_text(encoding="utf-8"))

    def test_writes_no_header_that_a_second_log_contradicts(self):
        second = self.folder / "second.csv"
        write_log(second, planted(self.log, Suspect("torque negated", (2,))))
        status, _, err = self.identify(self.log, "--validate", second)
        self.assertEqual(status, 1)
        self.assertIn("second.csv", err)
        self.assertFalse(self.header.exists())

    def test_says_what_was_kept(self):
        self.assertEqual(self.identify(self.log, "--keep", "rotors", "--residual-limit", "90")[0], 0)
        written = self.header.read_text(encoding="utf-8")
        self.assertIn("// fitted:   not rotors, which are as before", written)

    def test_forgets_that_rotors_were_missing(self):
        urdf = ROOT / "tests/data/descriptions/ur10_robot.urdf"
        with robots.Robot(HOST / "host_sim/robots/identification/robot_regressor", urdf) as robot:
            content = {"name": "arm", "source": "", "parameters": robot.prior.tolist(), "notes": [], "fitted": ["rotors"], "figures": []}
            for fitted in (True, False):
                values = self.folder / "values.json"
                values.write_text(json.dumps({**content, "rotors_fitted": fitted}), encoding="utf-8")
                robot.write_header(self.folder / f"{fitted}.hpp", values)
        self.assertNotIn("no rotor inertias", (self.folder / "True.hpp").read_text(encoding="utf-8"))
        self.assertIn("no rotor inertias", (self.folder / "False.hpp").read_text(encoding="utf-8"))

    def test_an_exact_log_has_no_outlying_rows(self):
        for name in ("scara", "puma560"):
            robot, _, _, arm = Arms.of(name)
            found = identify.Identification(robot, arm.log("excitation", study.RATE)[0])
            self.assertEqual([count for count, _ in found.fit.outliers], [0] * len(robot))

    def test_a_contact_is_an_outlying_row(self):
        tau = self.log.tau.copy()
        tau[3000:3200, 0] += 3.0 * np.std(tau[:, 0])
        count, first = identify.Identification(self.robot, dataclasses.replace(self.log, tau=tau)).fit.outliers[0]
        self.assertGreater(count, 0)
        self.assertAlmostEqual(first, 3.0, delta=0.5)


class Units(unittest.TestCase):
    """What a log's own columns tell."""

    def refuse(self, text, *words):
        with tempfile.TemporaryDirectory() as folder, robots.Robot(HOST / "host_sim/robots/identification/robot_regressor", "planar2r") as robot:
            path = pathlib.Path(folder, "log.csv")
            path.write_text(text, encoding="utf-8")
            with self.assertRaises(recording.RecordingError) as caught:
                recording.read(path, robot)
        for word in words:
            self.assertIn(word, str(caught.exception))

    def table(self, separator=",", q=1.0, qd=None):
        time = np.arange(300) * 0.01
        columns = {"time": time, "q1": q * np.sin(time), "q2": q * np.cos(2 * time), "tau1": time, "tau2": time}
        if qd is not None:
            columns |= {"qd1": qd * np.cos(time), "qd2": -2 * qd * np.sin(2 * time)}
        rows = zip(*([f"{value:.9g}" for value in values] for values in columns.values()))
        return "\n".join(separator.join(row) for row in [tuple(columns), *rows])

    def test_semicolons(self):
        self.refuse(self.table(";"), "separated by semicolons", "commas")

    def test_tabs(self):
        self.refuse(self.table("\t"), "separated by tabs")

    def test_blanks(self):
        self.refuse(self.table(" "), "separated by blanks")

    def test_degrees_of_small_motions_beside_speeds(self):
        self.refuse(self.table(q=2.0, qd=2.0 * np.pi / 180.0), "57.", "q is in degrees")

    def test_speeds_in_degrees(self):
        self.refuse(self.table(qd=180.0 / np.pi), "qd is in degrees")

    def test_speeds_of_the_other_sign(self):
        self.refuse(self.table(qd=-1.0), "negated")

    def test_degrees_beyond_the_limits(self):
        self.refuse(self.table(q=10.0), "degrees")

    def test_right_speeds_are_taken(self):
        with tempfile.TemporaryDirectory() as folder, robots.Robot(HOST / "host_sim/robots/identification/robot_regressor", "planar2r") as robot:
            path = pathlib.Path(folder, "log.csv")
            path.write_text(self.table(qd=1.0), encoding="utf-8")
            self.assertEqual(recording.read(path, robot).qd.shape, (300, 2))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--host", type=pathlib.Path, required=True)
    known, rest = parser.parse_known_args()
    HOST = known.host
    unittest.main(argv=[sys.argv[0], *rest])
