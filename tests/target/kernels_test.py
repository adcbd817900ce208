"""The kernels image prints what its README says: every kernel, every state, a count and the right number of values."""

import collections
import math
import struct

import emulator
import harness

STATES = 32


def values_of(kernel, n):
    return {"mass_matrix": n * (n + 1) // 2, "forward_kinematics": 12, "jacobian": 6 * n}.get(kernel, n)


class Kernels(harness.BoardTest):
    def rows(self, robot):
        code, text = emulator.run(self.board, "kernels-" + robot)
        self.assertEqual(code, 0, text[-500:])
        self.assertTrue(text.endswith("end\n"), "the run is whole")
        return [line.split(",") for line in text.splitlines()]

    def test_rows(self):
        for robot, n in harness.ROBOTS.items():
            with self.subTest(robot):
                seen = collections.Counter()
                counts = collections.defaultdict(set)
                for row in self.rows(robot):
                    if len(row) < 5 or row[0] in ("state", "board"):
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
                self.assertGreaterEqual(len(seen), 7)
                self.check_constant_time(counts)

    def check_constant_time(self, counts):
        """No branch depends on data: one count for all states. Library routines of soft arithmetic do branch on data."""
        hard = {"float"} if self.board == "stm32f405" else set()
        for (kernel, scalar), seen in counts.items():
            if scalar in hard:
                self.assertEqual(len(seen), 1, f"{kernel}: {sorted(seen)}")


if __name__ == "__main__":
    harness.main()
