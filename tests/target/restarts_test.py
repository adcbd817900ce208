"""Whatever goes wrong: the drives are off first, then the board restarts and says why."""

import re
import sys
import unittest

import emulator
import harness

sys.path.insert(0, str(emulator.ROOT / "host_sim/boards/size"))
import image  # noqa: E402

# Step of firmware/apps/faults, and what the next start must say.
STEPS = {"stack overflow": "stack_overflow", "store at the bottom": "stack_overflow",
         "store at the guard's end": "stack_overflow", "store above the guard": "software", "wild jump": "fault",
         "hang": "watchdog", "hang without a tick": "watchdog", "spoilt report": "unknown", "reset": "software"}
HEADLINES = {"stack_overflow": ["fault: the stack overflowed"], "fault": ["fault"], "watchdog": ["watchdog: not fed in time"],
             "software": [], "unknown": []}
WATCHDOG_MS = 200
WITHOUT_HARDWARE = {"nrf51", "rp2040"}
RESET_BY_WATCHDOG = {"rp2040"}  # without a word of the image's; its emulator tells when
WITHOUT_PIN = {"stm32f405", "stm32f100"}  # QEMU 7.2 reads 0 from their GPIO
NOWHERE = {"qemu-system-riscv32": 0x05000000}
NOWHERE_OF_ARM = 0xA0000000
STACK_LIMIT_FAULT = 1 << 20  # CFSR.STKOF: the Cortex-M33 has a limit beside the region


def value(lines, name):
    """The hexadecimal number of the only line that begins with `name`."""
    found = [line[len(name):] for line in lines if line.startswith(name)]
    assert len(found) == 1, (name, lines)
    return int(found[0], 16)


class Restarts(harness.BoardTest):
    @classmethod
    def setUpClass(cls):
        cls.code, cls.text = emulator.run(cls.board, "faults")
        first, *blocks = cls.text.split("step: ")
        cls.first = first.splitlines()
        cls.steps = {block.splitlines()[0]: block.splitlines()[1:] for block in blocks}

    def for_each_step(self, check):
        for name, lines in self.steps.items():
            with self.subTest(name):
                check(name, lines)

    def is_reset_silently(self, name):
        return self.board in RESET_BY_WATCHDOG and STEPS[name] == "watchdog"

    def symbols(self):
        return {line.split()[-1]: int(line.split()[0], 16)
                for line in image.run("nm", emulator.image(self.board, "faults")).splitlines()}

    def test_every_step_ends_in_a_restart_that_says_why(self):
        self.assertEqual(self.code, 0, self.text)
        self.assertEqual(self.first, ["start: power_on", "  drives disabled", "  pin low"])
        self.assertEqual(list(self.steps), list(STEPS))

        def check(name, lines):
            at = lines.index("start: " + STEPS[name])
            self.assertEqual(lines[at + 1:at + 3], ["  drives disabled", "  pin low"])

        self.for_each_step(check)

    def test_drives_are_off_before_anything_is_told(self):
        def check(name, lines):
            at = next(i for i, line in enumerate(lines) if line.startswith("drives: disabled at tick"))
            first = r"^watchdog: restarted" if self.is_reset_silently(name) else r"^  begun at tick"
            self.assertRegex(lines[at - 1], first, "nothing comes between the fault and the pin")
            self.assertTrue(any(line.startswith("drives: enabled at tick") for line in lines[:at]))
            after = [line for line in lines[at + 1:] if not line.startswith("  ") and line]
            headlines = [] if self.is_reset_silently(name) else HEADLINES[STEPS[name]]
            self.assertEqual(after[:-1] if name == "reset" else after, headlines + ["start: " + STEPS[name]])

        self.for_each_step(check)

    def test_the_pin_follows(self):
        def check(_, lines):
            at = lines.index("  drives enabled")
            self.assertEqual(lines[at + 1], "  pin low" if self.board in WITHOUT_PIN else "  pin high")

        self.for_each_step(check)

    def test_in_time(self):
        """A fault within the tick; the watchdog between its time and 9/8 of it, and one tick of rounding either way."""
        tick_Hz = emulator.board(self.board).get("tick_Hz", 1000)

        def check(name, lines):
            if self.is_reset_silently(name):
                passed = int(re.search(r"^watchdog: restarted (\d+) us", "\n".join(lines), re.MULTILINE)[1])
                self.assertTrue(WATCHDOG_MS <= passed / 1000 <= WATCHDOG_MS * 9 / 8, passed)
                return
            taken = value(lines, "drives: disabled at tick ") - value(lines, "  begun at tick ")
            if name == "hang":
                self.assertGreaterEqual(taken, WATCHDOG_MS * tick_Hz / 1000 - 1)
                self.assertLessEqual(taken, WATCHDOG_MS * tick_Hz / 1000 * 9 / 8 + 1)
            else:
                self.assertLessEqual(taken, 1)

        self.for_each_step(check)

    def test_the_guard_is_as_wide_as_it_says(self):
        def check(_, lines):
            self.assertIn("  guard canary" if self.board in WITHOUT_HARDWARE else "  guard hardware", lines)
            self.assertIn("  stack intact", lines)

        self.for_each_step(check)
        if self.board not in WITHOUT_HARDWARE:
            bottom = self.symbols()["axial_stack_bottom"]
            self.assertEqual(value(self.steps["store at the bottom"], "  reported address "), bottom)
            self.assertEqual(value(self.steps["store at the guard's end"], "  reported address "), bottom + 28)

    def test_the_report_tells_where(self):
        jump = self.steps["wild jump"]
        self.assertEqual(value(jump, "  reported pc "), NOWHERE.get(emulator.board(self.board).get("qemu", {}).get("program"), NOWHERE_OF_ARM))
        self.assertIn("  reported fault", jump)
        for line in self.steps["spoilt report"]:
            self.assertNotRegex(line, "reported", "a report that does not match its check word is not believed")

    @unittest.skipUnless("m33" in emulator.board(sys.argv[1])["cpu"], "no other core has a limit")
    def test_the_stack_limit_speaks_first(self):
        self.assertTrue(value(self.steps["stack overflow"], "  cfsr ") & STACK_LIMIT_FAULT)

    def test_fault_handlers_have_stack_to_spare(self):
        self.assertGreaterEqual(int(re.search(r"fault stack left ([0-9a-f]{8})", self.text)[1], 16), 24)

    def test_the_pin_comes_before_any_use_of_a_stack(self):
        """In the code: the first store of the handler is the pin's; RISC-V first frees a register for it."""
        path = emulator.image(self.board, "faults")
        arm = image.machine_of(path) == image.ARM
        code = image.run("objdump", "-d", "--disassemble=" + ("axial_fault" if arm else "axial_trap_entry"), path)
        if arm:
            before = re.search(r"<axial_fault>:\n((?:.*\tldr\t.*\n|.*\tmov[.sw]*\t.*\n){2}).*\tstr\tr1, \[r0, #0\]", code)
            self.assertIsNotNone(before, code)
        else:
            target = re.search(r"\tbgez\tt0,([0-9a-f]+)", code)[1]
            first, second = re.findall(r".*\tsw\t.*", code[code.index(target + ":\t"):])[:2]
            between = code[code.index(first):code.index(second)]
            self.assertRegex(first, r"t1,0\(t0\)$")
            self.assertRegex(between, r"<axial_drive_pin>\n.*\tli\tt1,0\n")
            self.assertRegex(second, r"t1,0\(t0\)$")


if __name__ == "__main__":
    harness.main()
