"""A UF2 file of an image: every block as the boot ROM wants it, the bytes of the linker, and it runs."""

import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import emulator
import harness

sys.path.insert(0, str(emulator.ROOT / "host_sim/boards/rp2040"))
import uf2  # noqa: E402


def wrong(data):
    """What the boot ROM, or a reader of the format, would not take; empty where nothing is."""
    if not data or len(data) % 512:
        return ["a file is of blocks of 512 bytes"]
    found, count = [], len(data) // 512
    for at in range(count):
        block = data[at * 512:(at + 1) * 512]
        begin, second, flags, address, size, number, told, family = struct.unpack_from("<8I", block)
        for holds, what in ((begin == 0x0A324655 and second == 0x9E5D5157 and block[508:] == b"\x30\x6f\xb1\x0a", "magic"),
                            (flags == 0x2000 and family == 0xE48BFF56, "family"), (size == 256, "payload"),
                            (address == 0x10000000 + 256 * at, "address"), ((number, told) == (at, count), "number"),
                            (not any(block[32 + 256:508]), "rest")):
            if not holds:
                found.append(f"block {at}: {what}")
    return found


class Uf2(harness.BoardTest):
    @classmethod
    def setUpClass(cls):
        cls.elf = emulator.image(cls.board, "selftest-scara")
        cls.folder = tempfile.TemporaryDirectory(prefix="axial-")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.file = pathlib.Path(cls.folder.name) / "image.uf2"
        subprocess.run([emulator.ROOT / "host_sim/boards/rp2040/uf2.py", cls.elf, cls.file], check=True, stdout=subprocess.DEVNULL)
        cls.data = cls.file.read_bytes()

    def test_every_block_is_as_the_format_has_it(self):
        self.assertEqual(wrong(self.data), [])

    def test_a_spoilt_byte_is_noticed(self):
        """Negative control, of the check and of the emulator's own reader: a byte of each field."""
        for field, byte in {"magic": 0, "family": 28, "payload": 16, "address": 13, "number": 20, "rest": 300}.items():
            spoilt = bytearray(self.data)
            spoilt[512 + byte] ^= 1
            self.assertEqual(wrong(spoilt), [f"block 1: {field}"])
        self.assertEqual(wrong(self.data[:-1]), ["a file is of blocks of 512 bytes"])

    def test_payloads_are_what_the_linker_wrote(self):
        binary = pathlib.Path(self.folder.name) / "image.bin"
        subprocess.run(["arm-none-eabi-objcopy", "-O", "binary", "--gap-fill", "0xff", self.elf, binary], check=True)
        payloads = b"".join(self.data[at + 32:at + 288] for at in range(0, len(self.data), 512))
        linked = binary.read_bytes()
        self.assertEqual(payloads[:len(linked)], linked)
        self.assertEqual(set(payloads[len(linked):]) - {0xFF}, set())
        self.assertLess(len(payloads) - len(linked), 256)

    def test_it_runs(self):
        done = subprocess.run(emulator.command(self.board, self.file, "null"), capture_output=True, text=True, timeout=60, check=False)
        self.assertRegex(done.stdout, r"\n[1-9]\d* checks, 0 failed\n")

    def test_an_image_whose_boot_stage_is_spoilt_does_not_start(self):
        """Negative control: one bit of boot2, then the emulator's boot ROM refuses it; one of a magic, then its reader."""
        for byte, said in (32, "checksum"), (4, "UF2"):
            spoilt = bytearray(self.data)
            spoilt[byte] ^= 1
            path = pathlib.Path(self.folder.name) / "spoilt.uf2"
            path.write_bytes(spoilt)
            done = subprocess.run(emulator.command(self.board, path, "null"), capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 3)
            self.assertIn(said, done.stderr)

    @unittest.skipUnless(shutil.which("file"), "there is no program `file`")
    def test_file_recognises_it(self):
        done = subprocess.run(["file", "-b", self.file], capture_output=True, text=True, check=True)
        self.assertIn("RP2040", done.stdout)

    def test_an_image_of_another_board_is_refused(self):
        with self.assertRaises(uf2.Refused):
            uf2.uf2(b"not ELF")
        moved = bytearray(self.elf.read_bytes())
        at = struct.unpack_from("<I", moved, 28)[0]
        for header in range(at, at + 32 * struct.unpack_from("<H", moved, 44)[0], 32):
            struct.pack_into("<I", moved, header + 12, 0x08000000 + 4096 * header)
        with self.assertRaises(uf2.Refused):
            uf2.uf2(bytes(moved))


if __name__ == "__main__":
    harness.main()
