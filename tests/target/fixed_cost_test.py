"""What fixed point costs on cores without a floating-point unit: below the promised instructions, inside its budgets, and
the same for every state.
"""

import json
import pathlib

import harness
from size_test import BUDGETS, over_budget

import image
import measure
import size

# Of one call, sine and cosine included.
PROMISED = json.loads((pathlib.Path(__file__).parent / "promised_instructions.json").read_text(encoding="utf-8"))
ROUTINES_OF_FLOAT = ("__aeabi_f", "__aeabi_d", "__addsf3", "__subsf3", "__mulsf3", "__divsf3", "__adddf3", "__muldf3")


class FixedCost(harness.BoardTest):
    """Rows of the probes in the set `main`, measured once."""

    @classmethod
    def setUpClass(cls):
        work = [(cls.board, probe) for probe in measure.probes(cls.board)
                if probe.set == "main" and probe.scalar.startswith("fixed")]
        cls.rows = {probe: row for (_, probe), row in zip(work, size.measure_all(work))}

    def test_promised_instructions(self):
        measured = {(probe.robot, probe.algorithm, probe.scalar): row["instructions"] for probe, row in self.rows.items()}
        promised = [each for each in PROMISED if each["board"] == self.board]
        self.assertGreater(len(promised), 0)
        for each in promised:
            with self.subTest(each):
                self.assertLessEqual(measured[each["robot"], each["algorithm"], each["scalar"]], each["instructions"])

    def test_budgets(self):
        """After a change that is worth its cost, ./axial size --update-budgets writes new ones."""
        budgeted = {name for name in BUDGETS if name.startswith(self.board + "/")}
        self.assertEqual(budgeted, {f"{self.board}/{probe.name}" for probe in self.rows})
        for probe, row in self.rows.items():
            with self.subTest(probe.name):
                self.assertEqual(over_budget(row, BUDGETS[f"{self.board}/{probe.name}"]), [])

    def test_every_state_takes_the_same(self):
        for probe, row in self.rows.items():
            self.assertNotIn("instructions_max", row, probe.name)

    def test_no_static_memory_and_no_float(self):
        for probe, row in self.rows.items():
            program = image.Image(measure.path_of(self.board, probe.name))
            depths = measure.stack_depth(program)
            depths.of(program.functions[measure.KERNEL])
            reached = {name for name, address in program.functions.items() if address in depths.reached}
            self.assertIn(measure.KERNEL, reached)
            self.assertEqual([name for name in reached if name.startswith(ROUTINES_OF_FLOAT)], [], probe.name)
            self.assertEqual(row["ram_bytes"], 0, probe.name)


if __name__ == "__main__":
    harness.main()
