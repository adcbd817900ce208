"""The momentum observer and the payload estimator on a board: the host's bits, one instruction count for all samples, no double, no heap.

usage: observer_test.py BOARD IMAGE HOST_PROGRAM
"""

import subprocess
import sys

import emulator
import harness
import symbols_test

IMAGE, HOST = sys.argv.pop(2), sys.argv.pop(2)


def host_fields(name):
    lines = subprocess.run([HOST], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    return {fields[0]: fields[1:] for fields in (line.split(",") for line in lines)}[name]


class Observer(harness.BoardTest):
    def test_bits_and_constant_time(self):
        code, text = emulator.run(self.board, IMAGE)
        self.assertEqual(code, 0, text[-500:])
        self.assertTrue(text.endswith("end\n"), text[-500:])
        _, robot, bits, refused, collisions, least, most = text.splitlines()[0].split(",")
        self.assertEqual([bits, refused, collisions], host_fields(IMAGE))
        self.assertEqual(robot, "panda")
        self.assertEqual(int(refused), 0, "all samples are inside the limits")
        self.assertGreater(int(collisions), 100, "samples anywhere inside the limits are no motion")
        self.assertGreater(int(least), 1000, "it cannot be that few")
        self.assertEqual(least, most, "one count for all samples")
        print(f"{IMAGE} on {self.board}: {most} instructions per sample")
        self.expect_weighing(text.splitlines()[1].split(","))

    def expect_weighing(self, fields):
        name, robot, bits, ready, least, most, least_estimate, most_estimate = fields
        self.assertEqual([name, robot], ["weighing", "panda"])
        self.assertEqual([bits, ready], host_fields(f"{IMAGE}-weighing"))
        self.assertGreater(int(least), 1000, "it cannot be that few")
        self.assertEqual(least, most, "one count for all samples")
        self.assertEqual(least_estimate, most_estimate, "one count for all estimates")
        print(f"{IMAGE} on {self.board}: {most} instructions per sample weighed, {most_estimate} an estimate")

    def test_nothing_forbidden_is_linked(self):
        symbols = symbols_test.defined(emulator.image(self.board, IMAGE))
        for what, pattern in symbols_test.FORBIDDEN.items():
            with self.subTest(what=what):
                self.assertEqual(symbols_test.offenders(symbols, pattern), [])
        self.assertEqual(symbols_test.offenders(symbols, symbols_test.SOFT_DOUBLE), [])
        self.assertEqual(symbols_test.offenders(symbols, symbols_test.SOFT_FLOAT), [])


if __name__ == "__main__":
    harness.main()
