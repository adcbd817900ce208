"""Identification and excitation, on logs of altered arms by Orocos KDL (simulated_log); logs that cannot be used; the verbs' programs.

usage: identification_test.py --host BUILD_FOLDER [unittest arguments]
"""

import argparse
import contextlib
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/robots/identification"))
import base_parameters  # noqa: E402
import consistency  # noqa: E402
import excite  # noqa: E402
import fourier  # noqa: E402
import identify  # noqa: E402
import recording  # noqa: E402
import robot as robots  # noqa: E402
import study  # noqa: E402

HOST = None


def program():
    return HOST / "host_sim/robots/identification/robot_regressor"


def simulator():
    return HOST / "tests/host_sim/simulated_log"


def run(main, *arguments):
    """Status, what was printed, what was said on standard error."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = main([*map(str, arguments), "--program", str(program())])
    return status, out.getvalue(), err.getvalue()


class Base(unittest.TestCase):
    def inertial(self, name):
        with robots.Robot(program(), name) as robot:
            return len(base_parameters.base_of(robot, np.array([i for i, kind in enumerate(robot.kinds) if kind[0] in "mI"])))

    def test_has_the_published_number_of_inertial_parameters(self):
        # Khalil, Dombre, "Modeling, Identification and Control of Robots", 2002: 36 of the Stäubli RX-90's geometry, which a Puma's is;
        # Gaz et al., IEEE RA-L 4(4), 2019: 43 dynamic coefficients of the Panda.
        self.assertEqual(self.inertial("puma560"), 36)
        self.assertEqual(self.inertial("panda"), 43)

    def test_of_craigs_two_link_arm_is_what_its_closed_form_has(self):
        with robots.Robot(program(), "planar2r") as robot:
            free = np.array([i for i, kind in enumerate(robot.kinds) if kind[0] in "mI"])
            base = base_parameters.base_of(robot, free)
            found = {base_parameters.expression(row, [robot.names[k] for k in free]) for row in base.combinations}
        self.assertEqual(found, {"mx1 + 0.5 m2", "my1", "Izz1 + 0.25 m2", "mx2", "my2", "Izz2"})


class Consistency(unittest.TestCase):
    def test_pseudo_inertia_is_undone(self):
        link = np.array([2.0, 0.2, -0.1, 0.3, 0.4, 0.5, 0.3, 0.02, -0.03, 0.01])
        np.testing.assert_allclose(consistency.link_of(consistency.pseudo_inertia(link)), link, rtol=0, atol=1e-15)

    def test_of_a_ball_is_its_second_moment(self):
        # A homogeneous ball of mass m and radius r: I = 2/5 m r^2, second moment 1/5 m r^2.
        pseudo = consistency.pseudo_inertia([5.0, 0, 0, 0, 0.5, 0.5, 0.5, 0, 0, 0])
        np.testing.assert_allclose(pseudo, np.diag([0.25, 0.25, 0.25, 5.0]))

    def test_of_a_prior_that_is_none_is_made(self):
        bad = np.array([1.0, 0, 0, 0, 0.1, 0.1, 0.5, 0, 0, 0])  # zz above xx + yy
        good = np.array([1.0, 0.5, 0, 0, 0.1, 0.4, 0.4, 0, 0, 0])
        massless = np.zeros(10)
        pseudo, changed = consistency.consistent_prior([bad, good, massless])
        self.assertEqual(changed, [0, 2])
        for each in pseudo:
            self.assertGreater(np.linalg.eigvalsh(each).min(), 0.0)
        np.testing.assert_allclose(consistency.link_of(pseudo[1]), good)


class Found(unittest.TestCase):
    """The figures that doc/measurements/identified_arms.md promises, of small and of large arms."""

    def judge(self, name, rounds, exactly=1e-8):
        with tempfile.TemporaryDirectory() as folder:
            (exact, noisy), _ = study.study(program(), simulator(), name, folder, rounds)
        for row in (exact, noisy):
            self.assertGreater(row["least_eigenvalue"], 0.0, row)
            self.assertGreater(row["torque_error_prior"], 0.05, row)
        self.assertLess(exact["base_error_relative"], exactly, exact)
        self.assertLess(exact["torque_error_identified"], 1e-8, exact)
        self.assertLess(noisy["torque_error_identified"], 0.01, noisy)

    def test_of_a_scara(self):
        self.judge("scara", 2)

    def test_of_a_panda(self):
        self.judge("panda", 2)

    def test_of_a_quill_by_its_drives(self):
        self.judge("scara_quill", 2)

    def test_of_a_palletiser_by_its_drives(self):
        """Its four drives weigh bodies of twelve tons' moments and a gripper's friction: of an exact log the least parameters have fewer digits."""
        self.judge("palletiser", 2, 1e-5)

    def test_of_a_differential_wrist_by_its_drives(self):
        self.judge("wrist_arm", 2)

    def test_of_a_gripper_by_its_drives(self):
        """A drive that slides, and a finger that mirrors."""
        self.judge("gripper", 2)


class Motions(unittest.TestCase):
    def test_start_and_end_at_rest_inside_the_limits(self):
        with robots.Robot(program(), "puma560") as robot:
            excitation = excite.Excitation(robot, 6.0, 4)
            shape = np.random.default_rng(5).normal(size=excitation.series.joints * excitation.series.size)
            time_s = np.arange(6001) / 1000
            q, qd, qdd = excite.motion_at(excitation, shape, time_s)
        for end in (qd[0], qdd[0], qd[-1], qdd[-1]):
            np.testing.assert_allclose(end, 0.0, atol=1e-9)
        lim = excitation.limits
        self.assertTrue(np.all(q > lim.low) and np.all(q < lim.high) and np.all(np.abs(qd) < lim.speed) and np.all(np.abs(qdd) < lim.acceleration))
        np.testing.assert_allclose(np.gradient(q, 0.001, axis=0)[1:-1], qd[1:-1], atol=1e-4)
        np.testing.assert_allclose(np.gradient(qd, 0.001, axis=0)[1:-1], qdd[1:-1], atol=1e-3)
        peak = np.max([np.abs(qd).max(axis=0) / lim.speed, np.abs(qdd).max(axis=0) / lim.acceleration, np.ptp(q, axis=0) / (lim.high - lim.low)], axis=0)
        self.assertTrue(np.all(peak > fourier.MARGIN * fourier.LEAST * 0.99))

    def test_of_shared_drives_keep_the_limits_of_joints(self):
        """G is written by hand: slide by nut and spline; forearm between two drives; a differential wrist."""
        lead = 0.020 / (2 * np.pi)
        for name, ratios, low, high, speed in (("scara_quill", [0, 0, lead, -lead], 0.0, 0.2, 1.1), ("palletiser", [0, -1, 1, 0], -2.9, -0.25, np.inf),
                                               ("gripper", [0, 1], 0.0, 0.045, 0.3), ("wrist_arm", [0, -1, 1, 0, 0], -2.6, 0.4, 5.0), ("wrist_arm", [0, 0, 0, 0.5, 0.5], -1.9, 1.9, 8.0)):
            with self.subTest(robot=name, ratios=ratios), robots.Robot(program(), name) as robot:
                self.assertEqual(len(robot), len(ratios))
                excitation = excite.Excitation(robot, 8.0, 5)
                lim, widest = excitation.limits, 0.0
                for seed in range(30):
                    shape = 2.0 * np.random.default_rng(seed).normal(size=excitation.series.joints * excitation.series.size)
                    q, qd, qdd = excite.motion_at(excitation, shape, np.arange(801) / 100)
                    self.assertTrue(np.all(q > lim.low) and np.all(q < lim.high) and np.all(np.abs(qd) < lim.speed) and np.all(np.abs(qdd) < lim.acceleration))
                    joint = q @ ratios
                    self.assertTrue(low < joint.min() and joint.max() < high)
                    self.assertLess(np.abs(qd @ ratios).max(), speed)
                    widest = max(widest, np.ptp(joint))
                self.assertGreater(widest, 0.2 * (high - low))

    def test_are_the_same_twice_and_better_for_the_optimisation(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in "ab":
                status, out, err = run(excite.main, "--robot", "scara", "-o", f"{folder}/{name}.csv", "--rounds", 1, "--rate", 100, "--json",
                                       f"{folder}/{name}.json")
                self.assertEqual(status, 0, err)
            self.assertEqual(pathlib.Path(folder, "a.csv").read_bytes(), pathlib.Path(folder, "b.csv").read_bytes())
            rows = json.loads(pathlib.Path(folder, "a.json").read_text(encoding="utf-8"))
            self.assertTrue(pathlib.Path(folder, "a.png").exists())
        self.assertIn("condition", out)
        self.assertLess(rows[0]["condition"], rows[0]["condition_random"])


class CommandLine(unittest.TestCase):
    def test_writes_report_picture_and_header(self):
        with tempfile.TemporaryDirectory() as folder, robots.Robot(program(), "planar2r") as robot:
            arm = study.Arm(robot, simulator(), folder, 0)
            arm.log("excitation", study.RATE, study.COUNTS, study.NOISE)
            header, second = pathlib.Path(folder, "my_arm.hpp"), shutil.copy(f"{folder}/planar2r-log.csv", f"{folder}/second.csv")
            status, out, err = run(identify.main, f"{folder}/planar2r-log.csv", "--robot", "planar2r", "--output", f"{folder}/out", "-o", header,
                                   "--json", f"{folder}/rows.json", "--validate", second)
            self.assertEqual(status, 0, err)
            rows = json.loads(pathlib.Path(folder, "rows.json").read_text(encoding="utf-8"))
            self.assertTrue(pathlib.Path(folder, "out/torques.png").exists())
            subprocess.run(["g++", "-std=c++17", "-fsyntax-only", "-I", ROOT / "firmware/include", "-include", header, "-x", "c++", "/dev/null"], check=True)
            written = header.read_text(encoding="utf-8")
        self.assertIn("base parameter", out)
        self.assertIn("struct MyArm", written)
        identified = {row["parameter"]: row["value"] for row in rows if row["kind"] == "standard"}
        self.assertIn(f".mass({identified['m2']!r})", written)
        self.assertEqual([row["joint"] for row in rows if row["kind"] == "torque"], [1, 2, 1, 2])

    def test_takes_tables_and_urdfs(self):
        descriptions = ROOT / "tests/data/descriptions"
        for name, tip, joints in (("spong_2link.json", "", 2), ("ur10_robot.urdf", "ee_link", 6)):
            with robots.Robot(program(), descriptions / name, tip) as robot:
                self.assertEqual(len(robot), joints)
                self.assertEqual(robot.regressor(np.zeros((1, joints)), np.zeros((1, joints)), np.ones((1, joints)))[0].shape, (1, joints, 14 * joints))

    def test_unknown_robots_are_named(self):
        status, _, err = run(identify.main, "log.csv", "--robot", "puma")
        self.assertEqual(status, 1)
        self.assertIn("puma560", err)

    def test_joints_that_share_drives_are_excited_by_their_drives(self):
        with tempfile.TemporaryDirectory() as folder:
            status, out, err = run(excite.main, "--robot", ROOT / "tests/import/coupled_arm.urdf", "-o", f"{folder}/motion.csv", "--rounds", 0,
                                   "--duration", 4, "--rate", 100)
        self.assertEqual(status, 0, err)
        self.assertIn("drive ", out)

    def test_the_header_of_shared_drives_is_in_their_terms(self):
        with tempfile.TemporaryDirectory() as folder, robots.Robot(program(), "palletiser") as robot:
            arm = study.Arm(robot, simulator(), folder, 0)
            _, truth = arm.log("excitation", study.RATE, study.COUNTS, study.NOISE)
            header = pathlib.Path(folder, "my_arm.hpp")
            status, out, err = run(identify.main, f"{folder}/palletiser-log.csv", "--robot", "palletiser", "--output", f"{folder}/out", "-o", header)
            self.assertEqual(status, 0, err)
            written = header.read_text(encoding="utf-8")
            check = pathlib.Path(folder, "check.cpp")
            check.write_text(f'#include <axial/axial.hpp>\n#include "{header}"\nusing R = robots::MyArm;\nstatic_assert(axial::joint_count<R> == 4);\n'
                             'static_assert(axial::joint_rates<R>(axial::Joints<R, double>{0, 3, 2, 0})[4] == -1.0);\n'
                             f'static_assert(R::chain.links[9].rotor_inertia > 0.0 && R::chain.links[4].rotor_inertia == 0.0);\n', encoding="utf-8")
            done = subprocess.run(["g++", "-std=c++17", "-fsyntax-only", "-I", ROOT / "firmware/include", check], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("10 joints of 4 drives", written)
        self.assertIn("drive by drive: ", " ".join(written.replace("//", " ").split()))
        self.assertIn("  drive 4", out)


class Logs(unittest.TestCase):
    """Each log that cannot be used is refused with what is wrong, where, and what to do."""

    def refuse(self, change, *words):
        time = np.arange(300) * 0.01
        table = {"time": time, "q1": np.sin(time), "q2": np.cos(time), "tau1": time, "tau2": time}
        table = {name: [repr(float(value)) for value in values] for name, values in table.items()}
        table = change(table) or table
        lines = [",".join(table)] + [",".join(row) for row in zip(*table.values())]
        with tempfile.TemporaryDirectory() as folder, robots.Robot(program(), "planar2r") as robot:
            path = pathlib.Path(folder, "log.csv")
            path.write_text("\n".join(lines), encoding="utf-8")
            with self.assertRaises(recording.RecordingError) as caught:
                recording.read(path, robot)
        for word in words:
            self.assertIn(word, str(caught.exception))

    def set(self, name, row, value):
        def change(table):
            table[name][row] = value
        return change

    def test_without_a_column(self):
        self.refuse(lambda table: {name: values for name, values in table.items() if name != "tau2"}, "no column tau2", "q1..q2")

    def test_of_half_the_speeds(self):
        self.refuse(lambda table: {**table, "qd1": table["q1"]}, "no column qd2")

    def test_of_another_robot(self):
        self.refuse(lambda table: {**table, "q3": table["q1"], "tau3": table["q1"]}, "q3", "2 joints")

    def test_with_a_hole(self):
        self.refuse(self.set("q2", 7, "nan"), "line 9", "q2 is nan")

    def test_with_a_word(self):
        self.refuse(self.set("tau1", 0, "off"), "line 2", "'off'")

    def test_with_time_going_backward(self):
        self.refuse(self.set("time", 20, "0.05"), "time must grow", "0.05")

    def test_with_a_gap(self):
        self.refuse(lambda table: {name: values[:100] + values[200:] for name, values in table.items()}, "a gap", "cut the log")

    def test_too_short(self):
        self.refuse(lambda table: {name: values[:50] for name, values in table.items()}, "50 rows", "at least")

    def test_of_a_joint_that_rests(self):
        self.refuse(lambda table: {**table, "q1": ["0.1"] * 300}, "joint 1 never moves")

    def test_in_degrees(self):
        self.refuse(lambda table: {**table, "q1": [repr(120 * float(value)) for value in table["q1"]]}, "joint 1", "degrees")

    def test_in_milliseconds(self):
        self.refuse(lambda table: {**table, "time": [repr(1000 * float(value)) for value in table["time"]]}, "milliseconds")

    def test_without_names(self):
        self.refuse(lambda table: {values[0] + "0" * i: values for i, values in enumerate(table.values())}, "no header line")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--host", type=pathlib.Path, required=True)
    known, rest = parser.parse_known_args()
    HOST = known.host
    unittest.main(argv=[sys.argv[0], *rest])
