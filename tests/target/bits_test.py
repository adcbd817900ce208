"""A board computes the bits that the Cortex-M4F computes: every kernel, float and double, by FPU or by a library."""

import emulator
import harness

REFERENCE = "stm32f405"


def results(board, robot):
    """{(kernel, scalar, state): bits}"""
    code, text = emulator.run(board, "kernels-" + robot)
    assert code == 0 and text.endswith("end\n"), text[-500:]
    rows = (line.split(",") for line in text.splitlines())
    return {(row[0], row[2], row[3]): row[5:] for row in rows if len(row) > 5 and row[0] not in ("state", "range")}


class Bits(harness.BoardTest):
    def test_same_bits(self):
        for robot in ("scara",) if self.board in harness.FEW_IMAGES else ("scara", "puma560"):
            with self.subTest(robot):
                wanted, found = results(REFERENCE, robot), results(self.board, robot)
                self.assertGreaterEqual(len(found), 8 * 32)
                self.assertEqual([name for name, bits in found.items() if bits != wanted[name]], [])


if __name__ == "__main__":
    harness.main()
