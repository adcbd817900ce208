"""The kernels image prints what its README says: every kernel, every state, a count and the right number of values."""

import collections
import math
import struct

import emulator
import harness

STATES = 32


def values_of(kernel, n):
    if kernel.endswith("_derivatives"):
        return n * (5 * n + 3) // 2
    return {"mass_matrix": n * (n + 1) // 2, "forward_kinematics": 12, "jacobian": 6 * n}.get(kernel, n)


class Kernels(harness.BoardTest):
    printed = {}  # each image is run once

    def rows(self, robot):
        if robot not in self.printed:
            code, text = emulator.run(self.board, "kernels-" + robot)
            self.assertEqual(code, 0, text[-500:])
            self.assertTrue(text.endswith("end\n"), "the run is whole")
            self.printed[robot] = [line.split(",") for line in text.splitlines()]
        return self.printed[robot]

    def test_rows(self):
        for robot, n in harness.ROBOTS.items():
            with self.subTest(robot):
                seen = collections.Counter()
                counts = collections.defaultdict(set)
                for row in self.rows(robot):
                    if len(row) < 5 or row[0] in ("state", "board", "range"):
                        continue
                    kernel, name, scalar, _, count, *bits = row
                    self.assertEqual(name, robot)
                    self.assertGreater(int(count), 0)
                    self.assertEqual(len(bits), values_of(kernel, n), kernel)
                    letter = {"float": ">f", "double": ">d"}[scalar]
                    for value in bits:
                        self.assertTrue(math.isfinite(struct.unpack(letter, bytes.fromhex(value))[0]), row)
                    seen[kernel, scalar] += 1
                    counts[kernel, scalar].add(int(count))
                self.assertEqual(set(seen.values()), {STATES})
                self.assertGreaterEqual(len(seen), 8)
                self.check_constant_time(counts)

    def test_one_count_for_every_input(self):
        """In hard float each kernel costs the same for 10 000 states, corners of float among them; in soft float, whose
        routines branch on data, it does not: the same comparison tells them apart."""
        hard = self.board == "stm32f405"
        for robot in harness.ROBOTS:
            ranges = [row[1:2] + list(map(int, row[3:])) for row in self.rows(robot) if row[0] == "range"]
            self.assertGreaterEqual(len({kernel for kernel, *_ in ranges}), 8 + 2, "kernels and the other routes")
            self.assertGreaterEqual(min(states for _, states, _, _ in ranges), 10000 if hard else 500)
            varying = [kernel for kernel, _, least, most in ranges if least != most]
            constant = {kernel for kernel, *_ in ranges} - set(varying)
            with self.subTest(robot):
                if hard:
                    self.assertEqual(varying, [])
                else:
                    self.assertLessEqual(constant, {"gravity"}, "only a SCARA's gravity is free of arithmetic")

    def check_constant_time(self, counts):
        """No branch depends on data: one count for all states. Library routines of soft arithmetic do branch on data."""
        hard = {"float"} if self.board == "stm32f405" else set()
        for (kernel, scalar), seen in counts.items():
            if scalar in hard:
                self.assertEqual(len(seen), 1, f"{kernel}: {sorted(seen)}")


if __name__ == "__main__":
    harness.main()
