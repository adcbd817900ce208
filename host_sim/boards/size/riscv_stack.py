"""Worst-case stack of a RISC-V function: stack.py's walk with the instructions of RV32IMAC, as objdump writes them."""

import re

import stack

BRANCH = re.compile(r"^b(eq|ne|lt|ge|gt|le)(u|z)?$")
TABLE = re.compile(r"# ([0-9a-f]+) <")
MOVE = re.compile(r"^sp,sp,(-?\d+)$")
MOVE_BY_REGISTER = re.compile(r"^sp,sp,(\w+)$")
DESTINATION = re.compile(r"^(\w+),")
NOT_A_DESTINATION = re.compile(r"^(s[bhw]|b\w+|j\w*|ret|fence)$")


class StackDepth(stack.StackDepth):
    def _step(self, address, depth):
        name, operands, size = self.instruction(address)
        following = address + size
        target = stack.TARGET.search(operands)
        if name in ("jal", "jalr") and not operands.startswith("zero"):
            if not target:
                self._fail(address, f"an indirect call: {name} {operands}")
            return depth, self.of(int(target[1], 16)), [(following, depth)]
        if name == "ret":
            if depth != 0:
                self._fail(address, f"a return with {depth} bytes still on the stack")
            return depth, 0, []
        if BRANCH.match(name) or name == "j":
            taken = [(int(target[1], 16), depth)]
            return depth, 0, taken + ([(following, depth)] if name != "j" else [])
        if name == "jr":
            return depth, 0, [(case, depth) for case in self._cases(address)]
        if name in ("jalr", "mret"):
            self._fail(address, f"an indirect branch: {name} {operands}")
        after = depth + self._growth(address, name, operands)
        return after, 0, [(following, after)]

    def _cases(self, address):
        """Where a switch of libgcc's may go: `bltu most,case`, then a table of distances from itself."""
        table = most = None
        for before in range(address - 2, address - 48, -2):
            name, operands, _ = self.image.instructions.get(before, ("", "", 0))
            place = TABLE.search(operands)
            table = int(place[1], 16) if place and table is None else table
            if name == "bltu":
                most = self._constant(operands.split(",")[0], before)
                break
        if table is None or most is None:
            self._fail(address, "an indirect branch")
        return {table + self.image.word(table + 4 * case) & 0xFFFFFFFF for case in range(most + 1)}

    def _growth(self, address, name, operands):
        if not operands.startswith("sp,") or NOT_A_DESTINATION.match(name):
            return 0
        moved, by_register = MOVE.match(operands), MOVE_BY_REGISTER.match(operands)
        value = int(moved[1]) if moved and name in ("add", "addi") else None  # objdump writes a short addi as add
        if not moved and by_register and name == "add":
            value = self._constant(by_register[1], address)
        if value is None:
            self._fail(address, f"a frame of unknown size: {name} {operands}")
        return -value

    def _constant(self, register, before):
        """What the straight line before an address puts into a register; None where it is not a constant."""
        for address in range(before - 2, before - 64, -2):
            name, operands, _ = self.image.instructions.get(address, ("", "", 0))
            if BRANCH.match(name) or name in ("j", "jal", "jalr", "ret"):
                return None
            written = DESTINATION.match(operands)
            if written and written[1] == register and not NOT_A_DESTINATION.match(name):
                return self._result(name, operands.split()[0].split(","), address)
        return None

    def _result(self, name, operands, address):
        if name == "li":
            return int(operands[1], 0)
        if name == "lui":
            value = int(operands[1], 0) << 12 & 0xFFFFFFFF
            return value - (1 << 32) if value >> 31 else value
        if name in ("add", "addi") and not operands[2].isidentifier():
            source = self._constant(operands[1], address)
            return source if source is None else source + int(operands[2], 0)
        return None
