"""Robots that boards integrate: how many joints fit a tick, what of the promises is met, which rows pass."""

import argparse
import json
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path += [str(ROOT / "host_sim/figures/pages"), str(ROOT / "host_sim/plants/real_time")]
import on_board  # noqa: E402
import plant_tables  # noqa: E402


def second(board, robot, scalar, method, us, **others):
    return {"board": board, "robot": robot, "scalar": scalar, "method": method, "microseconds": us, "cycles": 100, "instructions": 1234, "kind": "exact",
            "real_time_factor": 1000 / us, "real_time_factor_low": 1000 / us, "error": 1e-7, "energy_drift": None, "same_bits": True, "difference": 0.0, **others}


class Joints(unittest.TestCase):
    def most(self, *costs):
        return plant_tables.joints_in_real_time(dict(zip((3, 6, 7), costs)))

    def test_between_measured_robots_a_straight_line(self):
        self.assertEqual(self.most(800.0, 1400.0, 1600.0), 4, "of 4 joints 1000 us, exactly a tick")
        self.assertEqual(self.most(801.0, 1401.0, 1601.0), 3)
        self.assertEqual(self.most(100.0, 999.0, 1001.0), 6)
        self.assertEqual(self.most(100.0, 200.0, 1000.0), 7)

    def test_below_the_smallest_from_nothing(self):
        self.assertEqual(self.most(1500.0, 3000.0, 4000.0), 2, "500 us a joint")
        self.assertEqual(self.most(3001.0, 9000.0, 9000.0), 0)

    def test_above_the_largest_by_the_steeper_line(self):
        self.assertEqual(self.most(150.0, 300.0, 350.0), 20, "50 us a joint either way")
        self.assertEqual(self.most(100.0, 400.0, 500.0), 12, "100 us a joint from 3 to 7, though 7 take 71 each")
        self.assertEqual(self.most(340.0, 345.0, 350.0), 20, "50 us a joint, though the line from 3 to 7 is flat")

    def test_of_a_single_robot(self):
        self.assertEqual(plant_tables.joints_in_real_time({3: 600.0}), 5)


class Tables(unittest.TestCase):
    def made(self, rows, table):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "plant_boards.json").write_text(json.dumps(rows), encoding="utf-8")
            return table(pathlib.Path(folder))

    def promised(self, **changes):
        rows = [second("stm32f405", "puma560", "float", "runge_kutta_4", 40.0), second("rp2040_ram", "puma560", "fixed32", "runge_kutta_4", 900.0),
                second("nrf51", "scara", "fixed32", "semi_implicit", 300.0)]
        rows[0].update(changes)
        drift = {"board": "stm32f405", "robot": "puma560", "scalar": "float", "method": "runge_kutta_4", "energy_drift": 1e-6, "error": None}
        return self.made([*rows, drift], plant_tables.promises)

    def test_what_is_promised_is_held_to_the_worst_case(self):
        self.assertNotIn("NO", self.promised())
        for missed in ({"real_time_factor_low": 9.9}, {"error": 1.1e-5}, {"same_bits": False}):
            self.assertEqual(self.promised(**missed).count("NO"), 1, missed)

    def test_an_interval_counts_by_its_upper_end(self):
        rows = [second("nrf51", robot, "float", "runge_kutta_4", us, cycles_high=200) for robot, us in (("scara", 90.0), ("puma560", 400.0), ("panda", 600.0))]
        self.assertIn("| nrf51 | runge kutta 4 | 6 |", self.made(rows, plant_tables.joints))
        self.assertIn("90.0 to 180.0 (exact)", self.made(rows, plant_tables.boards))


class Robots(unittest.TestCase):
    """Rows of other robots: kept from a commit, shown by the worse end."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.kept, self.made = self.folder / "plant_robots.json", self.folder / "rows.json"

    def call(self, does, robot, commit="c1"):
        does(argparse.Namespace(kept=self.kept, commit=commit, robot=robot, board="stm32f405", rows=self.made))

    def has(self, robot, commit="c1"):
        with self.assertRaises(SystemExit) as ended:
            self.call(on_board.has, robot, commit)
        return ended.exception.code == 0

    def keep(self, robot, commit="c1", **changes):
        row = {**second("stm32f405", robot, "float", "runge_kutta_4", 50.0), "pass": True, "real_time_factor_low": 12.5, "made": True, "growth": 2.6, **changes}
        self.made.write_text(json.dumps([row]), encoding="utf-8")
        self.call(on_board.keep, robot, commit)

    def test_what_this_commit_measured_is_kept_and_what_another_did_is_not(self):
        self.assertFalse(self.has("so101"))
        self.keep("so101")
        self.keep("ur3e")
        self.assertTrue(self.has("so101") and self.has("ur3e"))
        self.assertFalse(self.has("so101", "c2"))
        self.keep("so101", "c2")
        self.assertTrue(self.has("so101", "c2") and self.has("ur3e"))
        self.assertEqual(len(json.loads(self.kept.read_text(encoding="utf-8"))), 2)

    def test_what_was_not_made_is_shown_as_such(self):
        self.keep("so101")
        self.made.unlink()
        self.call(on_board.keep, "iiwa14")
        self.keep("drawn", **{"pass": False})
        self.keep("openarm", **{"pass": False, "made": False})
        shown = plant_tables.robots(self.folder)
        self.assertIn("| so101 | 2.6 | 1e-07 | 12.5 |", shown)
        self.assertIn("| iiwa14 |  | no image |", shown)
        self.assertIn("| drawn | 2.6 | 1e-07 | 12.5, MISSED |", shown)
        self.assertIn("| openarm | 2.6 | 1e-07 | 12.5, refused where it left its limits |", shown)
        self.assertEqual(plant_tables.robots_provenance(self.folder), "Commit `c1`.\n")


class Gates(unittest.TestCase):
    def passes(self, gate=1e-5, **changes):
        return on_board.judged({**second("nrf51", "scara", "fixed32", "runge_kutta_4", 300.0), "made": True, **changes}, gate)["pass"]

    def test_words_have_the_hosts_bits(self):
        self.assertTrue(self.passes())
        self.assertFalse(self.passes(same_bits=False))
        self.assertTrue(self.passes(same_bits=False, scalar="float"), "which says its difference")

    def test_errors_and_drifts_have_gates(self):
        self.assertFalse(self.passes(error=1.1e-5))
        self.assertTrue(self.passes(error=1.0, gate=None))
        self.assertFalse(self.passes(energy_drift=1.1e-5, error=None))
        self.assertFalse(self.passes(made=False))


class Said(unittest.TestCase):
    def test_an_image_tells_states_and_counts(self):
        ran = on_board.Ran("plant,scara,nrf51\ncount,17\nstate,1,0000000a,ffffffff\ncount,18\nstate,2,0000000b,00000000\nsteps,2,17,18\nend\n")
        self.assertEqual(ran.states, [[1, [10, 0xffffffff]], [2, [11, 0]]])
        self.assertEqual((ran.counts, ran.made, ran.least, ran.most), ([17, 18], 2, 17, 18))


if __name__ == "__main__":
    unittest.main(verbosity=2)
