"""What an ELF image holds: bytes by kind of memory, functions, instructions."""

import bisect
import re
import subprocess
from typing import NamedTuple

ARM, RISCV = 40, 243  # the machine in an ELF header
TOOLS = {ARM: "arm-none-eabi-", RISCV: "riscv64-unknown-elf-"}
LINE = re.compile(r"^ *([0-9a-f]+):\t([0-9a-f]{4}(?: ?[0-9a-f]{4})?) *\t(\S+)\t?(.*)$")
WORD = re.compile(r"^ *([0-9a-f]+):\t([0-9a-f]{8}) *\t\.word")
LITERAL = re.compile(r"^(r\d+), \[pc, #\d+\]$")
CONSTANTS = re.compile(r"^ ([0-9a-f]+)((?: [0-9a-f]{2,8}){1,4})  ")
SECTION = re.compile(r"^ *\d+ (\S+) +([0-9a-f]{8}) +[0-9a-f]{8} +[0-9a-f]{8}")


class Instruction(NamedTuple):
    name: str  # with condition and width: popne, ldr.w
    operands: str
    size: int


def machine_of(path):
    with open(path, "rb") as file:
        return int.from_bytes(file.read(20)[18:], "little")


def run(tool, *arguments, **options):
    """What a program of the compiler's that made a file, the last argument, prints about it."""
    command = [TOOLS[machine_of(arguments[-1])] + tool, *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


class Image:
    def __init__(self, path):
        self.path = path
        self.machine = machine_of(path)
        self._sections = run("objdump", "-h", path).splitlines()
        self.flash, self.ram = self._memory()
        self._constants = dict(self._read_constants())
        listing = run("objdump", "-d", path).splitlines()
        self._words = {int(found[1], 16): int(found[2], 16) for found in map(WORD.match, listing) if found}
        self.instructions = dict(self._disassembly(listing))
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
        return int.from_bytes(bytes(self._constants[address + i] for i in range(4)), "little")

    def literal(self, address):
        """What `ldr register, [pc, #offset]` at an address loads."""
        operands = self.instructions[address].operands
        return self._words.get((address + 4 & ~3) + int(operands[operands.index("#") + 1:-1])) if LITERAL.match(operands) else None

    def _read_constants(self):
        if not any(" .rodata " in line for line in self._sections):
            return
        for found in map(CONSTANTS.match, run("objdump", "-s", "-j", ".rodata", self.path).splitlines()):
            for i, value in enumerate(bytes.fromhex(found[2].replace(" ", "")) if found else b""):
                yield int(found[1], 16) + i, value

    def _memory(self):
        """Bytes of flash and of static RAM; the stack's room is not counted."""
        flash = ram = 0
        for line, attributes in zip(self._sections, self._sections[1:]):
            section = SECTION.match(line)
            if not section or "ALLOC" not in attributes or section[1] == ".stack":
                continue
            size = int(section[2], 16)
            flash += size if "CONTENTS" in attributes else 0
            ram += size if "READONLY" not in attributes else 0
        return flash, ram

    def _disassembly(self, listing):
        for line in listing:
            found = LINE.match(line)
            if found and not found[3].startswith("."):
                operands = re.split(r"\s*[;@]", found[4])[0].strip()
                yield int(found[1], 16), Instruction(found[3], operands, len(found[2].replace(" ", "")) // 2)

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
        functions = {}
        for line in run("nm", self.path).splitlines():
            address, kind, name = line.split()[-3:] if len(line.split()) == 3 else ("0", "U", "")
            if kind in "tTwW" and not name.startswith("$"):
                functions[name] = int(address, 16) & ~1
        return functions
