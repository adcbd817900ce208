"""A board that stands in for an arm, by its own timer and by numbers: it moves, and its drives do what firmware/apps/plant/README.md says when
efforts stop."""

import math
import re
import time

import emulator
import harness
import link
import symbols_test

TIME_LIMIT_S = 60
PATIENCE, RAMP_MS = 20, 100
GRAVITY = 9.8125
POSE, COUNTS = (0.3, -0.4, 0.1), (2**32 / (2 * math.pi), 2**32 / (2 * math.pi), 1e7)
WEIGHT = (0.0, 0.0, -1.25 * GRAVITY)  # what holds the slide
WITH_FPU = ("stm32f405",)
WITH_SECOND_CORE = ("rp2040", "rp2040_ram")
# Which arms move in less than a tick of their board's timer, by the emulator's clock.
IN_REAL_TIME = {"stm32f405": ("arm-scara", "arm-fixed-scara"), "stm32f100": ("arm-scara", "arm-fixed-scara"),
                "rv32_virt": ("arm-fixed-scara",), "rp2040": ("arm-fixed-scara",)}


class Arm(harness.BoardTest):
    def images(self):
        return ("arm-fixed-scara",) if self.board in harness.FEW_IMAGES else ("arm-scara", "arm-fixed-scara")

    def run_arm(self, image, mode):
        return emulator.Emulator(self.board, image, mode=mode, fast=True)

    def tell(self, arm, action, values=(0, 0, 0)):
        """The encoders that answer a command; what the arm reports of itself is passed over."""
        arm.send(arm.frame(link.ARM_COMMAND, 77, link.arm_command(action, values)))
        while True:
            number, payload = arm.expect(link.ENCODERS)
            if number == 77:
                return link.encoders(payload)

    def ask(self, arm, number, tau, phase=link.RUNNING):
        arm.send(arm.frame(link.TORQUE, number, link.torque_of(tau, phase)))
        number_back, payload = arm.expect(link.ENCODERS)
        self.assertEqual(number_back, number)
        return link.encoders(payload)

    def expect_at(self, encoders, pose, places=2e-6):
        for found, wanted, counts in zip(encoders["position"], pose, COUNTS):
            self.assertAlmostEqual(found / counts, wanted, delta=places)

    def test_lock_step(self):
        for image in self.images():
            with self.subTest(image), self.run_arm(image, link.LOCK_STEP) as arm:
                self.expect_at(self.tell(arm, link.PLACE, POSE), POSE, 1e-7)
                held = [self.ask(arm, number, WEIGHT) for number in range(1, 21)]
                self.expect_at(held[-1], POSE)
                self.assertEqual({one["status"] for one in held}, {link.OK})
                fallen = self.ask(arm, 30, WEIGHT, link.PHASE_DISABLED)  # nine more by the efforts before, one by none
                self.assertAlmostEqual(fallen["speed"][2], 1e-3 * GRAVITY, delta=2e-5)
                bad = self.ask(arm, 31, (math.nan, 0, 0))
                self.assertEqual((bad["status"], bad["joint"]), (link.NOT_FINITE, 0))
                arm.send(arm.frame(link.TORQUE, 31, link.torque_of(WEIGHT)))
                arm.expect(link.ERROR)
                counters = arm.stats()["counters"]
                self.assertEqual(counters[link.OUT_OF_ORDER], 1)
                self.assertEqual(sum(counters), 1)

    def test_the_second_core_integrates(self):
        """Where a board has one; the first answers meanwhile."""
        with self.run_arm(self.images()[-1], link.LOCK_STEP) as arm:
            self.tell(arm, link.PLACE, POSE)
            counts = [self.ask(arm, number, WEIGHT)["count"] for number in range(1, 4)]
            self.assertEqual("second core: beside the first" in arm.console(), self.board in WITH_SECOND_CORE)
            self.assertGreater(min(counts), 1000)

    def test_free_running(self):
        """By the board's timer: while efforts come it follows; when they stop they fade, then the drives are off and the slide falls."""
        described = emulator.board(self.board)
        ramp = -(-RAMP_MS * described["tick_Hz"] // 1000)
        for image in set(self.images()) & set(IN_REAL_TIME.get(self.board, ())):
            with self.subTest(image), self.run_arm(image, link.FREE_RUNNING) as arm:
                self.tell(arm, link.PLACE, POSE)
                arm.send(arm.frame(link.TORQUE, 1, link.torque_of(WEIGHT)))
                told, end = [], time.monotonic() + TIME_LIMIT_S
                while not told or told[-1]["phase"] != link.PHASE_DISABLED:
                    self.assertLess(time.monotonic(), end)
                    told.append(link.encoders(arm.expect(link.ENCODERS)[1]))
                phases = [one["phase"] for one in told]
                self.assertEqual(phases, sorted(phases))
                self.assertIn(link.FADING, phases)
                self.assertEqual({one["status"] for one in told[1:]}, {link.WATCHDOG})
                (on, first), (off, last) = [(what == "enabled", int(tick, 16)) for what, tick in
                                            re.findall(r"drives: (enabled|disabled) at tick ([0-9a-f]{8})", arm.console())][-2:]
                self.assertEqual((on, off), (True, False))
                self.assertLessEqual(abs(last - first - (PATIENCE + ramp + 1)), 1)
                self.assertNotIn("watchdog", arm.console())
                self.assertGreater(told[-1]["position"][2], 1.001 * POSE[2] * COUNTS[2], "its weight was carried no longer")

    def test_an_arm_too_slow_for_its_tick(self):
        for image in set(self.images()) - set(IN_REAL_TIME.get(self.board, ())):
            with self.subTest(image), self.run_arm(image, link.FREE_RUNNING) as arm:
                hello = link.hello(arm.until_restart()[-1][2])
                self.assertEqual(hello["reset_cause"], link.BY_WATCHDOG)

    def test_nothing_forbidden_is_linked(self):
        for name in self.images():
            symbols = symbols_test.defined(emulator.image(self.board, name))
            forbidden = [*symbols_test.FORBIDDEN.values(), symbols_test.SOFT_DOUBLE]
            if "fixed" in name or self.board in WITH_FPU:
                forbidden.append(symbols_test.SOFT_FLOAT)
            for pattern in forbidden:
                with self.subTest(name, pattern=pattern):
                    self.assertEqual(symbols_test.offenders(symbols, pattern), [])


if __name__ == "__main__":
    harness.main()
