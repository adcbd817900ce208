"""What an ELF image holds: bytes by kind of memory, functions, instructions."""

import bisect
import re
import subprocess
from typing import NamedTuple

TOOLS = "arm-none-eabi-"
LINE = re.compile(r"^ *([0-9a-f]+):\t([0-9a-f]{4}(?: ?[0-9a-f]{4})?) *\t(\S+)\t?(.*)$")
SECTION = re.compile(r"^ *\d+ (\S+) +([0-9a-f]{8}) +[0-9a-f]{8} +[0-9a-f]{8}")


class Instruction(NamedTuple):
    name: str  # with condition and width: popne, ldr.w
    operands: str
    size: int


def run(tool, *arguments):
    return subprocess.run([TOOLS + tool, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


class Image:
    def __init__(self, path):
        self.path = path
        self.flash, self.ram = self._memory()
        self.instructions = dict(self._disassembly())
        self.functions = self._functions()
        self._starts = sorted(self.functions.values())
        self._names = {address: name for name, address in self.functions.items()}

    def function_at(self, address):
        """Name of the function that holds an address."""
        at = bisect.bisect_right(self._starts, address)
        return self._names[self._starts[at - 1]] if at else hex(address)

    def _memory(self):
        """Bytes of flash and of static RAM; the stack's room is not counted."""
        flash = ram = 0
        lines = run("objdump", "-h", self.path).splitlines()
        for line, attributes in zip(lines, lines[1:]):
            section = SECTION.match(line)
            if not section or "ALLOC" not in attributes or section[1] == ".stack":
                continue
            size = int(section[2], 16)
            flash += size if "CONTENTS" in attributes else 0
            ram += size if "READONLY" not in attributes else 0
        return flash, ram

    def _disassembly(self):
        for line in run("objdump", "-d", self.path).splitlines():
            found = LINE.match(line)
            if found and not found[3].startswith("."):
                operands = re.split(r"\s*[;@]", found[4])[0].strip()
                yield int(found[1], 16), Instruction(found[3], operands, len(found[2].replace(" ", "")) // 2)

    def _functions(self):
        functions = {}
        for line in run("nm", self.path).splitlines():
            address, kind, name = line.split()[-3:] if len(line.split()) == 3 else ("0", "U", "")
            if kind in "tTwW" and not name.startswith("$"):
                functions[name] = int(address, 16) & ~1
        return functions
