#!/usr/bin/python3
"""The runner tells a mutant that is killed from one that survives, and a table that does not fit from one that does."""

import contextlib
import io
import pathlib
import re
import tempfile
import unittest
import unittest.mock

import drawn
import drawn_run
import mutants
import programs
import reach
import table
import trim

SOURCE = "hal/ring.hpp"
TEST = "hal/ring_test.cpp"


def entry(**changes):
    text = (table.ROOT / SOURCE).read_text()
    line = next(line for line in text.splitlines() if "namespace" in line)
    fields = dict(file=SOURCE, old=line, new=line + " ", test=TEST, breaks="nothing")
    return table.mutant_of("table.name", {**fields, **changes}, table.ROOT)


def killers(*chosen):
    rows = []
    with contextlib.redirect_stdout(io.StringIO()):
        mutants.run_all(list(chosen), 1, rows)
    return {row["mutant"]: row["killed_by"] for row in rows}


class Table(unittest.TestCase):
    def test_text_that_is_not_there_is_told(self):
        self.assertIn("occurs 0 times", table.stale([entry(old="no such text")])[0])

    def test_text_that_is_there_twice_is_told(self):
        self.assertIn("not once", table.stale([entry(old="\n", new="\n\n")])[0])

    def test_a_test_that_is_not_there_is_told(self):
        self.assertIn("knows no Rong", table.stale([entry(filter="Rong.*")])[0])

    def test_a_change_of_nothing_is_refused(self):
        with self.assertRaises(table.TableError):
            entry(old="a", new="a")

    def test_an_unknown_field_is_refused(self):
        with self.assertRaises(table.TableError):
            entry(teste="")

    def test_parts_are_the_whole(self):
        whole = table.read()
        parts = [table.part(whole, k, 10) for k in range(1, 11)]
        self.assertCountEqual([mutant.name for part in parts for mutant in part], [mutant.name for mutant in whole])
        self.assertLessEqual(max(map(len, parts)) - min(map(len, parts)), 1)

    def test_drawn_ones_apply_and_are_the_same_for_a_seed(self):
        some = drawn.draw(40, 1)
        self.assertEqual([mutant for mutant in some if (table.ROOT / mutant.file).read_text().count(mutant.old) != 1], [])
        self.assertEqual(len({mutant.breaks for mutant in some}), 40)
        self.assertEqual([m.new for m in some], [m.new for m in drawn.draw(40, 1)])
        self.assertNotEqual([m.new for m in some], [m.new for m in drawn.draw(40, 2)])

    def test_operators_change_what_they_name(self):
        line = "if (a < b) return x + larger(c, 2.0) * d;"
        made = {name: [line[:m.start()] + instead(m) + line[m.end():] for m in re.finditer(pattern, line)]
                for name, pattern, instead in drawn.OPERATORS}
        self.assertIn("if (a > b) return x + larger(c, 2.0) * d;", made["comparison turned"])
        self.assertIn("if (false && a < b) return x + larger(c, 2.0) * d;", made["check removed"])
        self.assertIn("if (a < b) return x - larger(c, 2.0) * d;", made["sign turned"])
        self.assertIn("if (a < b) return x + smaller(c, 2.0) * d;", made["minimum for maximum"])
        self.assertIn("if (a < b) return x + larger(c, 2.0);", made["factor dropped"])
        self.assertIn("if (a < b) return x + larger(c, 4.0) * d;", made["constant doubled"])

    def test_parts_share_few_tests(self):
        whole = table.read()
        tests = [{mutant.test for mutant in table.part(whole, k, 10)} for k in range(1, 11)]
        self.assertLessEqual(sum(map(len, tests)), len(set.union(*tests)) + 9)


class Trim(unittest.TestCase):
    TEXT = """using Robots = testing::Types<A, B>;
TYPED_TEST_SUITE(Of, Robots);
TYPED_TEST(Of, One) {
  if (x) {
  }
}
TEST(Other, Two) { EXPECT_EQ(1, 1); }
TEST_F(Other, Three) {
  y;
}
int after;
"""

    def kept(self, tests):
        return [name for name in ("One", "Two", "Three", "after") if name in trim.only_tests(self.TEXT, tests)]

    def test_what_a_filter_selects_is_kept(self):
        self.assertEqual(self.kept("Other.Two"), ["Two", "after"])
        self.assertEqual(self.kept("Other.T*"), ["Two", "Three", "after"])
        self.assertEqual(self.kept("Of/*:*.Three"), ["One", "Three", "after"])

    def test_without_a_filter_or_with_one_that_excludes_all_is_kept(self):
        for tests in ("", "-Other.Two", "Other.???"):
            self.assertEqual(trim.trimmed(self.TEXT, tests), (self.TEXT, tests))

    def test_a_type_that_is_named_is_the_only_one(self):
        text, tests = trim.trimmed(self.TEXT, "Of/1.One")
        self.assertEqual(tests, "Of/0.One")
        self.assertIn("TYPED_TEST_SUITE(Of, OnlyType<Robots>::type);", text)
        self.assertIn("std::tuple_element_t<1,", text)
        self.assertNotIn("Two", text)


class Runner(unittest.TestCase):
    def test_a_change_that_no_test_sees_survives(self):
        self.assertEqual(killers(entry()), {"table.name": ""})

    def test_a_change_that_a_test_sees_is_killed_and_the_sources_stay(self):
        before = (table.ROOT / SOURCE).read_text()
        killed = killers(entry(old=">= capacity", new="> capacity"))
        self.assertTrue(killed["table.name"].startswith("Ring."), killed)
        self.assertEqual((table.ROOT / SOURCE).read_text(), before)

    def test_a_test_that_its_filter_selects_kills(self):
        killed = killers(entry(old=">= capacity", new="> capacity", filter="Ring.*"))
        self.assertTrue(killed["table.name"].startswith("Ring."), killed)

    def test_a_killer_on_record_that_cannot_be_found_is_forgotten(self):
        with unittest.mock.patch.object(mutants, "known_killers", lambda: {"table.name": "Round.HoldsItsCapacityAndRefusesMore"}):
            killed = killers(entry(old=">= capacity", new="> capacity"))
        self.assertTrue(killed["table.name"].startswith("Ring."), killed)

    def test_a_change_that_does_not_compile_is_no_kill(self):
        with self.assertRaises(table.TableError):
            killers(entry(new="namespace ("))

    def test_a_test_that_does_not_see_the_file_is_told(self):
        with self.assertRaises(table.TableError):
            killers(entry(test="hal/link/crc32_test.cpp"))


class Drawn(unittest.TestCase):
    """In a folder below the build's, for the sources are read from the project."""

    @classmethod
    def setUpClass(cls):
        place = table.ROOT / "build"
        place.mkdir(exist_ok=True)
        folder = tempfile.TemporaryDirectory(prefix="mutants-", dir=place)
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    def judged(self, *changes):
        with contextlib.redirect_stdout(io.StringIO()):
            return drawn_run.run(list(changes), 1, table.read(), {}, drawn_run.Verdicts(self.folder / "verdicts.json"), seconds=0, folder=self.folder)

    def change(self, old, new):
        line = (table.ROOT / SOURCE).read_text().split(old)[0].count("\n")
        return entry(old=old, new=new, filter=str(line), breaks=f"{old} is {new}")

    def test_a_change_is_tried_until_a_test_notices_it_and_judged_once(self):
        changes = self.change(">= capacity", "> capacity"), self.change("#pragma once", "#pragma once ")
        killed, alive = self.judged(*changes)
        self.assertTrue(killed["killed_by"].startswith("Ring."), killed)
        self.assertEqual((alive["killed_by"], len(alive["tried"])), ("", 1))
        with unittest.mock.patch.object(drawn_run, "DrawnRun", None):
            self.assertEqual(self.judged(*changes), [killed, alive])

    def test_programs_are_those_of_cmake(self):
        known = programs.CMakePrograms(self.folder / "cmake")
        self.assertTrue(reach.is_read_by(known, "host_sim/plants/collide_test.cpp", "host_sim/plants/collide/collide.cpp"))
        self.assertFalse(reach.is_read_by(known, TEST, "host_sim/plants/collide/collide.cpp"))
        first = reach.Reach(known, [], {}).attempts(SOURCE, 1)[0]
        self.assertEqual(first[0], TEST)


if __name__ == "__main__":
    unittest.main()
