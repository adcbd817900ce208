"""The self-test images give their verdict: the instruments first, then every robot."""

import re

import emulator
import harness

SHIFT = re.compile(r"^shift=(\d+)$")


class SelfTest(harness.BoardTest):
    def verdict(self, image):
        code, text = emulator.run(self.board, image)
        self.assertEqual(code, 0, text)
        self.assertNotIn("left out", text)
        self.assertRegex(text, r"\n[1-9]\d* checks, 0 failed\n", "the verdict is missing")

    def test_1_instruments(self):
        self.verdict("selftest")

    def test_2_robots(self):
        for robot in harness.robots(self.board):
            with self.subTest(robot):
                self.verdict("selftest-" + robot)

    def test_a_wrong_machine_clock_is_noticed(self):
        """Negative control: with half the time an instruction, or two cycles a tick of SysTick, no block counts right, and
        the verdict must say so."""
        right = emulator.board(self.board)
        kind = "qemu" if "qemu" in right else "runner"
        arguments = [SHIFT.sub(lambda found: f"shift={int(found[1]) - 1}", a) for a in right[kind]["arguments"]]
        if kind == "runner":
            arguments[arguments.index("-sys-tick") + 1] = "2"
        wrong = {**right, kind: {**right[kind], "arguments": arguments}}
        self.assertNotEqual(wrong, right)
        original, emulator.board = emulator.board, lambda _: wrong
        try:
            code, text = emulator.run(self.board, "selftest")
        finally:
            emulator.board = original
        self.assertEqual(code, 1, text)
        self.assertIn("FAILED 10 instructions are counted as 10", text)


if __name__ == "__main__":
    harness.main()
