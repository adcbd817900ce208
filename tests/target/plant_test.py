"""A robot that a board integrates: the host's bits, inside its gates, a step in one count, and no arithmetic that the board has not.

usage: plant_test.py BOARD HOST_PROGRAM
"""

import pathlib
import sys

import emulator
import harness
import symbols_test

sys.path.insert(0, str(emulator.ROOT / "host_sim/plants/real_time"))
import on_board  # noqa: E402

HOST = pathlib.Path(sys.argv.pop(2))
ROBOT = "scara"
WITH_FPU = ("stm32f405",)


class PlantOnBoard(harness.BoardTest):
    def plant(self, number, method="runge_kutta_4", steps_per_tick=1):
        return on_board.Plant(HOST, self.board, ROBOT, number, method, steps_per_tick)

    def expect_good(self, row):
        self.assertTrue(row["pass"], row)
        self.assertTrue(row["same_bits"], f"off by {row['difference']}")
        self.assertTrue(row["made"])
        self.assertGreater(row["error"], 0.0, "something is left")
        self.assertAlmostEqual(row["real_time_factor"], 1e6 * row["step_s"] / row["microseconds"], delta=1e-3 * row["real_time_factor"])
        self.assertLessEqual(row["real_time_factor_low"], 1.001 * row["real_time_factor"])

    def test_a_second_in_words(self):
        row, way = self.plant("fixed32").second()
        self.expect_good(row)
        self.assertLessEqual(row["error"], 1e-6)
        self.assertNotIn("instructions_min", row, "one count for every step")
        self.assertNotIn("cycles_min", row, "one count for every step")
        self.assertEqual(len(way["errors"]), 1000)
        print(f"{ROBOT} on {self.board}: {row['instructions']} instructions, {row['microseconds']} us ({row['kind']}), error {row['error']:.1e}")

    def test_a_second_in_float(self):
        row, _ = self.plant("float").second()
        self.expect_good(row)
        if self.board in WITH_FPU:
            self.assertNotIn("instructions_min", row, "one count for every step")

    def test_shorter_steps_of_a_simpler_method(self):
        """Euler's error falls with the step, and a tick's efforts are held over its steps."""
        errors = []
        for steps_per_tick in (1, 10):
            row, _ = self.plant("fixed32", "semi_implicit", steps_per_tick).second()
            self.expect_good(row)
            errors.append(row["error"])
        self.assertAlmostEqual(errors[0] / errors[1], 10.0, delta=1.0)

    def test_a_wrong_effort_is_seen(self):
        """Negative control: one word of the input in its last bit but seven."""
        plant = self.plant("fixed32")
        request = plant.request("driven", 20, 1)
        words = on_board.asked(HOST, request)["words"]
        words[on_board.HEAD + 4 * 3 + 3 * 10] ^= 128
        said = plant.run(words)
        self.assertFalse(on_board.asked(HOST, {**request, "states": said.states})["same_bits"])
        self.assertTrue(on_board.asked(HOST, {**request, "states": said.states[:10]})["same_bits"], "until that tick")

    def test_nothing_forbidden_is_linked(self):
        for number in ("float", "fixed32"):
            symbols = symbols_test.defined(self.plant(number).path)
            forbidden = [*symbols_test.FORBIDDEN.values(), symbols_test.SOFT_DOUBLE]
            if number == "fixed32" or self.board in WITH_FPU:
                forbidden.append(symbols_test.SOFT_FLOAT)
            for pattern in forbidden:
                with self.subTest(number=number, pattern=pattern):
                    self.assertEqual(symbols_test.offenders(symbols, pattern), [])


if __name__ == "__main__":
    harness.main()
