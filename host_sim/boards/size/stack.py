"""Worst-case stack of a function: every path through its instructions and through what it calls, library routines
included. Whatever cannot be bounded (an indirect call, a recursion, a frame of run-time size) is an error with a name.
"""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "timing"))
from operands import CONDITIONS, registers  # noqa: E402

BRANCH = re.compile(rf"^b({CONDITIONS})?(\.[nw])?$")
COMPARE_AND_BRANCH = re.compile(r"^cbn?z$")
CALL = re.compile(rf"^blx?({CONDITIONS})?$")
CONDITIONAL_CALL = re.compile(rf"^blx?({CONDITIONS})$")
CONDITIONAL = re.compile(rf"^(?:push|pop|bx|ldr|ldm(?:ia)?|mov|add|sub|vpush|vpop)({CONDITIONS})(\.[nw])?$")
BRANCH_TO_REGISTER = re.compile(rf"^bx({CONDITIONS})?$")
TARGET = re.compile(r"\b([0-9a-f]+) <")
STACKING = ("push", "pop", "vpush", "vpop")


class Unbounded(Exception):
    pass


def bytes_of(text):
    """Of a register list: {r4, r5, lr}, {s16-s21}, {d8}."""
    return 4 * len(registers(text))


def growth(instruction):
    """Bytes by which an instruction makes the stack grow; None where it cannot be known."""
    name, operands = instruction.name, instruction.operands
    if "sp" not in operands and not name.startswith(STACKING):
        return 0
    base = re.sub(rf"({CONDITIONS})?(\.[nw]|\.32|\.64)?$", "", name) if CONDITIONAL.match(name) else name.split(".")[0]
    listed = operands[operands.find("{"):]
    if base in ("push", "vpush"):
        return bytes_of(listed)
    if base in ("pop", "vpop"):
        return -bytes_of(listed)
    if operands.startswith("sp!"):
        grows = base in ("stmdb", "vstmdb")
        return bytes_of(listed) if grows else -bytes_of(listed) if base in ("ldmia", "ldm", "vldmia") else None
    constant = re.match(r"^sp(?:, sp)?, #(\d+)$", operands)
    if base in ("sub", "subw", "add", "addw") and operands.startswith("sp,"):
        return None if not constant else int(constant[1]) * (1 if base.startswith("sub") else -1)
    moved = re.search(r"\[sp, #(-?\d+)\]!$|\[sp\], #(-?\d+)$", operands)
    if moved:
        return -int(moved[1] or moved[2])
    if re.match(r"^sp\b", operands) and base not in ("cmp", "tst", "cmn"):
        return None
    return 0


class StackDepth:
    """Depths of an image's functions, each found once."""

    def __init__(self, image):
        self.image = image
        self.own = {}  # entry -> bytes without callees
        self.reached = set()  # addresses of every instruction on some path
        self._total, self._open = {}, []
        self._inner = set()  # (function, depth) of calls into its own middle

    def of(self, entry):
        """Bytes below the caller's stack pointer, callees included."""
        if entry in self._open:
            names = [self.image.function_at(address) for address in self._open[self._open.index(entry):]]
            raise Unbounded("recursion: " + " -> ".join(names))
        if entry not in self._total:
            self._open.append(entry)
            self._total[entry] = self._walk(entry)
            self._open.pop()
        return self._total[entry]

    def _walk(self, entry):
        own = deepest = 0
        pending, seen = [(entry, 0)], set()
        while pending:
            state = pending.pop()
            if state in seen:
                continue
            seen.add(state)
            if len(seen) > 200_000:
                self._fail(state[0], "the stack grows in a loop")
            after, callee, successors = self._step(*state)
            own, deepest = max(own, after), max(deepest, after, state[1] + callee)
            pending += [(address, depth) for address, depth in successors]
        self.reached |= {address for address, _ in seen}
        self.own[entry] = own
        return deepest

    def instruction(self, address):
        if address not in self.image.instructions:
            self._fail(address, "no instruction there")
        return self.image.instructions[address]

    def _step(self, address, depth):
        """(depth after, depth of what it calls, [(next address, its depth)])."""
        instruction = self.instruction(address)
        name, operands = instruction.name, instruction.operands
        following = address + instruction.size
        target = TARGET.search(operands)
        grown = growth(instruction)
        if grown is None:
            self._fail(address, f"a frame of unknown size: {name} {operands}")
        after = depth + grown
        if CALL.match(name):
            if not target:
                self._fail(address, f"an indirect call: {name} {operands}")
            if self._is_inside(address, int(target[1], 16)):
                return depth, 0, [(int(target[1], 16), depth)] + self._after_inner_call(name, address, following, depth)
            return after, self.of(int(target[1], 16)), [(following, after)]
        if BRANCH.match(name) or COMPARE_AND_BRANCH.match(name):
            taken = [(int(target[1], 16), depth)]
            return after, 0, taken + ([(following, depth)] if name not in ("b", "b.n", "b.w") else [])
        if name == "mov" and operands.startswith("pc, r"):
            return depth, 0, [(destination, depth) for destination in self._switch(address, operands.split()[1])]
        if self._leaves(name, operands, address):
            if after != 0 and not self._is_inner_return(name, address, after):
                self._fail(address, f"a return with {after} bytes still on the stack")
            return depth, 0, [(following, depth)] if CONDITIONAL.match(name) else []
        untaken = [(following, depth)] if grown and CONDITIONAL.match(name) else []
        return after, 0, [(following, after)] + untaken

    def _switch(self, address, register):
        """Where a table of a library's switch on ARMv6-M leads: cmp R, #last; ...; ldr T, [pc]; lsls R, R, #2; ldr R, [T, R];
        mov pc, R."""
        at = lambda back: self.image.instructions.get(address - 2 * back)
        load, shift, base = at(1), at(2), at(3)
        bounds = [each for each in map(at, range(4, 10)) if each and re.match(rf"^{register}, #\d+$", each.operands) and each.name == "cmp"]
        expected = load and shift and base and bounds and shift.name == "lsls" and shift.operands == f"{register}, {register}, #2" and \
            re.match(rf"^{register}, \[(r\d+), {register}\]$", load.operands)
        table = self.image.literal(address - 6) if expected and base.operands.startswith(expected[1] + ", [pc") else None
        if table is None:
            self._fail(address, f"an indirect branch: mov pc, {register}")
        last = int(bounds[0].operands.split("#")[1])
        return [self.image.word(table + 4 * i) & ~1 for i in range(last + 1)]

    def _is_inside(self, address, target):
        """Whether a call leads into the middle of its own function."""
        name = self.image.function_at(address)
        return self.image.function_at(target) == name and target != self.image.functions[name]

    def _after_inner_call(self, name, address, following, depth):
        """Where ARMv6-M's branch does not reach, the compiler jumps by such a call. A conditional one, which ARMv6-M has
        not, is a routine inside a library's: it returns to what follows."""
        if not CONDITIONAL_CALL.match(name):
            return []
        self._inner.add((self.image.function_at(address), depth))
        return [(following, depth)]

    def _is_inner_return(self, name, address, depth):
        return name.startswith("bx") and (self.image.function_at(address), depth) in self._inner

    def _leaves(self, name, operands, address):
        if BRANCH_TO_REGISTER.match(name) or operands.startswith("pc,") and re.match(rf"^mov({CONDITIONS})?$", name):
            if not operands.endswith("lr"):
                self._fail(address, f"an indirect branch: {name} {operands}")
            return True
        if name.startswith(("tbb", "tbh")) or operands.startswith("pc,") and name.startswith(("ldr", "add")) \
                and not re.search(r"\[sp\], #\d+$", operands):
            self._fail(address, f"an indirect branch: {name} {operands}")
        return name.startswith(("pop", "ldm")) and re.search(r"\bpc\}", operands) is not None or operands.startswith("pc, [sp]")

    def _fail(self, address, why):
        raise Unbounded(f"{self.image.path}: {self.image.function_at(address)} at {address:#x}: {why}")


def compiler_frames(file):
    """{function as the compiler writes it: bytes} of a .su file; a frame of run-time size is refused."""
    frames = {}
    with open(file, encoding="utf-8") as lines:
        for line in lines:
            function, size, kind = line.rstrip("\n").split("\t")
            if kind != "static":
                raise Unbounded(f"{function}: its frame is {kind}")
            frames[function.split(":", 3)[-1]] = int(size)
    return frames
