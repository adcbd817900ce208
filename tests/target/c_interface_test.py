"""The control loop in C99 gets, on the board, the words that C++ gets, and refuses what is to be refused."""

import struct

import emulator
import harness

ROWS, JOINTS = 16, 3
SPEED_LIMIT, NONE = 4, 0xFFFFFFFF
GRAVITY, SLIDE = 9.8125, 1.25  # m/s^2, kg: robots/scara.hpp; its slide's axis points down
ACCELERATION = 0.5  # m/s^2 of the slide: firmware/apps/c_interface/main.c


def real(word):
    return struct.unpack("<f", struct.pack("<I", word))[0]


def signed(word):
    return word - (1 << 32) if word >> 31 else word


class CInterface(harness.BoardTest):
    @classmethod
    def setUpClass(cls):
        cls.code, cls.text = emulator.run(cls.board, "c-interface")
        rows = [line.split(",") for line in cls.text.splitlines() if "," in line]
        cls.words = {kind: [[int(word, 16) for word in row[1:]] for row in rows if row[0] == kind]
                     for kind in ("c", "c++", "exponents")}

    def test_the_run_is_whole(self):
        self.assertEqual(self.code, 0, self.text)
        self.assertTrue(self.text.endswith("end\n"), self.text)
        self.assertEqual([row[0] for row in self.words["c"]], list(range(ROWS)))

    def test_c_gets_the_words_of_cxx(self):
        self.assertEqual(self.words["c"], self.words["c++"])

    def test_the_slide_bears_its_weight(self):
        exponent = signed(self.words["exponents"][0][JOINTS - 1])
        for row in self.words["c"][:-1]:
            wanted = SLIDE * (ACCELERATION - GRAVITY)
            self.assertAlmostEqual(real(row[JOINTS]), wanted, delta=1e-6 * abs(wanted))
            self.assertAlmostEqual(signed(row[2 * JOINTS + 2]) * 2.0**-exponent, wanted, delta=1e-6 * abs(wanted))

    def test_a_request_that_is_too_fast_keeps_the_last_torque(self):
        before, refused = self.words["c"][-2], self.words["c"][-1]
        self.assertEqual(before[JOINTS + 1 : JOINTS + 3], [0, NONE])
        self.assertEqual(refused[JOINTS + 1 : JOINTS + 3], [SPEED_LIMIT, 1])
        self.assertEqual(refused[-2:], [SPEED_LIMIT, 1])
        self.assertEqual(refused[1 : JOINTS + 1], before[1 : JOINTS + 1])
        self.assertIn("refused: speed outside the declared limit\n", self.text)


if __name__ == "__main__":
    harness.main()
