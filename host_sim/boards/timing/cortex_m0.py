"""Cycles of the Cortex-M0 and M0+ for instructions that were executed: the tables of Arm DDI 0432C and DDI 0484C (3.3), with the
multiplier of one cycle and memory without wait states. The M0+'s single-cycle port is not used by kernels."""

import re
from typing import NamedTuple

from operands import CONDITIONS, words


class Table(NamedTuple):
    branch: int  # taken, or a write of pc
    call: int  # BL
    indirect: int  # BX, BLX
    pop_pc: int  # and N, the words of the list, pc among them
    system: int  # MRS, MSR and barriers


TABLES = {"cortex-m0": Table(3, 4, 3, 4, 4), "cortex-m0plus": Table(2, 3, 2, 3, 3)}
MEMORY = re.compile(r"^(ldr|str|ldm|stm|push|pop)")
SYSTEM = re.compile(r"^(mrs|msr|[di]sb|dmb)")
BRANCH = re.compile(rf"^b({CONDITIONS}|al)?(\.[nw])?$")


def cost(table, instruction, taken):
    name, operands = instruction.name, instruction.operands
    if name == "bl":
        return table.call
    if name in ("bx", "blx"):
        return table.indirect
    if BRANCH.match(name) or name in ("mov", "add") and operands.startswith("pc,"):
        return table.branch if taken else 1
    if name == "pop" and "pc" in operands:
        return table.pop_pc + words(instruction)
    if MEMORY.match(name):
        return 1 + words(instruction)
    return table.system if SYSTEM.match(name) else 1


def is_short_in_rp2040js(instruction):
    """What that emulator gives a cycle less than the manual: it leaves lr out of PUSH's words and pc out of POP's."""
    name, operands = instruction.name, instruction.operands
    return name == "push" and "lr" in operands or name == "pop" and "pc" in operands


def cycles(core, executed, instructions):
    """From the start of the first executed address to the start of the last."""
    table, costs = TABLES[core], {}
    total = 0
    for address, following in zip(executed, executed[1:]):
        if (address, following) not in costs:
            here = instructions[address]
            costs[address, following] = cost(table, here, following != address + here.size)
        total += costs[address, following]
    return total
