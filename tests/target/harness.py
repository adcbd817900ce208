"""What the test programs share: the board comes as the first argument."""

import sys
import unittest

import emulator

SKIPPED = 77
FEW_IMAGES = {"rp2040": ("scara", "puma560"), "rp2040_ram": ("scara",), "rp2350_riscv": ("scara", "puma560")}  # the others are not built for tests
ROBOTS = {"scara": 3, "scara_rrpr": 4, "puma560": 6, "panda": 7, "planar2r": 2}


class BoardTest(unittest.TestCase):
    board = None


def robots(board):
    """Robots that have images there, with their joints."""
    return {name: joints for name, joints in ROBOTS.items() if name in FEW_IMAGES.get(board, ROBOTS)}


def main():
    BoardTest.board = sys.argv.pop(1)
    if not emulator.runs_here(BoardTest.board):
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
