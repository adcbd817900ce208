"""With AXIAL_SECOND_CORE the program runs on the RP2040's second core: launched as its boot ROM wants, with interrupts and counter of its own."""

import subprocess
import unittest

import emulator
import harness

FOLDER = emulator.IMAGES / "rp2040_second_core" / "images"


class SecondCore(harness.BoardTest):
    def output(self, folder):
        done = subprocess.run(emulator.command(self.board, folder / "selftest.elf", "null", fast=True), stdin=subprocess.DEVNULL, timeout=120,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_it_runs_the_program(self):
        text = self.output(FOLDER)
        self.assertTrue(text.startswith("second core: started\n"), text[:200])
        self.assertRegex(text, r"\n[1-9]\d* checks, 0 failed\n")

    def test_without_the_option_it_is_left_asleep(self):
        self.assertNotIn("second core", self.output(emulator.image(self.board, "selftest").parent))


if __name__ == "__main__":
    harness.main()
