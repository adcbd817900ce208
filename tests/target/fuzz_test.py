"""Thousands of spoilt frames through the emulated serial port and its interrupt: the loop survives, a good frame after
any garbage is answered, nothing is lost. The host test of the same source does 100 000 (tests/hal)."""

import random

import emulator
import harness
import link

SEED = 20240922
ROUNDS = 2000


def spoilt(dice, frame):
    kind = dice.randrange(6)
    place = dice.randrange(1, len(frame))
    if kind == 0:
        return frame[:place]
    if kind == 1:
        return frame[:place] + bytes([frame[place] ^ 1 << dice.randrange(8)]) + frame[place + 1 :]
    if kind == 2:
        return frame[:place] + frame[place + 1 :]
    if kind == 3:
        return frame[:place] + bytes([dice.randrange(256)]) + frame[place:]
    if kind == 4:
        return frame[:place] + frame + frame[place:]
    return dice.randbytes(dice.randrange(160))


class Fuzz(harness.BoardTest):
    def test_a_good_frame_after_any_garbage_is_answered(self):
        dice = random.Random(SEED)
        number = 0
        with emulator.Emulator(self.board, "feedforward-planar2r") as firmware:
            for round_ in range(ROUNDS):
                bad = link.set_point([dice.uniform(-1, 1)] * 2, [0] * 2, [0] * 2)
                firmware.send(spoilt(dice, firmware.frame(link.SET_POINT, number + 1, bad)))
                number += 2
                answer = firmware.ask(number, link.set_point([0.5] * 2, [0] * 2, [0] * 2))
                self.assertEqual(answer["status"], link.OK, f"seed {SEED}, round {round_}")
            stats = firmware.stats()
        for fault in (link.BAD_COBS, link.TRUNCATED, link.OVERSIZED, link.BAD_LENGTH, link.BAD_CRC):
            self.assertGreater(stats["counters"][fault], 0, f"the garbage never caused fault {fault}")
        self.assertEqual(stats["counters"][link.OVERRUN], 0)
        self.assertGreaterEqual(stats["set_points"], ROUNDS)


if __name__ == "__main__":
    harness.main()
