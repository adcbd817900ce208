"""Built with -Ofast, and with -ffast-math in the user's options: no call says ok of NaN or infinity."""

import emulator
import harness


class HostileNumbers(harness.BoardTest):
    def test_no_call_takes_them_for_numbers(self):
        for image in ("hostile", "hostile-user-options"):
            with self.subTest(image):
                code, text = emulator.run(self.board, image)
                self.assertEqual(code, 0, text)
                self.assertRegex(text, r"\n?[1-9]\d* calls, 0 wrong\n", "the verdict is missing")


if __name__ == "__main__":
    harness.main()
