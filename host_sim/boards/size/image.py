"""What an ELF image holds: bytes by kind of memory, functions, instructions."""

import bisect
import re
import subprocess
from typing import NamedTuple

ARM, RISCV = 40, 243  # the machine in an ELF header
TOOLS = {ARM: "arm-none-eabi-", RISCV: "riscv64-unknown-elf-"}
FORMATS = {ARM: "elf32-littlearm", RISCV: "elf32-littleriscv"}
LINE = re.compile(r"^ *([0-9a-f]+):\t([0-9a-f]{4}(?: ?[0-9a-f]{4})?) *\t([^\s.]\S*)\t?([^;@\n]*)", re.MULTILINE)
WORD = re.compile(r"^ *([0-9a-f]+):\t([0-9a-f]{8}) *\t\.word", re.MULTILINE)
LITERAL = re.compile(r"^(r\d+), \[pc, #\d+\]$")
SECTION = re.compile(r"^ *\d+ (\S+) +([0-9a-f]{8}) +([0-9a-f]{8}) +([0-9a-f]{8}) +([0-9a-f]{8}) .*\n(.*)$", re.MULTILINE)


class Instruction(NamedTuple):
    name: str  # with condition and width: popne, ldr.w
    operands: str
    size: int


class Section(NamedTuple):
    name: str
    size: int
    address: int
    load: int  # address in flash of what start-up copies
    offset: int  # in the file
    attributes: str


def machine_of(path):
    with open(path, "rb") as file:
        return int.from_bytes(file.read(20)[18:], "little")


def run(tool, *arguments, **options):
    """What a program of the compiler's that made a file, the last argument, prints about it."""
    command = [TOOLS[machine_of(arguments[-1])] + tool, *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


def sections(path):
    return [Section(name, int(size, 16), int(address, 16), int(load, 16), int(offset, 16), attributes)
            for name, size, address, load, offset, attributes in SECTION.findall(run("objdump", "-h", path))]


def memory(parts):
    """Bytes of flash and of static RAM, of sections; the stack's room is not counted."""
    held = [each for each in parts if "ALLOC" in each.attributes and each.name != ".stack"]
    return sum(each.size for each in held if "CONTENTS" in each.attributes), \
        sum(each.size for each in held if "READONLY" not in each.attributes or each.load != each.address)


class Image:
    def __init__(self, path):
        self.path = path
        self.machine = machine_of(path)
        parts = sections(path)
        self.flash, self.ram = memory(parts)
        self._constants_at, self._constants = self._read_constants(parts)
        listing = run("objdump", "-d", path)
        self._words = {int(address, 16): int(word, 16) for address, word in WORD.findall(listing)}
        self.instructions = {int(address, 16): Instruction(name, operands.strip(), len(code.replace(" ", "")) // 2)
                             for address, code, name, operands in LINE.findall(listing)}
        self._name_large_frames()
        self.functions = self._functions()
        self._starts = sorted(self.functions.values())
        self._names = {address: name for name, address in self.functions.items()}

    def function_at(self, address):
        """Name of the function that holds an address."""
        at = bisect.bisect_right(self._starts, address)
        return self._names[self._starts[at - 1]] if at else hex(address)

    def word(self, address):
        """A word of the constants in flash."""
        at = address - self._constants_at
        if not 0 <= at <= len(self._constants) - 4:
            raise KeyError(hex(address))
        return int.from_bytes(self._constants[at:at + 4], "little")

    def literal(self, address):
        """What `ldr register, [pc, #offset]` at an address loads."""
        operands = self.instructions[address].operands
        return self._words.get((address + 4 & ~3) + int(operands[operands.index("#") + 1:-1])) if LITERAL.match(operands) else None

    def _read_constants(self, parts):
        """(address, bytes) of .rodata"""
        for section in parts:
            if section.name == ".rodata":
                with open(self.path, "rb") as file:
                    file.seek(section.offset)
                    return section.address, file.read(section.size)
        return 0, b""

    def _name_large_frames(self):
        """ARMv6-M moves the stack pointer by a register: `add sp, r4`, with a constant in r4. Writes the constant down."""
        for address, instruction in list(self.instructions.items()):
            moved = re.match(r"^sp, (r\d+)$", instruction.operands) if instruction.name == "add" else None
            value = self._constant(moved[1], address) if moved else None
            if value is not None:
                name = "add" if value >= 0 else "sub"
                self.instructions[address] = Instruction(name, f"sp, #{abs(value)}", instruction.size)

    def _constant(self, register, before):
        """What the straight line before an address puts into a register; None where it is not a constant."""
        for address in range(before - 2, before - 64, -2):
            name, operands, _ = self.instructions.get(address, Instruction("", "", 0))
            if name.startswith(("b", "pop")):
                return None
            if re.match(rf"^{register}\b", operands) and not name.startswith(("cmp", "str")):
                return self._result(name, operands, register, address)
        return None

    def _result(self, name, operands, register, address):
        numbers = [int(number) for number in re.findall(r"#(\d+)", operands)]
        if name == "ldr" and LITERAL.match(operands):
            word = self._words.get((address + 4 & ~3) + numbers[0])
            return word if word is None or word < 1 << 31 else word - (1 << 32)
        if name == "movs" and numbers:
            return numbers[0]
        if name in ("lsls", "adds") and numbers:
            source = self._constant(re.findall(r"r\d+", operands)[-1], address)
            return source if source is None else source << numbers[0] if name == "lsls" else source + numbers[0]
        return None

    def _functions(self):
        """nm without the name of the format asks its plugins first, ten times as long."""
        functions = {}
        for line in run("nm", "--target=" + FORMATS[self.machine], self.path).splitlines():
            address, kind, name = line.split()[-3:] if len(line.split()) == 3 else ("0", "U", "")
            if kind in "tTwW" and not name.startswith("$"):
                functions[name] = int(address, 16) & ~1
        return functions
