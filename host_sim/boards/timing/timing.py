"""Cycles and microseconds of executed instructions on a board's core.

A core says what its figures are: `exact` (its manual gives every instruction's cycles), `validated` (against its RTL) or `estimate`, an
interval with a likely figure in it.
"""

from typing import NamedTuple

import cortex_m
import cortex_m0
import flash
import hazard3


class Core(NamedTuple):
    name: str
    kind: str
    says: str


CORES = {core.name: core for core in (
    Core("cortex-m0", "exact", "Arm DDI 0432C, multiplier of one cycle, memory without wait states"),
    Core("cortex-m0plus", "exact", "Arm DDI 0484C, multiplier of one cycle, memory without wait states; the upper end: an empty cache in front of serial flash"),
    Core("hazard3", "validated", "Hazard3 v1.0 as in the RP2350, equal to its RTL on 230 sequences; memory without wait states"),
    Core("cortex-m3", "estimate", "Arm DDI 0337: between loads that overlap, branches that refill in 1 and long products that end early, and none of it"),
    Core("cortex-m4f", "estimate", "Arm DDI 0439: between loads that overlap and branches that refill in 1, and none of it"),
    Core("cortex-m7", "estimate", "no table of Arm's: two instructions at once with the latencies of LLVM's model; low without latencies, high one instruction at a time"),
    Core("cortex-m33", "estimate", "no table of Arm's: one instruction at a time with short latencies; low two at once without any"),
)}


FIELDS = ("core", "cycles", "cycles_kind", "cycles_low", "cycles_high", "microseconds")  # of rows; low and high where they differ


class Timing(NamedTuple):
    core: Core
    clock_Hz: int
    cycles: int
    low: int
    high: int

    def fields(self):
        """As FIELDS names them."""
        interval = {} if self.low == self.high else {"cycles_low": self.low, "cycles_high": self.high}
        return {"core": self.core.name, "cycles": self.cycles, "cycles_kind": self.core.kind, **interval,
                "microseconds": round(self.cycles * 1e6 / self.clock_Hz, 2)}


class Model:
    """Of a board, by its board.json."""

    def __init__(self, board):
        described = board["timing"]
        self.core, self.clock_Hz = CORES[described["core"]], described["clock_Hz"]
        self.flash = described.get("flash")

    def of(self, run, instructions):
        """Of one run: executed addresses in order; the last one, the return, is left out."""
        low, likely, high = self._core(run.executed, instructions)
        waits = flash.waits(self.flash, run) if self.flash else 0
        return Timing(self.core, self.clock_Hz, likely, low, high + waits)

    def worst(self, runs, instructions):
        """Over runs on several states: the largest, and the interval that holds them all."""
        timings = [self.of(run, instructions) for run in runs]
        return Timing(self.core, self.clock_Hz, max(t.cycles for t in timings), min(t.low for t in timings),
                      max(t.high for t in timings))

    def _core(self, executed, instructions):
        name = self.core.name
        if name == "hazard3":
            short = hazard3.cycles(executed, instructions)
            long = hazard3.cycles(executed, instructions, lambda _: True) if hazard3.signed_divisions(executed, instructions) else short
            return short, long, long
        if name in cortex_m0.TABLES:
            return (cortex_m0.cycles(name, executed, instructions),) * 3
        return cortex_m.cycles(name, executed, instructions)
