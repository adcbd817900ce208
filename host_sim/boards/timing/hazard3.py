"""Cycles of Hazard3 v1.0, the RISC-V core of the RP2350, for instructions that were executed.

Zero-wait memory, separate ports for fetch and data, the RP2350's configuration: multiplications of one cycle, a branch predictor of one
entry. Rules are its documentation's and, where that is silent, what its RTL does in simulation (tests/data/timing/hazard3_sequences.json).
Left out: flash behind XIP, contention of memory banks, interrupts.
"""

import re

DIVISION, ATOMIC, FENCE = 19, 4, 2  # cycles
ROOM = 3  # halfwords in the buffer
LOAD = re.compile(r"^(lw|lhu?|lbu?|lr\.w.*|sc\.w.*)$")
BRANCH = re.compile(r"^b(eq|ne|lt|ge|ltu|geu|gt|le|gtu|leu|eqz|nez|lez|gez|ltz|gtz)$")
JUMP = ("j", "jal", "jr", "jalr", "ret", "call", "tail", "mret")
REGISTER = re.compile(r"\b(zero|ra|[sgtf]p|a[0-7]|t[0-6]|s1[01]|s[0-9])\b")


class Step:
    """What the pipeline sees of an instruction."""

    def __init__(self, instruction):
        name = instruction.name
        registers = REGISTER.findall(instruction.operands.partition("<")[0])
        self.halfwords = instruction.size // 2
        self.exclusive = name.startswith(("lr.w", "sc.w", "amo"))
        self.loads = bool(LOAD.match(name))
        self.result = registers[0] if self.loads and registers[0] != "zero" else None
        self.needs = frozenset(needs(name, registers))
        self.branch = bool(BRANCH.match(name))
        self.redirects = name in JUMP
        self.clears = name == "fence.i"
        self.dividend = registers[1] if name in ("div", "rem") else None
        self.busy = DIVISION if re.match(r"^(div|rem)u?$", name) else ATOMIC if name.startswith("amo") else FENCE if self.clears else 1


def needs(name, registers):
    """The registers that must be there as it starts. A store's word may come a stage later."""
    if name.startswith("amo") or name in ("j", "jal"):
        return ()
    if BRANCH.match(name) or name == "jr":
        return registers
    if name in ("jalr", "ret"):
        return registers[-1:] or ("ra",)
    if name.startswith("csr"):
        return () if name == "csrr" or name.endswith("i") else registers[-1:]
    return registers[1:]


class Fetch:
    """A word a cycle into a buffer of three halfwords. The branch that the predictor holds turns the stream at its last halfword,
    unless it begins in the word that the last redirect fetched first."""

    def __init__(self, start):
        self.held = None  # (address, end, target)
        self.predicted = False
        self.redirect(start)

    def redirect(self, target):
        self.level, self.at, self.first, self.predicted = 0, target, target & ~3, False
        self.pull()

    def pull(self):
        end = following = (self.at & ~3) + 4
        turns = self.held is not None and self.at < self.held[1] <= end and self.held[0] & ~3 != self.first
        if turns:
            _, end, following = self.held
        halfwords = (end - self.at) // 2
        if self.level + halfwords <= ROOM:
            self.predicted |= turns
            self.level += halfwords
            self.at = following


class Pipeline:
    def __init__(self, start):
        self.fetch = Fetch(start)
        self.now = 0
        self.late, self.usable, self.exclusive = None, 0, 0  # a loaded register, when it is there, and the next exclusive access

    def start(self, step):
        """Waits for the instruction itself and for what it needs; says when it starts."""
        while self.fetch.level < step.halfwords:
            self.advance()
        while self.now < self.usable and self.late in step.needs or self.now < self.exclusive and step.exclusive:
            self.advance()
        return self.now

    def advance(self):
        self.fetch.pull()
        self.now += 1

    def finish(self, step, address, following, busy):
        self.fetch.level -= step.halfwords
        if step.loads:
            self.late, self.usable = step.result, self.now + 2
        if step.exclusive and step.busy == 1:
            self.exclusive = self.now + 2
        redirect = self._redirect(step, address, following)
        for _ in range(busy - 1):
            self.advance()
        if redirect:
            self.now += 2
            self.fetch.redirect(following)
        else:
            self.advance()

    def _redirect(self, step, address, following):
        end = address + 2 * step.halfwords
        taken = following != end
        if not step.branch:
            if step.clears:
                self.fetch.held = None
            return step.redirects
        if self.fetch.predicted and self.fetch.held[0] == address:
            self.fetch.predicted = False
            if not taken:
                self.fetch.held = None
            return not taken
        if taken and following < address:
            self.fetch.held = (address, end, following)
        return taken


def cycles(executed, instructions, negative=lambda index: False):
    """From the start of the first executed address to the start of the last. `negative` tells, by index, whether a signed
    division's dividend is: that takes a cycle more."""
    steps = {}
    pipeline = Pipeline(executed[0])
    for index, (address, following) in enumerate(zip(executed, executed[1:])):
        step = steps.get(address)
        if step is None:
            step = steps[address] = Step(instructions[address])
        pipeline.start(step)
        pipeline.finish(step, address, following, step.busy + (step.dividend is not None and negative(index)))
    return pipeline.start(Step(instructions[executed[-1]]))


def signed_divisions(executed, instructions):
    return any(instructions[address].name in ("div", "rem") for address in set(executed))
