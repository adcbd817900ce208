"""The headers inside a firmware of somebody else's: built from an installed axial alone, run in QEMU, held against Craig's closed form."""

import math
import os
import pathlib
import select
import struct
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOREIGN = ROOT / "firmware" / "examples" / "foreign"
QEMU = ["qemu-system-arm", "-M", "netduinoplus2", "-icount", "shift=6,sleep=off", "-display", "none", "-monitor", "none",
        "-serial", "stdio", "-kernel"]
TICKS, EVERY = 1000, 100
# robots/planar2r.hpp; firmware/examples/foreign/control.cpp
L1, L2, M1, M2, G = 0.5, 0.75, 4.6, 2.3, 9.81
FROM, WAY = (-0.5, 1.0), (1.25, -1.5)
TOLERANCE = 1e-6  # of the larger torque: some tens of roundings of 2^-24


def quietly(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"{command}:\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}")
    return done.stdout


def desired(t):
    """q, qd, qdd of both joints."""
    return ([a + w * t * t * (3 - 2 * t) for a, w in zip(FROM, WAY)], [w * 6 * t * (1 - t) for w in WAY],
            [w * (6 - 12 * t) for w in WAY])


def torque(q, qd, qdd):
    """Craig, Introduction to Robotics, eqs. (6.58): point masses at the ends of the links."""
    (q1, q2), (d1, d2), (a1, a2) = q, qd, qdd
    c1, c2, s2, c12 = math.cos(q1), math.cos(q2), math.sin(q2), math.cos(q1 + q2)
    first = (M2 * L2**2 * (a1 + a2) + M2 * L1 * L2 * c2 * (2 * a1 + a2) + (M1 + M2) * L1**2 * a1 - M2 * L1 * L2 * s2 * d2**2
             - 2 * M2 * L1 * L2 * s2 * d1 * d2 + M2 * L2 * G * c12 + (M1 + M2) * L1 * G * c1)
    second = M2 * L1 * L2 * c2 * a1 + M2 * L1 * L2 * s2 * d1**2 + M2 * L2 * G * c12 + M2 * L2**2 * (a1 + a2)
    return first, second


def run(image, timeout=60):
    """What the firmware says until its last line; it has no way to end the emulator."""
    process = subprocess.Popen([*QEMU, str(image)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
    text, end = b"", time.monotonic() + timeout
    try:
        while b"end," not in text or not text.endswith(b"\n"):
            if time.monotonic() > end or not select.select([process.stdout], [], [], 1.0)[0]:
                if time.monotonic() > end:
                    raise TimeoutError(f"no last line; so far: {text!r}")
                continue
            piece = os.read(process.stdout.fileno(), 65536)
            if not piece:
                raise RuntimeError(f"the emulator ended: {text!r}")
            text += piece
    finally:
        process.kill()
        process.wait()
        process.stdout.close()
    return text.decode().splitlines()


class Foreign(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory(prefix="axial-foreign-") as name:
            folder = pathlib.Path(name)
            quietly("cmake", "-S", ROOT, "-B", folder / "axial", "-DAXIAL_OWN_BUILD=OFF")
            quietly("cmake", "--install", folder / "axial", "--prefix", folder / "installed")
            quietly("cmake", "-S", FOREIGN, "-B", folder / "build", "--toolchain", FOREIGN / "cortex_m4f.cmake",
                    f"-DCMAKE_PREFIX_PATH={folder / 'installed'}")
            quietly("cmake", "--build", folder / "build")
            cls.symbols = quietly("arm-none-eabi-nm", "-C", folder / "build" / "foreign.elf")
            cls.lines = run(folder / "build" / "foreign.elf")

    def test_torques_are_craigs(self):
        rows = [[int(word, 16) for word in line.split(",")] for line in self.lines[:-1]]
        self.assertEqual([row[0] for row in rows], list(range(EVERY, TICKS + 1, EVERY)))
        for tick, *bits, status in rows:
            wanted = torque(*desired((tick - 1) / TICKS))
            for word, value in zip(bits, wanted):
                found = struct.unpack("<f", struct.pack("<I", word))[0]
                self.assertAlmostEqual(found, value, delta=TOLERANCE * max(map(abs, wanted)), msg=f"tick {tick}")
            self.assertEqual(status, 0)

    def test_no_interrupt_is_missed(self):
        self.assertEqual(self.lines[-1], f"end,{TICKS:08x},00000000")

    def test_nothing_of_our_boards_is_linked(self):
        self.assertIn("SysTick_Handler", self.symbols)
        self.assertNotIn("axial::hal", self.symbols)
        self.assertNotIn("axial_reset", self.symbols)


if __name__ == "__main__":
    unittest.main(verbosity=2)
