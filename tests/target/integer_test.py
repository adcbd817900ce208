"""What the integer primitives cost on the target: the lines `count,<name>,<n>` of the self-test, which checks their bits."""

import re

import emulator
import harness

# Instructions at most, operands loaded and the result stored; narrow factors are made narrow in 2 or 3 of them.
SHORT = {"multiply": 22, "multiply_narrow": 22, "multiply_high": 23, "multiply_high_narrow": 23,
         "multiply_high_unsigned": 26, "accumulate": 26, "accumulate_narrow": 26, "deduct": 26, "deduct_narrow": 26,
         "sincos": 201, "reciprocal": 66}
LONG = {"multiply": 3, "multiply_narrow": 7, "multiply_high": 4, "multiply_high_narrow": 8, "multiply_high_unsigned": 4,
        "accumulate": 6, "accumulate_narrow": 8, "deduct": 7, "deduct_narrow": 10, "sincos": 52, "reciprocal": 35}
# No multiply and accumulate, no count of leading zeros: carries and halvings are instructions.
RISCV = {"multiply": 6, "multiply_narrow": 9, "multiply_high": 5, "multiply_high_narrow": 8, "multiply_high_unsigned": 5,
         "accumulate": 12, "accumulate_narrow": 15, "deduct": 12, "deduct_narrow": 15, "sincos": 71, "reciprocal": 65}
# Cycles of the Cortex-M0+, whose loads and stores take 2.
CYCLES = {"multiply": 31, "multiply_narrow": 31, "multiply_high": 32, "multiply_high_narrow": 32, "multiply_high_unsigned": 35,
          "accumulate": 41, "accumulate_narrow": 41, "deduct": 41, "deduct_narrow": 41, "sincos": 223, "reciprocal": 81}
BUDGETS = {"nrf51": SHORT, "rv32_virt": RISCV, "rp2040": CYCLES}

BY_CALL = {**SHORT, "multiply": 30, "multiply_narrow": 33, "accumulate": 30, "accumulate_narrow": 33, "deduct": 30,
           "deduct_narrow": 33}


class Integers(harness.BoardTest):
    def counts(self, image):
        code, text = emulator.run(self.board, image)
        self.assertEqual(code, 0, text)
        self.assertRegex(text, r"\n[1-9]\d* checks, 0 failed\n")
        return {name: int(count) for name, count in re.findall(r"^count,(\w+),(\d+)$", text, re.MULTILINE)}

    def check(self, counts, budget):
        self.assertGreater(counts.pop("nothing"), 0)
        self.assertGreater(counts.pop("known"), 0)
        self.assertEqual(counts.keys(), budget.keys())
        self.assertEqual([f"{name}: {counts[name]}, budget {most}" for name, most in budget.items() if counts[name] > most],
                         [])
        self.assertGreaterEqual(counts["multiply"], 17 if self.board == "nrf51" else 1, "it cannot be that few")

    def test_counts(self):
        self.check(self.counts("selftest"), BUDGETS.get(self.board, LONG))

    def test_products_by_call(self):
        """The same bits, which the image checks."""
        if self.board != "nrf51":
            self.skipTest("has a long multiplication")
        self.check(self.counts("integers-by-call"), BY_CALL)


if __name__ == "__main__":
    harness.main()
