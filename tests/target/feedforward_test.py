"""The main job over the emulated serial port: what it says, answers, refuses, holds."""

import math
import pathlib
import re
import struct
import time

import emulator
import harness
import link

VERSION = pathlib.Path(__file__).resolve().parents[2] / "firmware/include/axial/version.h"
AT_REST = link.set_point([0.1] * 3, [0] * 3, [0] * 3)
NAN = link.set_point([0.1, math.nan, 0.1], [0] * 3, [0] * 3)
TOO_FAST = link.set_point([0.1] * 3, [0, 0, 1e6], [0] * 3)


def library_version():
    major, minor, patch = re.search(r'AXIAL_VERSION "(\d+)\.(\d+)\.(\d+)"', VERSION.read_text(encoding="utf-8")).groups()
    return int(major) * 10000 + int(minor) * 100 + int(patch)


class Feedforward(harness.BoardTest):
    def run_scara(self):
        return emulator.Emulator(self.board, "feedforward-scara")

    def tick_Hz(self):
        return emulator.board(self.board)["tick_Hz"]

    def test_hello(self):
        shows = emulator.board(self.board).get("runner", {"clock": "emulator", "counts": "instructions"})
        for robot, joints in harness.robots(self.board).items():
            with self.subTest(robot), emulator.Emulator(self.board, "feedforward-" + robot) as firmware:
                hello = firmware.hello
                self.assertEqual((hello["robot"], hello["board"], hello["joints"]), (robot, self.board, joints))
                self.assertEqual((hello["version"], hello["library"]), (3, library_version()))
                self.assertEqual(firmware.greeting["reset_cause"], link.POWER_ON)
                self.assertEqual(link.COUNTERS[hello["counter_kind"]], shows["counts"])
                self.assertEqual(link.CLOCKS[hello["clock_source"]], shows["clock"], "the clock, or its fallback, is reported")
                self.assertEqual(hello["tick_Hz"], self.tick_Hz())

    def test_torque_and_count(self):
        with self.run_scara() as firmware:
            first = firmware.ask(1, AT_REST)
            self.assertEqual(first["status"], link.OK)
            # At rest the turning joints carry nothing; the slide carries its 1.25 kg at 9.8125 m/s^2, pointing down.
            self.assertAlmostEqual(first["tau"][0], 0.0)
            self.assertAlmostEqual(first["tau"][1], 0.0)
            self.assertAlmostEqual(first["tau"][2], -1.25 * 9.8125, places=5)
            again = firmware.ask(2, AT_REST)
            self.assertEqual(first, again, "the same request costs and gives the same")
            self.assertGreater(first["count"], 50)

    def test_bad_requests_repeat_the_last_safe_torque(self):
        with self.run_scara() as firmware:
            safe = firmware.ask(1, AT_REST)
            nan = firmware.ask(2, NAN)
            self.assertEqual((nan["tau"], nan["status"], nan["joint"]), (safe["tau"], link.NOT_FINITE, 1))
            fast = firmware.ask(3, TOO_FAST)
            self.assertEqual((fast["tau"], fast["status"], fast["joint"]), (safe["tau"], link.OUTSIDE_LIMITS, 2))
            stats = firmware.stats()
            self.assertEqual((stats["set_points"], stats["refused"]), (1, 2))

    def test_order(self):
        with self.run_scara() as firmware:
            firmware.ask(5, AT_REST)
            for number in (5, 4, 0xFFFFFFFF):
                firmware.send(firmware.frame(link.SET_POINT, number, AT_REST))
                error = link.error(firmware.expect(link.ERROR)[1])
                self.assertEqual(error["fault"], link.OUT_OF_ORDER)
            self.assertEqual(error["counters"][link.OUT_OF_ORDER], 3)
            firmware.ask(9, AT_REST)
            self.assertEqual(firmware.stats()["gaps"], 7)

    def test_every_fault_is_named(self):
        good = link.frame(link.SET_POINT, 1, AT_REST)
        flipped = bytearray(good)
        flipped[20] ^= 0x40
        cases = {
            link.BAD_COBS: good[:2] + b"\0",
            link.TRUNCATED: b"\0" + link.stuff(b"abc") + b"\0",
            link.OVERSIZED: b"\0" + link.stuff(bytes(200)) + b"\0",
            link.BAD_LENGTH: b"\0" + link.stuff(struct.pack("<BIH", 2, 1, 99) + bytes(40)) + b"\0",
            link.BAD_CRC: bytes(flipped),
            link.BAD_PAYLOAD: link.frame(link.SET_POINT, 1, AT_REST[:-4]),
            link.UNKNOWN_TYPE: link.frame(77, 1),
            link.WITHOUT_SESSION: good,
        }
        with self.run_scara() as firmware:
            for fault, data in cases.items():
                with self.subTest(fault=fault):
                    firmware.send(data)
                    self.assertEqual(link.error(firmware.expect(link.ERROR)[1])["fault"], fault)
            self.assertEqual(firmware.ask(1, AT_REST)["status"], link.OK)

    def test_free_running_ticks_and_watchdog(self):
        with self.run_scara() as firmware:
            firmware.open(link.FREE_RUNNING)
            self.assertEqual(firmware.hello["mode"], link.FREE_RUNNING)
            safe = firmware.ask(1, AT_REST)
            self.assertEqual(safe["status"], link.OK)
            held = link.torque(firmware.expect(link.TORQUE)[1])
            self.assertEqual((held["status"], held["phase"], held["tau"]), (link.WATCHDOG, link.FADING, safe["tau"]))
            self.assertEqual(firmware.ask(2, AT_REST)["status"], link.OK, "a new set-point ends the hold")
            before, start = firmware.stats(), time.monotonic()
            firmware.listen(0.5)
            ticks, passed = firmware.stats()["ticks"] - before["ticks"], time.monotonic() - start
            # The emulator follows the clock on the wall when it is idle; a busy host makes it late, never early.
            self.assertGreater(ticks, 0.05 * self.tick_Hz())
            self.assertLess(ticks, 1.5 * self.tick_Hz() * passed)
            self.assertGreater(firmware.stats()["watchdog_holds"], before["watchdog_holds"])

    def test_images_for_flash_know_no_shutdown(self):
        with self.run_scara() as firmware:
            for kind, payload in (link.SHUTDOWN, bytes([7])), (link.INJECTION, link.injection(link.HANG)):
                firmware.send(firmware.frame(kind, 0, payload))
                self.assertEqual(link.error(firmware.expect(link.ERROR)[1])["fault"], link.UNKNOWN_TYPE)
            self.assertEqual(firmware.ask(1, AT_REST)["status"], link.OK)

    def test_shutdown_ends_the_emulator_with_its_code(self):
        with emulator.Emulator(self.board, "injection-scara") as firmware:
            firmware.send(link.frame(link.SHUTDOWN, 0, bytes([7])))
            self.assertEqual(firmware.process.wait(20), 7)


if __name__ == "__main__":
    harness.main()
