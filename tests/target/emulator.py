"""An image in its board's emulator, QEMU or a runner of ours, with its serial port on a socket."""

import json
import os
import pathlib
import random
import select
import socket
import struct
import subprocess
import tempfile
import time

import link

ROOT = pathlib.Path(__file__).resolve().parents[2]
KERNEL = ("-kernel", "{}")  # how QEMU takes an image, where board.json has no other way
IMAGES = pathlib.Path(os.environ.get("AXIAL_IMAGES_ROOT", ROOT / "build"))


def board(name):
    return json.loads((ROOT / "hal" / "boards" / name / "board.json").read_text())


def image(board_name, name):
    path = IMAGES / board_name / "images" / (name + ".elf")
    if not path.exists():
        raise FileNotFoundError(f"{path}: build the images first (./axial test --filter does)")
    return path


def runs_here(board_name):
    """Whether the board's emulator is installed; says so where it is not."""
    runner = board(board_name).get("runner")
    done = runner and subprocess.run(["sh", "-c", '"$@"', "sh", runner["program"], str(ROOT / runner["script"]), "-check"],
                                     stdin=subprocess.DEVNULL, check=False)
    return not done or done.returncode == 0


def command(board_name, path, serial, semihosting=True, fast=False):
    """`fast`: time that the board sleeps passes at once."""
    described = board(board_name)
    if "runner" in described:
        runner, switches = described["runner"], {"-no-semihosting": not semihosting, "-fast": fast}
        return [runner["program"], str(ROOT / runner["script"]), *runner["arguments"], *(name for name, on in switches.items() if on),
                "-kernel", str(path), "-serial", serial]
    qemu = described["qemu"]
    arguments = qemu["arguments"]
    if not semihosting:
        at = arguments.index("-semihosting-config")
        arguments = arguments[:at] + arguments[at + 2 :]
    if fast:
        arguments = [argument + ",sleep=off" if argument.startswith("shift=") else argument for argument in arguments]
    return [qemu["program"], *arguments, *(part.format(path) for part in qemu.get("image", KERNEL)), "-serial", serial]


def run(board_name, name, timeout=120):
    """Runs an image that ends by itself: (exit code, what it printed)."""
    done = subprocess.run(command(board_name, image(board_name, name), "null"), stdin=subprocess.DEVNULL, timeout=timeout,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


class Emulator:
    """The main job on an emulated board. This side listens before QEMU starts, so the hello frame is not lost."""

    def __init__(self, board_name, name, semihosting=True, mode=link.LOCK_STEP, fast=False):
        """`mode`: of the session that is opened; None for none."""
        self.session = link.NO_SESSION
        self.folder = tempfile.TemporaryDirectory(prefix="axial-")
        # A UNIX socket takes some 270 single bytes and no more until somebody reads; then the board drops what it says.
        with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as listener:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
            listener.bind(("127.0.0.1", 0))
            listener.listen(1)
            listener.settimeout(20)
            address = f"tcp:127.0.0.1:{listener.getsockname()[1]}"
            self.printed = pathlib.Path(self.folder.name, "console")  # read apart: one file position for both would move where it writes
            with self.printed.open("w") as printed:
                self.process = subprocess.Popen(command(board_name, image(board_name, name), address, semihosting, fast),
                                                stdin=subprocess.DEVNULL, stdout=printed, stderr=subprocess.STDOUT)
            self.line, _ = listener.accept()
        self.line.setblocking(False)
        self.pending = bytearray()
        self.unsent = bytearray()
        self.greeting = self.hello = link.hello(self.expect(link.HELLO)[1])
        self.session = self.hello["session"]
        if mode is not None:
            self.opened = self.open(mode)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.line.close()
        self.process.kill()
        self.process.wait()
        self.folder.cleanup()

    def open(self, mode, number=0):
        """A session, whose set-points are counted from `number`; the frames that opened it. Whoever names an old one is told
        the present one, and so is the first after a reset."""
        nonce = random.randrange(1, 1 << 32)
        sent = b""
        self.session = None  # what is still on its way may be of another
        while self.hello["nonce"] != nonce:
            frame = link.frame(link.START, number, link.start(mode, self.hello["session"], nonce))
            self.send(frame)
            sent += frame
            self.hello = link.hello(self.expect(link.HELLO)[1])
        self.session = self.hello["session"]
        return sent

    def frame(self, kind, sequence, payload=b""):
        """A frame of the session."""
        return link.frame(kind, sequence, payload, self.session)

    def console(self):
        """What image and emulator have printed so far."""
        return self.printed.read_text(encoding="utf-8")

    def send(self, data):
        self.unsent += data
        self._pump(0)

    def receive(self, timeout=20.0):
        """The next frame as (type, sequence, payload); None when none comes in time."""
        piece = self._next_piece(timeout)
        return link.parse(piece, self.session) if piece else None

    def until_restart(self):
        """Frames until the board starts again, its hello the last one. A restart cuts short what was being sent: that
        frame, the last before the hello, is left out."""
        frames, cut = [], None
        while not frames or frames[-1][0] != link.HELLO:
            piece = self._next_piece(20.0)
            if piece is None:
                raise TimeoutError(f"no restart; the console says: {self.console()}")
            try:
                frames.append(link.parse(piece, self.session))
            except (ValueError, struct.error) as why:
                if cut:
                    raise cut
                cut = why
                continue
            if cut and frames[-1][0] != link.HELLO:
                raise cut
        return frames

    def expect(self, kind, timeout=20.0):
        """(sequence, payload) of the next frame of a type; others are passed over."""
        while True:
            got = self.receive(timeout)
            if got is None:
                raise TimeoutError(f"no frame of type {kind}; the console says: {self.console()}")
            if got[0] == kind:
                return got[1], got[2]

    def ask(self, sequence, payload):
        """One lock-step tick: the torque for a set-point."""
        self.send(self.frame(link.SET_POINT, sequence, payload))
        while True:
            number, answer = self.expect(link.TORQUE)
            if number == sequence and link.torque(answer)["status"] != link.WATCHDOG:
                return link.torque(answer)

    def listen(self, seconds):
        """Waits, and reads meanwhile."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self._pump(max(end - time.monotonic(), 0))

    def stats(self, sequence=0):
        self.send(link.frame(link.STATS_REQUEST, sequence))
        return link.stats(self.expect(link.STATS)[1])

    def _next_piece(self, timeout):
        """What comes next between two delimiters; None when nothing does in time."""
        end = time.monotonic() + timeout
        while True:
            piece = self._piece()
            if piece:
                return piece
            if piece is None:
                left = end - time.monotonic()
                if left <= 0 or not self._pump(left):
                    return None

    def _piece(self):
        end = self.pending.find(0)
        if end < 0:
            return None
        piece = bytes(self.pending[:end])
        del self.pending[: end + 1]
        return piece

    def _pump(self, timeout):
        """Moves bytes both ways; False when the board hung up."""
        readable, writable, _ = select.select([self.line], [self.line] if self.unsent else [], [], timeout)
        if writable:
            del self.unsent[: self.line.send(self.unsent)]
        if readable:
            got = self.line.recv(65536)
            self.pending += got
            return bool(got)
        return True
