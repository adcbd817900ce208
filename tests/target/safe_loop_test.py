"""Gravity compensation and tracking on a board: the host's bits, one instruction count for all good ticks, fewer for refused
ones, and the counts that doc/guides/gravity_compensation.md and drive_commands.md state.

usage: safe_loop_test.py BOARD HOST_PROGRAM
"""

import pathlib
import re
import subprocess
import sys

import emulator
import harness
import symbols_test

HOST = sys.argv.pop(2)
GUIDES = pathlib.Path(__file__).resolve().parents[2] / "doc/guides"
LOOP, DRIVES = GUIDES / "gravity_compensation.md", GUIDES / "drive_commands.md"
ROBOTS = ("scara", "puma560", "panda")
SLACK = 1.02  # another release of a compiler may count a little more or less


def host_fields(image):
    lines = subprocess.run([HOST], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    return {fields[0]: fields[1:] for fields in (line.split(",") for line in lines)}[image]


def stated(page, board, robot):
    """Counts of a page: gravity compensation, tracking; or limited currents, told positions."""
    row = re.search(rf"^\| {robot}, {board} \|(.*)\|$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return [int(cell.replace(" ", "")) for cell in row[1].split("|")]


class SafeLoop(harness.BoardTest):
    def name(self, robot):
        return f"safe-loop{'' if self.board == 'stm32f405' else '-fixed'}-{robot}"

    def run_robot(self, robot):
        code, text = emulator.run(self.board, self.name(robot))
        self.assertEqual(code, 0, text[-500:])
        self.assertTrue(text.endswith("end\n"), text[-500:])
        fields = text.splitlines()[0].split(",")
        self.assertEqual(fields[:2], ["safe_loop", robot])
        self.assertEqual(fields[2:5], host_fields(self.name(robot)))
        return [int(field) for field in fields[3:]]

    def test_bits_and_counts(self):
        for robot in ROBOTS:
            with self.subTest(robot):
                met, refused, least_gravity, gravity, least_tracking, tracking, _, bad, *drives = self.run_robot(robot)
                self.assertEqual((met, refused), (133, 67))
                self.assertGreater(least_gravity, 100, "it cannot be that few")
                self.assertEqual(least_gravity, gravity, "one count for all good positions")
                self.assertEqual(least_tracking, tracking, "one count for all good ticks")
                self.assertLess(bad, tracking, "a refused tick takes less")
                print(f"{robot} on {self.board}: {gravity} instructions carry the arm, {tracking} track")
                self.assertEqual(len(drives), 4 if self.board == "stm32f405" else 0)
                self.assertEqual(drives[0::2], drives[1::2], "one count for whatever windings and commands do")
                self.expect_near((gravity, tracking), stated(LOOP, self.board, robot))
                if drives:
                    print(f"{robot} on {self.board}: {drives[0]} limit currents, {drives[2]} tell servos their positions")
                    self.expect_near(drives[0::2], stated(DRIVES, self.board, robot))

    def expect_near(self, counts, pages):
        for counted, written in zip(counts, pages, strict=True):
            self.assertLessEqual(counted, written * SLACK)
            self.assertGreaterEqual(counted * SLACK, written)

    def test_nothing_forbidden_is_linked(self):
        for robot in ROBOTS:
            symbols = symbols_test.defined(emulator.image(self.board, self.name(robot)))
            for what, pattern in symbols_test.FORBIDDEN.items():
                with self.subTest(robot, what=what):
                    self.assertEqual(symbols_test.offenders(symbols, pattern), [])
            self.assertEqual(symbols_test.offenders(symbols, symbols_test.SOFT_DOUBLE), [])
            self.assertEqual(symbols_test.offenders(symbols, symbols_test.SOFT_FLOAT), [])


if __name__ == "__main__":
    harness.main()
