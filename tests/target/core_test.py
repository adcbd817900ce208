"""A core in an emulator without any peripheral: what the self-tests say of its instruments and of the dynamics, and what its boot ROM will find."""

import struct
import sys

import emulator
import harness
import selftest_test

sys.path[:0] = [str(emulator.ROOT / "host_sim/boards" / folder) for folder in ("size", "timing")]
import image  # noqa: E402
import measure  # noqa: E402

TICK = ["10 ms hold 10 ticks of 1 kHz, less one where the first is cut", "the control tick keeps its pace while code is measured"]
RAM, FLASH = 0x20000000, 0x10000000
# RP2350 Datasheet 5.9.5.1, with the item that names the entry and the stack.
BLOCK = (0xFFFFDED3, 0x11010142, 0x00000344, FLASH + 32, RAM + 520 * 1024, 0x000004FF, 0, 0xAB123579)


class Core(selftest_test.SelfTest):
    def test_1_instruments(self):
        """The emulator has no timer, so that nothing else may fail but the tick."""
        code, text = emulator.run(self.board, "selftest")
        self.assertEqual(code, 1, text)
        self.assertEqual([line.removeprefix("FAILED ") for line in text.splitlines() if line.startswith("FAILED")], TICK)
        self.assertRegex(text, r"\n[4-9]\d checks, 2 failed\n")

    def test_the_boot_rom_finds_its_block_and_the_entry_behind_it(self):
        boot, = (part for part in image.sections(emulator.image(self.board, "selftest")) if part.name == ".boot")
        bytes_of_file = emulator.image(self.board, "selftest").read_bytes()
        self.assertEqual(boot.address, FLASH)
        self.assertEqual(bytes_of_file[boot.offset:boot.offset + boot.size], struct.pack("<8I", *BLOCK))
        self.assertEqual(self.functions()["axial_reset"], BLOCK[3])

    def test_code_lies_in_ram_but_for_what_copies_it(self):
        described = image.Image(emulator.image(self.board, "selftest"))
        in_flash = {described.function_at(address) for address in described.instructions if address < RAM}
        self.assertEqual(in_flash, {"axial_reset", "axial_start"})

    def test_unrolled_fixed_point_takes_little_more_than_a_cycle_an_instruction(self):
        """1.00 to 1.02 on the core's RTL, kernels of ours; and a copy in RAM is told."""
        kernel = "puma560-bare-inverse_dynamics-unrolled-off"
        rows = {probe.name: measure.Figures(self.board, probe).row() for probe in measure.probes(self.board) if probe.name.startswith(kernel)}
        fixed = rows[kernel + "-fixed32"]
        self.assertTrue(1.0 <= fixed["cycles"] / fixed["instructions"] <= 1.02, fixed)
        self.assertEqual({row["cycles_kind"] for row in rows.values()}, {"validated"})
        self.assertEqual({row["flash_bytes"] - row["ram_bytes"] for row in rows.values()}, {0})

    def functions(self):
        return image.Image(emulator.image(self.board, "selftest")).functions


del selftest_test.SelfTest  # or it runs here too

if __name__ == "__main__":
    harness.main()
