"""What an Arm instruction moves, reads and writes."""

import re
from typing import NamedTuple

LIST = re.compile(r"\{([^}]*)\}")
NAMES = {"sb": "r9", "sl": "r10", "fp": "r11", "ip": "r12", "r13": "sp", "r14": "lr", "r15": "pc"}
REGISTER = re.compile(r"\b(r\d+|s\d+|d\d+|sb|sl|fp|ip|sp|lr|pc)\b(?:-(r\d+|s\d+|d\d+))?")
CONDITIONS = "eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le"
WITHOUT_RESULT = re.compile(r"^(v?str|v?stm|v?push|cmp|cmn|tst|teq|vcmp|b|cb|it)")
TWO_RESULTS = re.compile(r"^([us]mull|[us]mlal|ldrd)")
ALSO_READS = re.compile(r"^(v(fn?m|n?ml)[as]|movt|bfi|[us]mlal)")
ONE_OPERAND = re.compile(r"^(v|mov|mvn|ldr|adr|[su]xt|rev|rbit|clz|neg)")  # and a result, of which nothing is read


def registers(text):
    """Single registers of a text: a list's are spread, a double is two singles."""
    found = []
    for first, last in REGISTER.findall(text):
        first = NAMES.get(first, first)
        kind, end = first[0], int((last or first)[1:]) if first[1:].isdigit() else 0
        names = [first] if not first[1:].isdigit() else [f"{kind}{i}" for i in range(int(first[1:]), end + 1)]
        found += [single for name in names for single in (singles(name) if kind == "d" else [name])]
    return found


def singles(double):
    return [f"s{2 * int(double[1:])}", f"s{2 * int(double[1:]) + 1}"]


def words(instruction):
    """Words that an instruction loads or stores."""
    name, operands = instruction.name, instruction.operands
    listed = LIST.search(operands)
    if listed:
        return len(registers(listed[1]))
    double = name.startswith(("vldr", "vstr")) and operands.startswith("d")
    return 2 if double or name.startswith(("ldrd", "strd")) else 1


class Access(NamedTuple):
    reads: frozenset
    writes: frozenset


def access(instruction):
    """Registers that an instruction reads and writes; flags are left out."""
    name, operands = instruction.name, instruction.operands
    if LIST.search(operands):
        listed, base = registers(LIST.search(operands)[1]), registers(LIST.sub("", operands)) or ["sp"]
        stored = bool(WITHOUT_RESULT.match(name))
        return Access(frozenset(base + listed * stored), frozenset([] if stored else listed))
    parts = [registers(part) for part in re.split(r",\s*(?![^\[]*\])", operands)]
    results = 0 if WITHOUT_RESULT.match(name) else 2 if TWO_RESULTS.match(name) else 1
    if name.startswith("vmov") and len(parts) == 3:  # two words between the register files
        results = 2 if parts[0][0].startswith("r") else 1
    written = [register for part in parts[:results] for register in part]
    read = [register for part in parts[results:] for register in part]
    if ALSO_READS.match(name) or len(parts) == 2 and not ONE_OPERAND.match(name):
        read += written  # a form of two operands: adds r0, #1
    return Access(frozenset(read), frozenset(written))
