"""Joints that stick and that meet end stops, in words, on a board: the host's bits (whose motion
tests/simulation/held_words_test.cpp checks), and one instruction count for all states.

usage: held_test.py BOARD HOST_PROGRAM
"""

import subprocess
import sys

import emulator
import harness

HOST = sys.argv.pop(2)


class Held(harness.BoardTest):
    def test_bits_and_counts(self):
        lines = subprocess.run([HOST], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        host = {fields[0]: fields[1:] for fields in (line.split(",") for line in lines)}
        for robot in "scara", "puma560":
            with self.subTest(robot):
                code, text = emulator.run(self.board, f"held-{robot}")
                self.assertEqual(code, 0, text[-500:])
                self.assertTrue(text.endswith("end\n"), text[-500:])
                kind, of, *bits, least, most = text.splitlines()[0].split(",")
                self.assertEqual((kind, of, bits), ("held", robot, host[f"held-{robot}"]))
                self.assertGreater(min(map(int, bits[1:])), 20, "joints that stick, and that are stopped")
                self.assertGreater(int(least), 100, "it cannot be that few")
                self.assertEqual(least, most, "one count for all states")
                print(f"{robot} on {self.board}: {most} instructions a step, {bits[1]} joints at rest, {bits[2]} at a limit")


if __name__ == "__main__":
    harness.main()
