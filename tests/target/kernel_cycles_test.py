"""Kernels of `./axial size` on a board whose emulator counts cycles: equal to the core's table; with code in RAM nothing waits for flash."""

import struct
import sys
import unittest
from unittest import mock

import emulator
import harness

sys.path[:0] = [str(emulator.ROOT / "host_sim/boards" / folder) for folder in ("size", "timing")]
import cortex_m0  # noqa: E402
import execution  # noqa: E402
import measure  # noqa: E402

PROMISED = 9200  # cycles of the Puma's torque in fixed point


IMAGES = {"rp2040": ("puma560-%s", "puma560-%s-fixed32", "scara-%s-double"), "rp2040_ram": ("puma560-%s", "puma560-%s-fixed32")}
KERNEL = "bare-inverse_dynamics-unrolled-off"


class KernelCycles(harness.BoardTest):
    """Of a few probes, those that cmake/driver/build.sh builds; ./axial size --board rp2040 judges all."""

    @classmethod
    def setUpClass(cls):
        chosen = [name % KERNEL for name in IMAGES[cls.board]]
        cls.figures = {probe.name: measure.Figures(cls.board, probe) for probe in measure.probes(cls.board) if probe.name in chosen}

    def figure(self, ending=""):
        return self.figures[f"puma560-{KERNEL}{ending}"]

    def test_kernels_take_what_the_emulator_counts(self):
        """Figures are refused where they do not."""
        self.assertEqual(len(self.figures), len(IMAGES[self.board]))
        self.assertLessEqual(self.figure("-fixed32").row()["cycles"], PROMISED)
        self.assertGreater(self.figure().row()["cycles"], self.figure("-fixed32").row()["cycles"])

    def test_another_table_is_refused(self):
        """Negative control: multiplications of two cycles, as if the core had the slow multiplier."""
        cost = cortex_m0.cost
        slow = lambda table, instruction, taken: cost(table, instruction, taken) + (instruction.name == "muls")
        with mock.patch.object(cortex_m0, "cost", slow), self.assertRaisesRegex(execution.Mismatch, "cycles by the table"):
            measure.Figures(self.board, self.figure("-fixed32").probe)

    def test_only_code_in_flash_may_wait_for_it(self):
        timing, in_ram = self.figure("-fixed32").timing, self.board.endswith("_ram")
        self.assertEqual(timing.high == timing.low, in_ram)
        self.assertEqual(any(address >> 24 == 0x10 for run in self.figure().runs for address in run.accesses), not in_ram)

    def test_a_copy_in_ram_is_told(self):
        row = self.figure("-fixed32").row()
        self.assertEqual(row["ram_bytes"], row["flash_bytes"] if self.board.endswith("_ram") else 0)


class Log(unittest.TestCase):
    """What the runner writes: cycles, those of the return, words."""

    def log(self, *words):
        return struct.pack(f"<{len(words)}I", *words)

    def test_a_call_is_instructions_and_words_of_flash(self):
        run, = execution.runs_of("x", self.log(7, 3, 4, 0x10000000, 0x20000002, 0x10000011, 0x20000004), [8])
        self.assertEqual(run, execution.Run(2, [0x10000000, 0x20000002, 0x20000004], [0x10000000, 0x20000002, 0x10000010, 0x20000004], 7))

    def test_cycles_that_the_board_did_not_count_are_refused(self):
        for counted in ([7], [], [8, 8]):
            with self.assertRaises(execution.Mismatch):
                list(execution.runs_of("x", self.log(7, 3, 1, 0x10000000), counted))


if __name__ == "__main__":
    harness.main()
