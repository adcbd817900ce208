"""Faults of the line, the host and the program against the main jobs: each ends in the state and within the time that
doc/guides/safety.md gives, seen on the drives' pin (which the board announces) and in the next hello."""

import math
import re
import subprocess
import time

import emulator
import harness
import link

TIME_LIMIT_S = 60
PATIENCE, RAMP_MS, HOLD_MS, LOCK_STEP_PATIENCE_MS, WATCHDOG_MS = 20, 100, 2000, 1000, 100
SLIDE_WEIGHT = -1.25 * 9.8125
Q = [0.1] * 3
AT_REST = link.set_point(Q, [0] * 3, [0] * 3)
MOVING = link.set_point(Q, [1, -2, 0.5], [5, -5, 2])
NAN = link.set_point(Q, [0, math.nan, 0], [0] * 3)
NOWHERE = link.set_point([0.1, math.nan, 0.1], [0] * 3, [0] * 3)
ENCODERS = [round(0.1 / (2 * math.pi) * 2**32)] * 2 + [1_000_000]
JOBS = ("feedforward-scara", "feedforward-fixed-scara", "tracking-scara", "tracking-fixed-scara")
# Where nothing can be executed.
NOT_CODE = {"arm": 0xA0000000, "riscv": 0x05000000}
TOOLS = {"arm": "arm-none-eabi-", "riscv": "riscv64-unknown-elf-"}


class Safety(harness.BoardTest):
    def ticks(self, ms):
        return -(-ms * emulator.board(self.board)["tick_Hz"] // 1000)

    def jobs(self, kind=""):
        jobs = ("feedforward-scara", "tracking-fixed-scara") if self.board in harness.FEW_IMAGES else JOBS
        return [job for job in jobs if job.startswith(kind)]

    def lifetime(self, mode):
        """Ticks from the last good set-point to the drives' disabling."""
        patience = PATIENCE if mode == link.FREE_RUNNING else self.ticks(LOCK_STEP_PATIENCE_MS)
        return patience + self.ticks(RAMP_MS) + self.ticks(HOLD_MS)

    def run_job(self, job, mode, fast=True):
        """`fast`: idle time passes at once."""
        return emulator.Emulator(self.board, job, mode=mode, fast=fast)

    def set_point(self, job, firmware, number, payload, counts=ENCODERS):
        """A set-point as the job takes it."""
        measured = firmware.frame(link.MEASUREMENT, 0, link.measurement(counts)) if job.startswith("tracking") else b""
        return measured + firmware.frame(link.SET_POINT, number, payload)

    def until(self, firmware, phase, keep_up=lambda: None):
        """Torques until the drives are in a phase."""
        told, end = [], time.monotonic() + TIME_LIMIT_S
        while not told or told[-1]["phase"] != phase:
            self.assertLess(time.monotonic(), end)
            keep_up()
            told.append(link.torque(firmware.expect(link.TORQUE)[1]))
        return told

    def drives(self, firmware):
        """What the pin did: (enabled, tick)."""
        found = re.findall(r"drives: (enabled|disabled) at tick ([0-9a-f]{8})", firmware.console())
        return [(what == "enabled", int(tick, 16)) for what, tick in found]

    def expect_lifetime(self, firmware, mode, slack=1):
        (on, first), (off, last) = self.drives(firmware)[-2:]
        self.assertEqual((on, off), (True, False))
        self.assertLessEqual(abs(last - first - self.lifetime(mode)), slack)
        self.assertNotIn("fault", firmware.console())
        self.assertNotIn("watchdog", firmware.console())

    def expect_weight(self, tau):
        for found, wanted in zip(tau, (0, 0, SLIDE_WEIGHT)):
            self.assertAlmostEqual(found, wanted, places=4)

    def test_a_silent_line(self):
        for job in self.jobs():
            for mode in link.FREE_RUNNING, link.LOCK_STEP:
                with self.subTest(job, mode=mode), self.run_job(job, mode) as firmware:
                    firmware.send(self.set_point(job, firmware, 1, MOVING))
                    told = self.until(firmware, link.PHASE_DISABLED)
                    self.expect_lifetime(firmware, mode)
                    self.assertEqual(told[0]["status"], link.OK)
                    self.assertEqual({one["status"] for one in told[1:]}, {link.WATCHDOG})
                    self.assertEqual([one["phase"] for one in told], sorted(one["phase"] for one in told))
                    held = [one for one in told if one["phase"] == link.HOLDING]
                    self.assertGreaterEqual(len(held), self.ticks(HOLD_MS) // PATIENCE)
                    for one in held:
                        self.expect_weight(one["tau"])
                    for joint, first in enumerate(told[0]["tau"]):
                        path = [one["tau"][joint] for one in told if one["phase"] != link.PHASE_DISABLED]
                        self.assertIn(path, (sorted(path), sorted(path, reverse=True)), "a straight line")
                        self.assertGreater(abs(first - held[0]["tau"][joint]), 0.1, "there is something to fade")
                    self.assertEqual(told[-1]["tau"], [0, 0, 0])
                    self.start_again(job, firmware, mode)

    def start_again(self, job, firmware, mode, number=2, refused=link.DISABLED):
        """Disabled drives take nothing until a session is opened, then everything."""
        firmware.send(self.set_point(job, firmware, number, AT_REST))
        told = link.torque(firmware.expect(link.TORQUE)[1])
        self.assertEqual((told["status"], told["tau"]), (refused, [0, 0, 0]))
        firmware.open(mode)
        firmware.send(self.set_point(job, firmware, 1, AT_REST))
        self.assertEqual(link.torque(firmware.expect(link.TORQUE)[1])["status"], link.OK)

    def flood(self, firmware, data):
        """Sends again and again until the drives are disabled."""
        end = time.monotonic() + TIME_LIMIT_S
        while self.drives(firmware)[-1][0]:
            self.assertLess(time.monotonic(), end)
            if len(firmware.unsent) < len(data):
                firmware.send(data)
            firmware.listen(0.002)
            firmware.pending.clear()

    def flooded(self, job, make):
        if self.board in harness.FEW_IMAGES:
            self.skipTest("a flood takes its emulator minutes")
        with self.subTest(job), self.run_job(job, link.FREE_RUNNING) as firmware:
            firmware.send(self.set_point(job, firmware, 1, MOVING))
            self.assertEqual(link.torque(firmware.expect(link.TORQUE)[1])["status"], link.OK)
            self.flood(firmware, make(firmware))
            self.expect_lifetime(firmware, link.FREE_RUNNING)

    def test_a_flood_of_bytes(self):
        self.flooded("feedforward-scara", lambda _: bytes(range(1, 256)) * 16)

    def test_a_flood_of_frames(self):
        def make(firmware):
            return (self.set_point("tracking-fixed-scara", firmware, 1, MOVING) + link.frame(link.STATS_REQUEST, 1)
                    + link.frame(link.START, 0, link.start(link.LOCK_STEP, 1, 1))) * 20

        self.flooded("tracking-fixed-scara", make)

    def test_corrupted_frames(self):
        def make(firmware):
            frames = [bytearray(firmware.frame(link.SET_POINT, number, MOVING)) for number in range(2, 22)]
            for number, frame in enumerate(frames):
                frame[8 + number] ^= 0x10
            return b"".join(frames)

        self.flooded("feedforward-fixed-scara", make)

    def test_replays(self):
        with self.run_job("feedforward-scara", link.LOCK_STEP, fast=False) as firmware:
            recorded = firmware.opened + b"".join(firmware.frame(link.SET_POINT, number, MOVING) for number in range(1, 5))
            for number in range(1, 6):
                firmware.ask(number, AT_REST)

            def replay(refused, why):
                before = firmware.stats()
                firmware.send(recorded)
                firmware.expect(link.HELLO)
                after = firmware.stats()
                self.assertEqual(after["counters"][refused], before["counters"][refused] + 4, why)
                self.assertEqual((after["set_points"], after["refused"]), (before["set_points"], before["refused"]), why)

            replay(link.OUT_OF_ORDER, "in the same session")
            self.assertEqual(firmware.ask(6, AT_REST)["status"], link.OK)
            firmware.open(link.LOCK_STEP)
            replay(link.BAD_CRC, "in the next session")
            self.assertEqual(firmware.ask(1, AT_REST)["status"], link.OK)
        with self.run_job("feedforward-scara", None, fast=False) as firmware:
            firmware.send(recorded)
            firmware.session = None  # a start that was recorded gives the board another
            self.assertEqual(firmware.stats()["set_points"], 0, "after the power was off")  # told behind all other answers
            firmware.open(link.LOCK_STEP)
            self.assertEqual(firmware.stats()["set_points"], 0, "nor in the session that follows")
            self.assertEqual(self.drives(firmware), [])

    def test_a_number_far_ahead(self):
        with self.run_job("feedforward-scara", link.LOCK_STEP, fast=False) as firmware:
            firmware.ask(1, AT_REST)
            for number in (2 + link.SEQUENCE_WINDOW, 0x7FFFFFFF):
                firmware.send(firmware.frame(link.SET_POINT, number, MOVING))
                self.assertEqual(link.error(firmware.expect(link.ERROR)[1])["fault"], link.FAR_AHEAD)
            self.assertEqual(firmware.ask(2, AT_REST)["status"], link.OK)

    def test_a_first_request_that_is_refused(self):
        for job in self.jobs():
            for mode in link.FREE_RUNNING, link.LOCK_STEP:
                with self.subTest(job, mode=mode), self.run_job(job, mode) as firmware:
                    firmware.send(self.set_point(job, firmware, 1, NOWHERE))
                    told = link.torque(firmware.expect(link.TORQUE)[1])
                    measured = job.startswith("tracking")
                    self.assertEqual((told["status"], told["phase"]), (link.NOT_FINITE, link.HOLDING if measured else link.IDLE))
                    if measured:
                        self.expect_weight(told["tau"])
                    else:
                        self.assertEqual((told["tau"], self.drives(firmware)), ([0, 0, 0], []))
                        firmware.send(self.set_point(job, firmware, 2, NAN))
                        told = link.torque(firmware.expect(link.TORQUE)[1])
                        self.assertEqual((told["status"], told["phase"]), (link.NOT_FINITE, link.HOLDING))
                        self.expect_weight(told["tau"])
                    self.until(firmware, link.PHASE_DISABLED)
                    (_, first), (_, last) = self.drives(firmware)
                    self.assertLessEqual(abs(last - first - self.ticks(HOLD_MS)), 1)

    def test_requests_that_go_bad(self):
        for job in self.jobs():
            with self.subTest(job), self.run_job(job, link.FREE_RUNNING, fast=False) as firmware:
                firmware.send(self.set_point(job, firmware, 1, MOVING))
                number = 1

                def keep_up():
                    nonlocal number
                    number += 1
                    firmware.send(self.set_point(job, firmware, number, NAN))

                told = self.until(firmware, link.HOLDING, keep_up)
                self.expect_weight(told[-1]["tau"])
                self.assertTrue(self.drives(firmware)[-1][0])

    def test_measurements_that_stop(self):
        for job in self.jobs("tracking"):
            with self.subTest(job), self.run_job(job, link.LOCK_STEP) as firmware:
                firmware.send(self.set_point(job, firmware, 1, MOVING) + firmware.frame(link.SET_POINT, 2, AT_REST))
                first = link.torque(firmware.expect(link.TORQUE)[1])
                second = link.torque(firmware.expect(link.TORQUE)[1])
                self.assertEqual((first["status"], second["status"]), (link.OK, link.NOT_MEASURED))
                self.assertEqual(second["tau"], first["tau"])
                self.until(firmware, link.PHASE_DISABLED)
                self.expect_lifetime(firmware, link.LOCK_STEP)

    def test_a_broken_encoder_wire(self):
        """What it reads jumps to 0, or to anywhere: no torque follows it."""
        for job in self.jobs("tracking"):
            for joint, reading in (1, 0), (0, 0x5A5A5A5A), (2, 0):
                broken = list(ENCODERS)
                broken[joint] = reading
                with self.subTest(job, joint=joint), self.run_job(job, link.LOCK_STEP) as firmware:
                    firmware.send(self.set_point(job, firmware, 1, MOVING)
                                  + self.set_point(job, firmware, 2, AT_REST, broken))
                    first = link.torque(firmware.expect(link.TORQUE)[1])
                    self.assertEqual(first["status"], link.OK)
                    told = link.torque(firmware.expect(link.TORQUE)[1])
                    self.assertEqual((told["status"], told["tau"]), (link.NOT_MEASURED, first["tau"]))
                    held = [one for one in self.until(firmware, link.PHASE_DISABLED) if one["phase"] == link.HOLDING]
                    self.assertTrue(held)
                    for one in held:
                        self.expect_weight(one["tau"])
                    self.expect_lifetime(firmware, link.LOCK_STEP)
                    self.start_again(job, firmware, link.LOCK_STEP, number=3, refused=link.NOT_MEASURED)

    def family(self):
        return "riscv" if emulator.board(self.board)["cpu"].startswith("rv") else "arm"

    def stack_bottom(self, job):
        listing = subprocess.run([TOOLS[self.family()] + "nm", emulator.image(self.board, job)], capture_output=True, text=True, check=True).stdout
        return int(re.search(r"^([0-9a-f]+) \w axial_stack_bottom$", listing, re.MULTILINE)[1], 16)

    def off_after(self, job, fault, address, cause):
        """Ticks from the drives' start to their end, in the middle of a motion, by a fault that ends the program."""
        self.firmware.open(link.LOCK_STEP)
        before = len(self.drives(self.firmware))
        self.firmware.send(self.set_point(job, self.firmware, 1, MOVING)
                           + self.firmware.frame(link.INJECTION, 0, link.injection(fault, address)))
        self.assertEqual(link.torque(self.firmware.expect(link.TORQUE)[1])["status"], link.OK)
        session = self.firmware.session
        self.firmware.hello = link.hello(self.firmware.expect(link.HELLO)[1])
        self.assertEqual(self.firmware.hello["reset_cause"], cause)
        self.assertNotIn(self.firmware.hello["session"], (session, link.NO_SESSION))
        (on, first), (off, last) = self.drives(self.firmware)[before:]
        self.assertEqual((on, off), (True, False))
        return last - first

    def injected(self, job, fault, address, cause, ms):
        """The drives are off within `ms`, and a tick of rounding at either end. An emulator that its host starves hears of the fault
        ticks behind the set-point: where one is late, the two that follow have to be in time."""
        most = self.ticks(ms) + 2
        with self.subTest(job, fault=fault):
            if self.off_after(job, fault, address, cause) > most:
                self.assertLessEqual(max(self.off_after(job, fault, address, cause) for _ in range(2)), most)

    def test_a_program_that_fails(self):
        nowhere = NOT_CODE[self.family()]
        images = ("injection-scara", "feedforward-scara"), ("injection-tracking-fixed-scara", "tracking-fixed-scara")
        for image, job in images[:1] if self.board in harness.FEW_IMAGES else images:
            with self.run_job(image, None, fast=False) as self.firmware:
                self.injected(job, link.OVERFLOW_STACK, 0, link.BY_STACK_OVERFLOW, 5)  # 32 KiB take 4 ms to fill
                self.injected(job, link.JUMP, nowhere, link.BY_FAULT, 0)
                self.assertEqual(self.firmware.hello["fault_address"], nowhere)
                self.injected(job, link.WRITE, self.stack_bottom(image), link.BY_STACK_OVERFLOW, 0)
                self.injected(job, link.HANG, 0, link.BY_WATCHDOG, WATCHDOG_MS * 9 / 8)

    def overrun(self, firmware, payload, attempts=3):
        """A set-point a tick, until the board starts again. An emulator that its host starves hears them too late, so that it is
        in time with each: then once more."""
        while True:
            firmware.send(b"".join(firmware.frame(link.SET_POINT, number, payload) for number in range(1, 1001)))
            attempts -= 1
            try:
                return firmware.until_restart()
            except TimeoutError:
                if attempts == 0:
                    raise
                firmware.open(link.FREE_RUNNING)

    def test_a_loop_that_misses_its_deadlines(self):
        """Float on a core without a floating-point unit: the Panda's torque takes longer than the tick."""
        if self.board not in ("stm32f100", "nrf51"):
            self.skipTest("is quick enough")
        with self.run_job("feedforward-panda", link.FREE_RUNNING, fast=False) as firmware:
            q = link.set_point([-0.8, -0.8, 2.4, -0.8, -2.4, 1.2, -1.4], [0] * 7, [0] * 7)
            told = self.overrun(firmware, q)
            torques = [link.torque(payload) for kind, _, payload in told if kind == link.TORQUE]
            self.assertEqual(link.hello(told[-1][2])["reset_cause"], link.BY_WATCHDOG)
            self.assertGreater(torques[-1]["overruns"], 10)
            self.assertFalse(self.drives(firmware)[-1][0])


if __name__ == "__main__":
    harness.main()
