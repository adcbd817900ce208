#!/usr/bin/python3
"""Holds the covering array to its pairs, and the checker to seeing what it has to see."""
import pathlib
import unittest

import check
import covering
import factors
import refusals


class FakeBuilder:
    """Answers what it is told to, as a compiler and a program would."""
    compiler = "gcc"

    def __init__(self, says="", prints=""):
        self.says, self.prints = says, prints

    def compile(self, *_):
        return self.says, pathlib.Path()

    def run(self, *_):
        return self.prints


class Array(unittest.TestCase):
    def test_every_pair_that_is_not_refused_occurs(self):
        possible, impossible = covering.possible_pairs(factors.FACTORS, refusals.is_refused)
        rows = check.combinations()
        covered = set().union(*(covering.pairs_of(row, list(factors.FACTORS)) for row in rows))
        self.assertEqual(possible - covered, set())
        self.assertEqual(impossible & covered, set())
        self.assertFalse([row for row in rows if refusals.is_refused(row)])

    def test_the_array_is_the_same_each_time(self):
        self.assertEqual(check.combinations(), check.combinations.__wrapped__())

    def test_every_algorithm_meets_every_value_that_it_is_offered_for(self):
        met = {meeting for row in check.combinations() for meeting in check.meetings(row)}
        for factor, values in factors.FACTORS.items():
            for value in values:
                row = {**factors.DEFAULT, factor: value}
                if not refusals.is_refused(row):
                    self.assertEqual(check.meetings(row, factor) - met, set())


class Refusals(unittest.TestCase):
    def test_each_is_witnessed_by_a_program_that_nothing_else_refuses(self):
        self.assertEqual({refusal.sentence for refusal, _, _ in check.witnesses()}, {r.sentence for r in refusals.REFUSALS})

    def test_each_says_what_to_do_instead(self):
        for refusal in refusals.REFUSALS:
            self.assertRegex(refusal.sentence, r"^axial: .*[;,:] |^axial: .*(takes|add) ")

    def test_the_defaults_are_refused_nothing_but_the_closed_form(self):
        for algorithm in refusals.ALGORITHMS[:-1]:
            if refusals.is_asked(factors.DEFAULT, algorithm) and algorithm != "ClosedForm":
                self.assertEqual(refusals.refusals_of(factors.DEFAULT, algorithm), [])


class Checker(unittest.TestCase):
    refusal = refusals.REFUSALS[0]

    def passed(self, builder):
        return check.check_refusal(builder, 0, self.refusal, dict(factors.DEFAULT), "InverseDynamics")[0]["passed"]

    def test_a_refusal_is_its_sentence_in_the_first_error(self):
        said = f"x.hpp:1:2: error: static assertion failed: {self.refusal.sentence}\n"
        self.assertTrue(self.passed(FakeBuilder("x.cpp: In instantiation\n" + said)))
        self.assertFalse(self.passed(FakeBuilder("x.hpp:1:1: error: something else\n" + said)))
        self.assertFalse(self.passed(FakeBuilder("")))

    def test_a_combination_fails_where_its_program_says_so(self):
        names = refusals.offered(factors.DEFAULT)
        outcomes = check.check_combination(FakeBuilder("", f"bias 0: 1, not 2\nfailed: {names[2]}\n"), 0, dict(factors.DEFAULT))
        self.assertEqual([o["algorithm"] for o in outcomes if not o["passed"]], [names[2]])
        outcomes = check.check_combination(FakeBuilder("", "ended by signal 6\n"), 0, dict(factors.DEFAULT))
        self.assertFalse([o for o in outcomes if o["passed"]])

    def test_a_combination_that_does_not_compile_is_tried_an_algorithm_at_a_time(self):
        outcomes = check.check_combination(FakeBuilder("a.hpp:1:1: error: no\n"), 0, dict(factors.DEFAULT))
        self.assertEqual({o["message"] for o in outcomes}, {"no"})
        self.assertEqual(len(outcomes), len(refusals.offered(factors.DEFAULT)))


if __name__ == "__main__":
    unittest.main()
