"""What the test programs share: the board comes as the first argument."""

import sys
import unittest

ROBOTS = {"scara": 3, "scara_rrpr": 4, "puma560": 6, "panda": 7, "planar2r": 2}


class BoardTest(unittest.TestCase):
    board = None


def main():
    BoardTest.board = sys.argv.pop(1)
    unittest.main(verbosity=2)
