"""./axial same-code: what it calls the same, what it does not, and what it refuses.

usage: same_code_test.py [unittest arguments]
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/boards/size"))
import same_code

KERNEL = "dynamics/inverse_dynamics.hpp"


class SameCode(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def before(self, **edits):
        """A copy of headers and robots in which texts of files are others."""
        tree = self.folder / "before"
        shutil.copytree(ROOT / "firmware/include", tree / "firmware/include")
        shutil.copytree(ROOT / "robots", tree / "robots")
        for path in tree.rglob("*.hpp"):
            text = path.read_text(encoding="utf-8")
            changed = re.sub(edits["old"], edits["new"], text) if re.search(edits.get("files", ""), str(path)) else text
            if changed != text:
                path.write_text(changed, encoding="utf-8")
        return tree

    def run_on(self, before, build="stm32f405,host-clang-O2", kernel="inverse_dynamics,gravity_torque"):
        done = subprocess.run([sys.executable, "-E", "-B", ROOT / "host_sim/boards/size/same_code.py", before, "--scene", "scara", "--number", "float",
                               "--build", build, "--kernel", kernel, "--json", self.folder / "rows.json"], capture_output=True, text=True)
        return done, json.loads((self.folder / "rows.json").read_text(encoding="utf-8")) if done.returncode < 2 else []

    def test_names_and_comments_are_no_code(self):
        done, rows = self.run_on(self.before(old=r"\bpropagate_inward\b", new="carry_to_the_base"))
        self.assertEqual((done.returncode, [row["same"] for row in rows]), (0, [True] * 4), done.stdout + done.stderr)
        self.assertIn("4 of 4 kernels have the same machine code", done.stdout)

    def test_one_constant_is_seen(self):
        done, rows = self.run_on(self.before(files="robots/scara.hpp", old=r"m3 = 1\.25;", new="m3 = 1.375;"))
        self.assertEqual(done.returncode, 1)
        self.assertEqual({row["kernel"] for row in rows if not row["same"]}, {"inverse_dynamics", "gravity_torque"})
        self.assertRegex(done.stdout, r"scara +float +stm32f405 +inverse_dynamics +fails +\d+ +\d+")

    def test_options_that_keep_kernels_from_being_inlined_are_seen(self):
        done, rows = self.run_on(self.before(files="options/begin.hpp", old='"rename-registers"\\)', new='"rename-registers", "no-finite-math-only")'),
                                 build="stm32f405", kernel="inverse_dynamics")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertLess(rows[0]["after"], rows[0]["before"])

    def test_a_kernel_that_is_not_there_is_named(self):
        done, rows = self.run_on(self.before(old=r"\bgravity_torque\b", new="weight_torque"), build="stm32f405")
        self.assertEqual(done.returncode, 1)
        self.assertEqual([bool(row["problem"]) for row in rows], [False, True])
        self.assertRegex(rows[1]["problem"], "^kernels.cpp:.*gravity_torque")

    def test_joints_that_share_drives_may_take_less(self):
        row = {"scene": "wrist_arm", "problem": "", "same": False, "before": 100, "after": 99}
        self.assertFalse(same_code.fails(row))
        self.assertTrue(same_code.fails({**row, "after": 101}))
        self.assertTrue(same_code.fails({**row, "scene": "scara"}))

    def test_what_is_unknown_is_refused(self):
        for word, said in (("no-such-revision", "no revision"), ("--scene=arm9", "unknown scene 'arm9'; there are: puma560")):
            done = subprocess.run([sys.executable, "-E", "-B", ROOT / "host_sim/boards/size/same_code.py", word, *(["HEAD"] if "=" in word else [])],
                                  capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
