"""The Python side of the link against bytes worked out by hand, before it judges the firmware."""

import unittest
import zlib

import link


class Stuffing(unittest.TestCase):
    def test_worked_examples(self):
        for data, coded in (("", "01"), ("00", "0101"), ("11220033", "0311220233"), ("11000000", "0211010101")):
            self.assertEqual(link.stuff(bytes.fromhex(data)).hex(), coded)

    def test_long_blocks(self):
        run = bytes(range(1, 255))
        self.assertEqual(link.stuff(run), b"\xff" + run)
        self.assertEqual(link.stuff(run + b"\x07"), b"\xff" + run + b"\x02\x07")
        self.assertEqual(link.stuff(run + b"\0"), b"\xff" + run + b"\x01\x01")

    def test_gives_back_any_data(self):
        for length in range(600):
            data = bytes((i * 37 + length) % (3 + length % 250) for i in range(length))
            coded = link.stuff(data)
            self.assertNotIn(0, coded)
            self.assertEqual(link.unstuff(coded), data)


class Frames(unittest.TestCase):
    def test_documented_bytes(self):
        self.assertEqual(zlib.crc32(b"123456789"), 0xCBF43926)
        self.assertEqual(link.body(2, 0x12345678, b"abc")[:-4].hex(), "02785634120300616263")

    def test_the_session_is_part_of_the_crc(self):
        plain, marked = link.body(2, 1, b"abc"), link.body(2, 1, b"abc", 0x01020304)
        self.assertEqual(plain[:-4], marked[:-4])
        self.assertEqual(bytes(a ^ b for a, b in zip(plain[-4:], marked[-4:])).hex(), "04030201")
        self.assertEqual(link.parse(link.stuff(marked), 0x01020304), (2, 1, b"abc"))
        self.assertEqual(link.parse(link.stuff(plain), 0x01020304), (2, 1, b"abc"))
        with self.assertRaises(ValueError):
            link.parse(link.stuff(marked), 0x01020305)

    def test_parse_refuses_a_wrong_crc(self):
        good = link.body(2, 1, b"abc")
        self.assertEqual(link.parse(link.stuff(good)), (2, 1, b"abc"))
        with self.assertRaises(ValueError):
            link.parse(link.stuff(good[:-1] + bytes([good[-1] ^ 1])))


if __name__ == "__main__":
    unittest.main(verbosity=2)
