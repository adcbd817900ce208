"""./axial compile-cost in its shortest form, what it refuses, and that doc/measurements/compile_cost.md shows the data beside it.

usage: compile_cost_test.py [unittest arguments]
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "host_sim/figures/compile_cost/compile_cost.py"
LARGE = ROOT / "host_sim/figures/compile_cost/large_robots.py"


def run(*arguments):
    return subprocess.run([sys.executable, "-E", "-B", PROGRAM, *arguments], capture_output=True, text=True)


# MiB of the costliest kernel, a twentieth above what it takes: unlike its seconds they do not depend on what else runs.
MOST_MEMORY = {"host-gcc-O2": 362, "host-clang-O2": 227}


class CompileCost(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_a_kernel_costs_more_than_its_headers(self):
        done = run("--build", "host-gcc-O2", "--robot", "puma560", "--number", "float,fixed32", "--kernel", "headers,forward_kinematics",
                   "--runs", "1", "--output", self.folder, "--json", self.folder / "rows.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        headers, *kernels = rows = json.loads((self.folder / "rows.json").read_text(encoding="utf-8"))
        self.assertEqual([(row["kernel"], row["number"]) for row in rows],
                         [("headers", "float"), ("forward_kinematics", "float"), ("forward_kinematics", "fixed32")])
        for figure in ("seconds", "memory_MiB"):
            self.assertLess(0, headers[figure])
            for kernel in kernels:
                self.assertLess(headers[figure], kernel[figure])
        self.assertEqual(rows, json.loads((self.folder / "compile_cost.json").read_text(encoding="utf-8")))

    def test_forward_dynamics_in_fixed_point_takes_no_more_memory_than_it_did(self):
        done = run("--build", ",".join(MOST_MEMORY), "--robot", "panda", "--number", "fixed32", "--kernel", "forward_dynamics",
                   "--runs", "1", "--output", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = json.loads((self.folder / "compile_cost.json").read_text(encoding="utf-8"))
        self.assertEqual([row["build"] for row in rows], list(MOST_MEMORY))
        for row in rows:
            with self.subTest(row["build"]):
                self.assertLess(row["memory_MiB"], MOST_MEMORY[row["build"]])

    def test_unknown_names_are_refused_with_those_that_there_are(self):
        done = run("--robot", "scara9", "--output", self.folder)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("unknown robot 'scara9'; there are: puma560, panda", done.stderr)

    def test_the_pages_show_the_data(self):
        for name in ("compile_cost", "compile_time"):
            page, shown = self.folder / "page.md", ROOT / f"doc/measurements/{name}.md"
            shutil.copy(shown, page)
            subprocess.run([sys.executable, "-E", "-B", ROOT / f"host_sim/figures/pages/{name}_tables.py", ROOT / "doc/data", page], check=True)
            self.assertEqual(page.read_text(encoding="utf-8"), shown.read_text(encoding="utf-8"))

    def test_large_robots_have_their_own_rows(self):
        done = subprocess.run([sys.executable, "-E", "-B", LARGE, "--build", "host-gcc-O2", "--robot", "serial6", "--form", "route,looped",
                               "--output", self.folder], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = json.loads((self.folder / "compile_time.json").read_text(encoding="utf-8"))
        self.assertEqual([(row["robot"], row["joints"], row["form"]) for row in rows], [("serial6", 6, "route"), ("serial6", 6, "looped")])
        self.assertLess(0, rows[0]["seconds"])


if __name__ == "__main__":
    unittest.main()
