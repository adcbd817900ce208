"""An estimate of cycles from executed instructions; doc/measurements/size.md says what it leaves out."""

import re

from stack import registers

# Cycles of an instruction; 1 where nothing matches. Loads and stores of n words take 1 + n.
DIVIDE = re.compile(r"^(vdiv|vsqrt|sdiv|udiv|divu?$|remu?$)")
FUSED = re.compile(r"^vfn?m[as]")
MEMORY = re.compile(r"^(ldr|str|vldr|vstr|ldm|stm|vldm|vstm|push|pop|vpush|vpop|l[bhw]u?$|s[bhw]$)")
CYCLES_OF_DIVIDE = {"rv32imac": 37}  # of lowRISC's Ibex; elsewhere 14
CYCLES_OF_FUSED = {"cortex-m7": 1}  # elsewhere multiply and add one after the other, and a cycle between


def words(instruction):
    name, operands = instruction.name, instruction.operands
    if "{" in operands:
        return registers(operands[operands.find("{"):]) // 4
    return 2 if name.startswith(("ldrd", "strd")) or re.match(r"^v(ldr|str)", name) and operands.startswith("d") else 1


def cycles(instruction, cpu):
    if DIVIDE.match(instruction.name):
        return CYCLES_OF_DIVIDE.get(cpu, 14)
    if FUSED.match(instruction.name):
        return CYCLES_OF_FUSED.get(cpu, 3)
    return 1 + words(instruction) if MEMORY.match(instruction.name) else 1
