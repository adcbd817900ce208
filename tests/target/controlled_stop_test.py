"""Controlled stops from full speed on a board: the host's bits, whose efforts bring a plant to rest inside its limits
(tests/property/control/controlled_stop_test.cpp), and one instruction count for all ticks of braking. A broken wire of a sine or a cosine: the
drives are disabled after patience, ramp and hold, whichever way it broke.

usage: controlled_stop_test.py BOARD HOST_PROGRAM
"""

import subprocess
import sys

import emulator
import harness

HOST = sys.argv.pop(2)


class ControlledStop(harness.BoardTest):
    def test_bits_and_counts(self):
        lines = subprocess.run([HOST], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        host = {fields[0]: fields[1:] for fields in (line.split(",") for line in lines)}
        for robot in "scara", "puma560":
            name = f"controlled-stop{'' if self.board == 'stm32f405' else '-fixed'}-{robot}"
            with self.subTest(robot):
                code, text = emulator.run(self.board, name)
                self.assertEqual(code, 0, text[-500:])
                self.assertTrue(text.endswith("end\n"), text[-500:])
                kind, of, *bits, least, most = text.splitlines()[0].split(",")
                self.assertEqual((kind, of, bits), ("controlled_stop", robot, host[name]))
                self.assertGreater(int(least), 100, "it cannot be that few")
                self.assertEqual(least, most, "one count for all ticks of braking")
                kind, of, *broken = text.splitlines()[1].split(",")
                self.assertEqual((kind, of, broken), ("broken_pair", robot, host[name.replace("controlled-stop", "broken-pair")]))
                self.assertEqual(broken[1:], ["254", "254", "1"], "patience + ramp + hold from the last good tick, refused from the break on")
                print(f"{robot} on {self.board}: {most} instructions a tick of braking, at rest after {bits[1]} ticks")


if __name__ == "__main__":
    harness.main()
