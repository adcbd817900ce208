"""The report's rows and ./axial choose: fronts, joins, answers, errors; on data made up here and on the committed data.

usage: report_test.py [unittest arguments]
"""

import argparse
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/figures/report"))
import choose  # noqa: E402
import kernels  # noqa: E402
import other_rows  # noqa: E402
import page  # noqa: E402
import pareto  # noqa: E402
import report  # noqa: E402
import snippet  # noqa: E402
import verify  # noqa: E402

COMMITTED = json.loads(choose.DATA.read_text(encoding="utf-8"))


class Pareto(unittest.TestCase):
    def test_keeps_what_nothing_else_beats(self):
        self.assertEqual(pareto.front([(1e-7, 300), (1e-16, 9000), (2e-7, 301), (1e-7, 299), (5e-8, 800)]), [False, True, False, True, True])

    def test_keeps_equals(self):
        self.assertEqual(pareto.front([(1.0, 1.0), (1.0, 1.0)]), [True, True])

    def test_marks_each_group_alone(self):
        rows = [{"of": "a", "error": 1.0, "work": 1}, {"of": "a", "error": 2.0, "work": 2}, {"of": "b", "error": 3.0, "work": 3}]
        pareto.mark(rows, lambda row: row["of"])
        self.assertEqual([row["pareto"] for row in rows], [True, False, True])


def error_row(algorithm="inverse_dynamics", scalar="float", scene="bare", error=1e-7):
    return {"robot": "scara", "scene": scene, "algorithm": algorithm, "variant": "unrolled", "scalar": scalar, "states": 2, "error": error,
            "error_rms": error / 2}


def timed(board, cycles):
    kind = "exact" if board == "nrf51" else "estimate"
    return {"cycles_estimated": cycles, "core": "a core", "cycles": cycles, "cycles_kind": kind, "microseconds": cycles / 16}


def size_row(row, instructions, flash=100, board="nrf51", contract="off"):
    names = {name: row[name] for name in kernels.KEY}
    return {**names, "board": board, "contract": contract, "instructions": instructions, **timed(board, 2 * instructions),
            "flash_bytes": flash, "ram_bytes": 0, "stack_bytes": 8}


class Rows(unittest.TestCase):
    def test_join_errors_with_costs_in_three_units(self):
        error = error_row()
        rows = kernels.joined([error], [size_row(error, 50), size_row(error, 40, contract="fast"), size_row(error_row("feedforward"), 60)])
        self.assertEqual([(row["work"], row["unit_of_work"]) for row in rows], [(50, "instructions"), (6.25, "microseconds"), (108, "bytes")])
        for field in other_rows.FIELDS:
            self.assertIn(field, rows[0])

    def test_the_closed_form_competes_with_inverse_dynamics(self):
        closed, recursive = error_row("closed_form", error=1e-8), error_row()
        rows = kernels.joined([closed, recursive], [size_row(closed, 40), size_row(recursive, 50)])
        front = {row["subject"]: row["pareto"] for row in rows if row["unit_of_work"] == "instructions"}
        self.assertEqual(front, {"closed_form": True, "inverse_dynamics": False})

    def test_derivatives_are_jobs_of_their_own_and_no_route(self):
        both = [error_row("forward_dynamics_derivatives"), error_row("forward_dynamics_composite_body", error=1e-8)]
        rows = kernels.joined(both, [size_row(both[0], 50), size_row(both[1], 40)])
        self.assertEqual({(row["job"], row["variant"]) for row in rows},
                         {("forward_dynamics_derivatives", "unrolled"), ("forward_dynamics", "composite body, unrolled")})
        self.assertTrue(all(row["pareto"] for row in rows))

    def test_derivatives_have_a_row_for_each_block(self):
        figures = {"error": 1e-7, "error_in_state": 2e-7}
        rows = kernels.derivatives([error_row(), {**error_row("inverse_dynamics_derivatives"), "blocks": {"M": figures}}])
        self.assertEqual([(row["block"], row["error_in_state"]) for row in rows], [("M", 2e-7)])

    def test_errors_of_an_earlier_report_make_the_same_rows(self):
        """Costs may be measured anew, board by board, and errors stay."""
        sizes = json.loads((ROOT / "doc/data/size.json").read_text(encoding="utf-8"))
        again = kernels.joined(report.errors_in(choose.DATA), sizes)
        self.assertEqual(again, [row for row in COMMITTED if "job" in row])
        self.assertIn("rp2040", {row["board"] for row in again})

    def test_given_pairs_are_a_job_of_their_own(self):
        plain, given = error_row(), error_row(scene="sine_cosines")
        rows = kernels.joined([plain, given], [size_row(plain, 50), size_row(given, 40)])
        self.assertTrue(all(row["pareto"] for row in rows if row["unit_of_work"] == "instructions"))

    def test_two_rates_have_the_worst_tick(self):
        row = {"robot": "scara", "ticks": 4, "error": 1e-2, "error_ahead": 5e-3, "nrf51_per_tick": 10, "nrf51_worst_tick": 40, "nrf51_full_rate": 20}
        rows = other_rows.two_rate({"two_rate": [row]})
        self.assertEqual([(each["error"], each["work"], each["work_worst"], each["pareto"]) for each in rows],
                         [(1e-2, 10, 40, False), (5e-3, 10, 40, True)])

    def test_rows_of_others_must_have_the_fields(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(other_rows.found(folder, "simulation.json"), [])
            (pathlib.Path(folder) / "simulation.json").write_text('[{"subject": "swing"}]', encoding="utf-8")
            with self.assertRaisesRegex(ValueError, "simulation.json: rows without board, error"):
                other_rows.found(folder, "simulation.json")

    def test_the_page_holds_every_row_and_no_reference(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "page.html"
            page.write(file, COMMITTED, [], [], None)
            text = file.read_text(encoding="utf-8")
        data = json.loads(text.split("const data = ")[1].split(";\nconst")[0])
        self.assertEqual(len(data["rows"]), len(COMMITTED))
        self.assertNotRegex(text, r'(src|href)="(?!data:)')


def run(*arguments):
    """(exit status, output, messages)"""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = choose.main(list(arguments))
        except SystemExit as end:
            status = end.code
    return status, out.getvalue(), err.getvalue()


class Choose(unittest.TestCase):
    rows = [{"error": error, "work": work, "unit_of_work": "instructions", "subject": name, "scalar": "float", "variant": "unrolled"}
            for name, error, work in (("a", 1e-3, 10), ("b", 1e-6, 100), ("c", 1e-6, 90), ("d", 1e-9, 1000))]

    def names(self, rows):
        return "".join(row["subject"] for row in rows)

    def test_cheapest_inside_an_error(self):
        self.assertEqual(self.names(choose.cheapest(self.rows, 1e-6)), "cbd")
        self.assertEqual(self.names(choose.cheapest(self.rows, 1e-8)), "d")

    def test_most_exact_inside_a_budget(self):
        self.assertEqual(self.names(choose.most_exact(self.rows, 100)), "cba")
        self.assertEqual(self.names(choose.most_exact(self.rows, 10)), "a")

    def test_what_is_nearest_where_nothing_is_inside(self):
        with self.assertRaisesRegex(choose.Refused, "at most 1e-12; nearest is d, float"):
            choose.cheapest(self.rows, 1e-12)
        with self.assertRaisesRegex(choose.Refused, "at most 9 instructions; nearest is a, float"):
            choose.most_exact(self.rows, 9)

    def test_of_the_committed_data(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "chosen.json"
            status, out, err = run("--robot", "puma560", "--board", "stm32f100", "--error", "1e-4", "--budget", "8000", "--json", str(file))
            chosen = json.loads(file.read_text(encoding="utf-8"))
        self.assertEqual((status, err), (0, ""))
        inside = [row for row in COMMITTED if (row.get("job"), row["robot"], row["board"], row["unit_of_work"]) ==
                  ("inverse_dynamics", "puma560", "stm32f100", "instructions")]
        self.assertEqual(chosen[0]["work"], min(row["work"] for row in inside if row["error"] <= 1e-4))
        self.assertEqual(chosen[1]["error"], min(row["error"] for row in inside if row["work"] <= 8000))
        self.assertIn(snippet.lines(chosen[0])[0], out)

    def test_every_robot_and_board_has_an_answer(self):
        for robot, board in {(row["robot"], row["board"]) for row in COMMITTED if row.get("job") == "inverse_dynamics"}:
            with self.subTest(robot=robot, board=board):
                status, out, err = run("--robot", robot, "--board", board)
                self.assertEqual((status, err), (0, ""))
                self.assertIn("using Scene = axial::Scene<robots::", out)

    def test_unknown_names_are_listed(self):
        for arguments, message in ((("--robot", "puma", "--board", "stm32f100"), "unknown robot 'puma'; there are: panda, planar2r, puma560"),
                                   (("--robot", "puma560", "--board", "nrf52"), "unknown board 'nrf52'; there are: "),
                                   (("--robot", "puma560", "--board", "stm32f100", "--algorithm", "dynamics"), "unknown algorithm 'dynamics'"),
                                   (("--robot", "puma560", "--board", "stm32f100", "--error", "-1"), "-1 is not above 0"),
                                   (("--robot", "puma560", "--board", "stm32f100", "--torque"), "--torque is of forward_dynamics")):
            status, out, err = run(*arguments)
            self.assertEqual((status, out), (2, ""))
            self.assertIn(message, err)

    def test_nothing_inside_says_what_is_nearest(self):
        status, _, err = run("--robot", "puma560", "--board", "stm32f100", "--error", "1e-30")
        self.assertEqual(status, 1)
        self.assertIn("no configuration has an error of at most 1e-30; nearest is inverse dynamics, double", err)

    def test_targets_are_probes_of_the_matrix(self):
        status, out, _ = run("--robot", "puma560", "--board", "stm32f100", "--error", "1e-4", "--targets")
        self.assertEqual(status, 0)
        self.assertEqual(out.splitlines()[0].split()[0], "stm32f100")
        self.assertRegex(out, r"size-puma560-bare-\w+-unrolled-off")

    def test_lines_compile_for_every_kind_of_kernel(self):
        """A row of each algorithm, scene, form and number system: the lines compile, to the scene of the probe."""
        kinds = {}
        for row in COMMITTED:
            if "job" in row and row["robot"] == "scara":
                for kind in (row["algorithm"], row["scene"], row["form"], row["scalar"]):
                    kinds.setdefault(kind, row)
        rows = {snippet.check(row): row for row in kinds.values()}
        self.assertGreaterEqual(len(rows), 8)
        verify.compile_lines(list(rows.values()))

    def test_the_emulator_that_counted_is_named(self):
        for board, emulator in (("stm32f405", "by QEMU"), ("rp2040", "by rp2040js")):
            self.assertIn(emulator, run("--robot", "puma560", "--board", board, "--error", "1e-4")[1])

    def test_lines_of_derivatives_compile(self):
        rows = [dict(error_row(f"{of}_dynamics_derivatives", scalar), form=form)
                for of in ("inverse", "forward") for scalar, form in (("float", "unrolled"), ("double", "compact"))]
        verify.compile_lines(rows)

    def test_lines_of_elastic_joints_compile(self):
        rows = [dict(error_row("elastic_feedforward", scalar, "elastic"), form=form) for scalar, form in (("float", "unrolled"), ("double", "compact"))]
        self.assertIn("axial::Scene<axial::apps::Elastic<robots::Scara, 12>, axial::Gravity", snippet.lines(rows[0])[0])
        verify.compile_lines(rows)

    def test_lines_of_another_scene_do_not_pass(self):
        row = next(row for row in COMMITTED if row.get("scalar") == "fixed32_high" and row["robot"] == "scara")
        for printed, other in (("axial::HighWord", "axial::RoundDown"), ("<Scene>(q", "<Scene>(qq")):
            wrong = snippet.check(row).replace(printed, other, 1)
            self.assertNotEqual(wrong, snippet.check(row))
            with unittest.mock.patch.object(snippet, "check", lambda _, wrong=wrong: wrong), self.assertRaises(verify.Broken):
                verify.compile_lines([row])


class Verified(unittest.TestCase):
    """A chosen kernel, built already: it is what the committed data says, but for what budgets allow (./axial report --documents writes
    new data). Negative control: another figure is noticed."""
    host = None
    COST, ERROR = 0.02, 0.05

    def chosen(self):
        return next(row for row in COMMITTED if row.get("algorithm") == "inverse_dynamics" and
                    (row["robot"], row["board"], row["scalar"], row["unit_of_work"]) == ("puma560", "stm32f100", "fixed32_high", "instructions"))

    def test_promises_hold(self):
        if self.host is None:
            self.skipTest("no build was named (--host)")
        row = self.chosen()
        cost, error = verify.measured(row, self.host)
        verify.compare(row, cost, error, self.COST, self.ERROR)
        for name in ("instructions", "flash_bytes", "error"):
            with self.subTest(name), self.assertRaisesRegex(verify.Broken, name):
                verify.compare({**row, name: row[name] * 1.1}, cost, error, self.COST, self.ERROR)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--host", type=pathlib.Path)
    known, others = parser.parse_known_args()
    Verified.host = known.host
    unittest.main(argv=[sys.argv[0], *others])
