"""Cycles of the Cortex-M3, M4F, M7 and M33: intervals.

M3 and M4F from their manuals (Arm DDI 0337, DDI 0439: 3.3, 7.2.3), which leave open how a branch refills the pipeline (1 to 3 cycles), how
long a division (2 to 12) and, on the M3, a long product takes (early termination depends on data). Arm publishes no table of the M7 and M33:
those are scoreboards, the M7's with the latencies of LLVM's ARMScheduleM7.td (3, fused 6, divide 16), and say so by their spread.
"""

import re
from typing import NamedTuple

from operands import CONDITIONS, access, words

SINGLE_LOAD = re.compile(r"^(ldr(?!d)|vldr)")
SINGLE_STORE = re.compile(r"^(str(?!d)|vstr)")
SEVERAL = re.compile(r"^(v?ldm|v?stm|v?push|v?pop|ldrd|strd)")
BRANCH = re.compile(rf"^(b|bl|bx|blx|cbn?z|tb[bh]|b({CONDITIONS}))(\.[nw])?$")
LONG_PRODUCT = re.compile(r"^[us]m(ul|la)l$")
LONG_SUM = re.compile(r"^[us]mlal$")
FUSED = re.compile(r"^v(fn?m|n?ml)[as]")
ARITHMETIC = re.compile(r"^v(add|sub|n?mul|fn?m[as]|n?ml[as]|div|sqrt|cvt)")
ROOT = re.compile(r"^v(div|sqrt)")
DIVISION = re.compile(r"^[us]div$")
PRODUCT = re.compile(r"^(mul|ml[as]|[us]m)")


class Cycles(NamedTuple):
    low: int
    likely: int
    high: int


def plain(instruction):
    """Without the width: ldr.w is ldr; a float's type stays out too."""
    return instruction.name.split(".")[0]


class Table:
    """One instruction after the other."""

    def __init__(self, core):
        self.slow_products = core == "cortex-m3"

    def cost(self, before, here, after, taken):
        """(low, likely, high) of one instruction between its neighbours."""
        name = plain(here)
        if BRANCH.match(here.name):
            return (2, 3, 4) if taken else (1, 1, 1)
        if SINGLE_LOAD.match(name):
            return self._load(before, here)
        if SINGLE_STORE.match(name):
            return (1, 1, 2) if words(here) == 1 else (2, 3, 3)
        if SEVERAL.match(name):
            returns = 1 if "pc" in here.operands else 0
            return tuple(1 + words(here) + returns * refill for refill in (1, 2, 3))
        if DIVISION.match(name):
            return 2, 7, 12
        if LONG_PRODUCT.match(name) and self.slow_products:
            return (4, 6, 7) if LONG_SUM.match(name) else (3, 4, 5)
        if name in ("mla", "mls") and self.slow_products:
            return 2, 2, 2
        own = 14 if ROOT.match(name) else 3 if FUSED.match(name) else 2 if name == "vmov" and here.operands.count(",") == 2 else 1
        stall = 1 if ARITHMETIC.match(name) and after is not None and waits(here, after) else 0
        return own, own + stall, own + stall

    @staticmethod
    def _load(before, here):
        """Loads one after the other overlap, unless one gives the other its address."""
        own = words(here)
        follows = before is not None and SINGLE_LOAD.match(plain(before)) and not access(before).writes & access(here).reads
        return (own if follows else own + 1), (own if follows else own + 1), own + 1


def waits(here, after):
    """Whether the next instruction needs the result at once: a sum of products takes its addend a cycle later."""
    needed = access(after).reads
    if FUSED.match(plain(after)):
        needed = needed - access(after).writes
    return bool(access(here).writes & needed)


def by_table(core, executed, instructions):
    table, costs = Table(core), {}
    sums = [0, 0, 0]
    for before, here, after in zip([None, *executed], executed, executed[1:]):
        key = before, here, after
        if key not in costs:
            costs[key] = table.cost(*map(instructions.get, (before, here, after)), after != here + instructions[here].size)
        sums = [total + cost for total, cost in zip(sums, costs[key])]
    return Cycles(*sums)


class Latency(NamedTuple):
    """Until a result can be used, cycles; how many instructions start at once."""

    load: int
    product: int
    arithmetic: int
    fused: int
    root: int
    refill: int
    width: int


LATENCIES = {  # low, likely, high
    "cortex-m7": (Latency(1, 1, 1, 1, 14, 1, 2), Latency(2, 2, 3, 6, 16, 1, 2), Latency(3, 2, 3, 6, 16, 8, 1)),
    "cortex-m33": (Latency(1, 1, 1, 1, 12, 1, 2), Latency(2, 1, 2, 3, 14, 2, 1), Latency(2, 2, 3, 4, 15, 3, 1)),
}


def latency(rule, instruction):
    name = plain(instruction)
    if SINGLE_LOAD.match(name) or name in ("pop", "vpop", "ldrd") or name.startswith(("ldm", "vldm")):
        return rule.load
    if ROOT.match(name) or DIVISION.match(name):
        return rule.root
    if FUSED.match(name):
        return rule.fused
    if ARITHMETIC.match(name):
        return rule.arithmetic
    return rule.product if PRODUCT.match(name) else 1


def unit(instruction):
    """What two instructions that start together must not share."""
    name = plain(instruction)
    if SINGLE_LOAD.match(name) or SINGLE_STORE.match(name) or SEVERAL.match(name):
        return "memory"
    return "float" if name.startswith("v") else "product" if PRODUCT.match(name) else None


class Slot(NamedTuple):
    reads: frozenset
    writes: frozenset
    latency: int
    unit: object
    words: int
    branch: bool


def slot(rule, instruction):
    reads, writes = access(instruction)
    several = words(instruction) if SEVERAL.match(plain(instruction)) else 1
    return Slot(reads, writes, latency(rule, instruction), unit(instruction), several, bool(BRANCH.match(instruction.name)))


def by_scoreboard(rule, executed, instructions):
    """In order; `width` start together where they need neither one another's results nor the same unit."""
    slots, ready = {}, {}
    now, started = 0, []
    for address, following in zip(executed, executed[1:]):
        here = slots.get(address)
        if here is None:
            here = slots[address] = slot(rule, instructions[address])
        earliest = max([now, *(ready.get(register, 0) for register in here.reads)])
        if earliest > now or len(started) == rule.width or here.unit is not None and here.unit in started:
            now, started = max(earliest, now + (1 if started else 0)), []
        started.append(here.unit)
        now += here.words - 1
        for register in here.writes:
            ready[register] = now + here.latency
        if here.branch and following != address + instructions[address].size:
            now, started = now + 1 + rule.refill, []
    return now + (1 if started else 0)


def cycles(core, executed, instructions):
    """From the start of the first executed address to the start of the last."""
    if core in LATENCIES:
        return Cycles(*(by_scoreboard(rule, executed, instructions) for rule in LATENCIES[core]))
    return by_table(core, executed, instructions)
