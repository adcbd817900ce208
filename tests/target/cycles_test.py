"""Cycles of the Cortex-M0+ by Arm's table (host_sim/boards/timing) against an emulator that counts its own: for every pair of instructions that
whole programs execute one after the other, kernels in fixed point, float and double among them."""

import collections
import functools
import pathlib
import subprocess
import sys
import tempfile
import unittest

import emulator
import harness

sys.path[:0] = [str(emulator.ROOT / "host_sim/boards" / folder) for folder in ("size", "timing")]
import cortex_m0  # noqa: E402
import image  # noqa: E402

PROGRAMS = {"fixed-puma560": 40_000, "kernels-scara": 14_000}  # and how many pairs they have at least


@functools.lru_cache
def steps(board, path):
    """[(from, to, cycles)] of a run, the first one."""
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        file = pathlib.Path(folder, "steps")
        subprocess.run([*emulator.command(board, path, "null", fast=True), "-steps", file], check=True, stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, timeout=200)
        return [(int(begin, 16), int(end, 16), int(cycles)) for begin, end, cycles in map(str.split, file.read_text(encoding="utf-8").splitlines())]


def is_known(instruction, by_manual, emulated, function):
    """Where rp2040js is known to count otherwise. Peripherals, which take more or, on the core's own port, less than memory, are the
    board's business."""
    if cortex_m0.is_short_in_rp2040js(instruction):
        return emulated == by_manual - 1
    return instruction.name.startswith(("ldr", "str")) and (function in ("main", "axial_reset") or "3hal" in function or "4apps" in function)


class Cycles(harness.BoardTest):
    def differences(self, program):
        read = image.Image(emulator.image(self.board, program))
        found, pairs = collections.Counter(), 0
        for begin, end, cycles in steps(self.board, read.path):
            if begin not in read.instructions:  # boot2, in RAM
                continue
            pairs += 1
            instruction = read.instructions[begin]
            by_manual = cortex_m0.cost(cortex_m0.TABLES["cortex-m0plus"], instruction, end != begin + instruction.size)
            if cycles != by_manual and not is_known(instruction, by_manual, cycles, read.function_at(begin)):
                found[f"{read.function_at(begin)}: {instruction.name} {instruction.operands}: {by_manual}, emulated {cycles}"] += 1
        return pairs, found

    def test_every_executed_instruction_takes_what_the_emulator_counts(self):
        for program, least in PROGRAMS.items():
            with self.subTest(program):
                pairs, found = self.differences(program)
                self.assertGreaterEqual(pairs, least)
                self.assertEqual(dict(found), {})

    def test_another_table_is_noticed(self):
        """Negative control: the Cortex-M0's branches take one more."""
        mine = cortex_m0.TABLES["cortex-m0plus"]
        self.addCleanup(cortex_m0.TABLES.__setitem__, "cortex-m0plus", mine)
        cortex_m0.TABLES["cortex-m0plus"] = mine._replace(branch=3)
        self.assertTrue(self.differences("kernels-scara")[1])


if __name__ == "__main__":
    harness.main()
