#!/usr/bin/python3
"""What decides which tests are run when: parts of sources, the essence, records. usage: depths_test.py"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cmake/testing"))
import heavy_sources_test  # noqa: E402
import passed_parts_test  # noqa: E402
import plan  # noqa: E402
import split  # noqa: E402

TEXT = """using Robots = testing::Types<A, B<1, 2>, C>;
TYPED_TEST_SUITE(Of, Robots);
TYPED_TEST_SUITE(Named, some::List, some::Name);
TYPED_TEST(Of, One) {
  if (x) {
  }
}
TEST(Other, Two) { EXPECT_EQ(1, 1); }
TEST_F(Other, Three) {
  y;
}
TEST(Other, Four) {}
int after;
"""


class Parts(unittest.TestCase):
    def test_each_plain_test_is_in_one_part(self):
        parts = [split.part_of(TEXT, part, 2) for part in range(2)]
        for name, part in {"Two": 0, "Three": 1, "Four": 0}.items():
            self.assertEqual([f" {name})" in text for text in parts], [part == 0, part == 1], name)

    def test_lines_keep_their_numbers(self):
        self.assertEqual({split.part_of(TEXT, part, 3).count("\n") for part in range(3)}, {TEXT.count("\n")})

    def test_typed_tests_are_in_all_parts_with_some_types(self):
        text = split.part_of(TEXT, 1, 2)
        self.assertIn("TYPED_TEST(Of, One)", text)
        self.assertIn("TYPED_TEST_SUITE(Of, split::Types<Robots>, split::Numbers);", text)
        self.assertIn("TYPED_TEST_SUITE(Named, split::Types<some::List>, some::Name);", text)


class Essence(unittest.TestCase):
    def test_every_folder_of_tests_is_in_it(self):
        patterns = plan.essence_patterns()
        folders = {path.parent.name for path in (ROOT / "tests").glob("*/CMakeLists.txt")} - {"reference"}
        named = {re.sub("^(un)?sanitized/", "", pattern).split(".")[0] for pattern in patterns}
        self.assertEqual(folders - named, set())
        self.assertIn("docs", named, "of the folder reference")

    def test_a_pattern_is_of_both_halves_unless_it_names_one(self):
        both, one = plan.Item("sanitized", "a.b_test"), plan.Item("unsanitized", "a.b_test")
        self.assertTrue(plan.is_essential(both, ["a.b*"]) and plan.is_essential(one, ["a.b*"]))
        self.assertFalse(plan.is_essential(one, ["sanitized/a.b_test"]))

    def test_parts_are_the_whole_and_cost_about_the_same(self):
        items = [plan.Item("sanitized", f"a.b{i}") for i in range(40)]
        parts = plan.parts_of(items, 4)
        self.assertCountEqual([item.key for part in parts for item in part], [item.key for item in items])
        self.assertEqual([len(part) for part in parts], [10] * 4)

    def test_an_image_that_one_names_is_built_where_another_needs_all(self):
        """All images of a board are those that a build without names makes, which leaves out some that tests name."""
        items = [plan.Item("unsanitized", "a.b", images=["nrf51"]), plan.Item("unsanitized", "a.c", images=["nrf51/plant", "rp2040/arm"])]
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(plan, "PLAN", pathlib.Path(folder)):
            plan.write_plan(items, argparse.Namespace(filter=None))
            told = {path.stem: path.read_text(encoding="utf-8").split() for path in pathlib.Path(folder).glob("*.images")}
        self.assertEqual(told, {"nrf51": ["all", "plant"], "rp2040": ["arm"]})

    def test_names_of_tests_are_read_from_sources(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "a_test.cpp")
            source.write_text(TEXT + "TEST_P(Many, Six) {}\nINSTANTIATE_TEST_SUITE_P(All, Many, x);\n", encoding="utf-8")
            names = set(plan.test_names(plan.Item("sanitized", "a.b_test", sources=[source])))
        self.assertLessEqual({"a.Of.One", "a.Other.Three", "a.All/Many.Six"}, names)


class Records(unittest.TestCase):
    def test_heavy_sources_are_told(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "compile_costs.txt")
            for name in "abcd":
                pathlib.Path(folder, name + ".o").touch()
            path.write_text("9e9 10 gone.o\n300.0 10 a.o\n1.0 2000 b.o\n1.0 10 c.o\n1.0 10 a.o\n200.0 10 d.o\n", encoding="utf-8")
            told = [line.split(":")[0].split("/")[1] for line in heavy_sources_test.heavy(pathlib.Path(folder))]
        self.assertEqual(told, ["b.o", "d.o"])

    def test_the_launcher_writes_and_passes_on_what_the_compiler_said(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "costs")
            done = subprocess.run([ROOT / "cmake/testing/compile_cost.py", path, "sh", "-c", "exit 3", "-o", "x.o"], check=False)
            self.assertEqual(done.returncode, 3)
            self.assertRegex(path.read_text(encoding="utf-8"), r"^\d+\.\d\d \d+ x\.o\n$")

    def test_parts_that_did_not_pass_are_told(self):
        head = passed_parts_test.git(ROOT, "rev-parse", "HEAD").stdout.strip()
        if not head:
            self.skipTest("no history")
        record = {"of": 2, "parts": {"1": head}}
        self.assertEqual(len(list(passed_parts_test.problems(ROOT, record, 2))), 1)
        record["parts"]["2"] = "0" * 40
        self.assertEqual(len(list(passed_parts_test.problems(ROOT, record, 2))), 1)
        self.assertEqual(len(list(passed_parts_test.problems(ROOT, json.loads(json.dumps(record)), 3))), 3)
        record["parts"]["2"] = head
        self.assertEqual(list(passed_parts_test.problems(ROOT, record, 2)), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
