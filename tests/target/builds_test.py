"""Kernels as a user compiles them who sets nothing but a level: as small and as quick at every level of GCC as at -O2, and at -O2 as
with our boards' flags. Limits are the promises of doc/guides/any_build.md.
"""

import functools
import sys
import unittest

import emulator

sys.path.insert(0, str(emulator.ROOT / "host_sim/boards/size"))
import builds  # noqa: E402

FEEDFORWARD, FORWARD, *INTEGERS = builds.KERNELS
LARGEST_FRAME, LARGEST_FRAME_UNOPTIMISED, LARGEST_FRAME_OF_INTEGERS = 700, 2000, 1000
MORE, MORE_UNOPTIMISED, MORE_THAN_OURS = 1.10, 3.0, 1.02


@functools.lru_cache
def row(kernel, level, users=False):
    return builds.row((kernel, builds.Build("gcc", level, users)))


class Float(unittest.TestCase):
    def test_optimised_levels_are_as_good_as_the_second(self):
        for kernel in (FEEDFORWARD, FORWARD):
            reference = row(kernel, "-O2")["instructions"]
            for level in ("-Og", "-O1", "-Os", "-O2"):
                with self.subTest(kernel.algorithm, level=level):
                    found = row(kernel, level)
                    self.assertLessEqual(found["frame_bytes"], LARGEST_FRAME)
                    self.assertLessEqual(found["instructions"], MORE * reference)

    def test_a_debug_build_runs(self):
        for kernel in (FEEDFORWARD, FORWARD):
            with self.subTest(kernel.algorithm):
                found = row(kernel, "-O0")
                self.assertLessEqual(found["frame_bytes"], LARGEST_FRAME_UNOPTIMISED)
                self.assertLessEqual(found["instructions"], MORE_UNOPTIMISED * row(kernel, "-O2")["instructions"])

    def test_nobody_needs_our_flags(self):
        for kernel in (FEEDFORWARD, FORWARD):
            with self.subTest(kernel.algorithm):
                self.assertLessEqual(row(kernel, "-O2")["instructions"], MORE_THAN_OURS * row(kernel, builds.OURS)["instructions"])

    def test_without_the_headers_options_it_would_not_be_so(self):
        """Negative control: AXIAL_USER_OPTIONS."""
        self.assertGreater(row(FORWARD, "-Og", True)["frame_bytes"], LARGEST_FRAME)
        self.assertGreater(row(FORWARD, "-O2", True)["instructions"], MORE_THAN_OURS * row(FORWARD, builds.OURS)["instructions"])


class Integers(unittest.TestCase):
    def test_the_smallest_core_has_the_stack_for_a_debug_build(self):
        for kernel in INTEGERS:
            with self.subTest(kernel.algorithm):
                self.assertLessEqual(row(kernel, "-Og")["frame_bytes"], LARGEST_FRAME_OF_INTEGERS)


if __name__ == "__main__":
    unittest.main(verbosity=2)
