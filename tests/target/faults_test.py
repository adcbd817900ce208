"""What goes wrong stops with a report; a missing debugger does not stop anything."""

import sys
import unittest

import emulator
import harness
import link


class Faults(harness.BoardTest):
    def test_an_overflown_stack_is_reported(self):
        code, text = emulator.run(self.board, "overflow")
        self.assertEqual(code, 70, text)
        self.assertIn("fault: the stack overflowed", text)

    @unittest.skipIf("measuring_only" in emulator.board(sys.argv[1]), "there is no serial port to ask by")
    def test_semihosting_without_a_listener_is_stepped_over(self):
        with emulator.Emulator(self.board, "injection-scara", semihosting=False) as firmware:
            firmware.send(link.frame(link.SHUTDOWN, 0, bytes([7])))
            firmware.ask(1, link.set_point([0.1] * 3, [0] * 3, [0] * 3))
            self.assertIsNone(firmware.process.poll(), "the image runs on")


if __name__ == "__main__":
    harness.main()
