"""Boards at serial ports, as on a desk: ./axial hil speaks with them as with those that it starts. Here a port is a pseudo-terminal of an emulator
that has long been running when it is opened.

usage: desk_test.py BOARD HIL       HIL: the program hil-scara
"""

import contextlib
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

import emulator
import harness

LIMIT_S = 60


@contextlib.contextmanager
def at_a_port(board, image):
    """The port of a board whose hello nobody heard."""
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        console = pathlib.Path(folder, "console")
        with console.open("w") as printed:
            process = subprocess.Popen(emulator.command(board, emulator.image(board, image), "pty"), stdin=subprocess.DEVNULL, stdout=printed,
                                       stderr=subprocess.STDOUT)
        try:
            yield port_of(console)
        finally:
            process.send_signal(signal.SIGKILL)
            process.wait()


def port_of(console):
    end = time.monotonic() + LIMIT_S
    while time.monotonic() < end:
        found = re.search(r"redirected to (/dev/\S+)", console.read_text())
        if found:
            return found[1]
        time.sleep(0.05)
    raise AssertionError(f"the emulator named no port: {console.read_text()}")


class Desk(harness.BoardTest):
    hil = None

    def loop(self, *arguments):
        """(exit status, what it said)"""
        with tempfile.TemporaryDirectory(prefix="axial-") as folder:
            done = subprocess.run([self.hil, "--seconds", "0.1", "--output", folder, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, timeout=5 * LIMIT_S, check=False)
        return done.returncode, done.stdout

    def test_a_loop_of_two_ports_and_again(self):
        with at_a_port(self.board, "tracking-scara") as controller, at_a_port(self.board, "arm-scara") as plant:
            ports = ("--controller", self.board, "--plant", self.board, "--controller-port", controller, "--plant-port", f"{plant}:1000000")
            for _ in range(2):  # boards go on where the last run left them: a session begins anew
                status, said = self.loop(*ports)
                self.assertEqual(status, 0, said)
                self.assertIn("100 ticks", said)
                self.assertIn("differ by 0 last places", said)

    def test_one_board_at_a_port_and_one_emulated(self):
        with at_a_port(self.board, "arm-scara") as plant:
            status, said = self.loop("--plant", self.board, "--plant-port", plant)
            self.assertEqual(status, 0, said)
            status, said = self.loop("--plant", "nrf51", "--plant-port", plant)
            self.assertNotEqual(status, 0)
            self.assertIn(f"the plant's board runs an image of scara for {self.board}, not of scara for nrf51", said)
            status, said = self.loop("--plant-port", plant, "--faults")
            self.assertNotEqual(status, 0)
            self.assertIn("--faults starts its boards anew", said)

    def test_ports_that_are_none(self):
        silent, own = os.openpty()
        with tempfile.NamedTemporaryFile(prefix="axial-") as file:
            for port, why in ((f"{file.name}.none", "No such file or directory"), (file.name, "it is no serial port"),
                              (f"{os.ttyname(own)}:1234", "there is no rate '1234'; there are: 1000000"), (os.ttyname(own), "nothing says hello")):
                status, said = self.loop("--controller", self.board, "--plant", self.board, "--plant-port", port)
                self.assertNotEqual(status, 0)
                self.assertIn(why, said)
                self.assertIn("hil: ", said)
        os.close(silent)
        os.close(own)


if __name__ == "__main__":
    Desk.hil = sys.argv.pop(2)
    harness.main()
