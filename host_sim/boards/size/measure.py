"""The figures of one probe: a row of ./axial size."""

import functools
import json
import os
import pathlib
import re
import sys
from typing import NamedTuple

import execution
import refused
import riscv_stack
import stack
import timing  # in the folder that stack names
from image import RISCV, Image, memory, sections

ROOT = pathlib.Path(__file__).resolve().parents[3]
IMAGES = pathlib.Path(os.environ.get("AXIAL_IMAGES_ROOT", ROOT / "build"))
KERNEL = "axial_kernel"
RETURN = re.compile(r"^(bx|pop|ldr|ldmia|ret)")


class Probe(NamedTuple):
    set: str
    robot: str
    scene: str
    algorithm: str
    variant: str
    contract: str
    scalar: str = "float"

    @property
    def name(self):
        return "-".join(self[1:6]) + suffix(self.scalar)

    @property
    def function(self):
        """What its source calls the kernel."""
        return "_".join((self.scene, self.algorithm, self.variant)) + suffix(self.scalar).replace("-", "_")

    @property
    def empty(self):
        """The same harness without a kernel: one for all systems of the same words."""
        return f"empty-{self.robot}" + suffix(self.scalar.split("_")[0])


def suffix(scalar):
    return "" if scalar == "float" else "-" + scalar


def boards():
    """Those that an emulator runs."""
    found = (file.parent.name for file in (ROOT / "hal/boards").glob("*/board.json"))
    return sorted(name for name in found if {"qemu", "runner"} & description(name).keys())


def emulator(board):
    described = description(board)
    return "QEMU" if "qemu" in described else described["runner"]["machine"]


def description(board):
    return json.loads((ROOT / "hal/boards" / board / "board.json").read_text(encoding="utf-8"))


@functools.lru_cache
def listing(board, file="probes.txt"):
    """[(Probe, its source)], as the build lists them for a board; those of a user's robot are in own.txt."""
    lines = (IMAGES / board / "probes" / file).read_text(encoding="utf-8").splitlines()
    return [(Probe(*words), unit) for *words, unit in map(str.split, lines)]


def probes(board):
    return [probe for probe, _ in listing(board)]


def own_probes(board):
    return [probe for probe, _ in listing(board, "own.txt")]


@functools.lru_cache
def units(board):
    """{name of a probe: the source that holds its kernel}"""
    return {probe.name: unit for probe, unit in listing(board) + listing(board, "own.txt")}


@functools.lru_cache
def own_log(board):
    """Of ./axial's build of a user's kernels; empty where all was built."""
    log = IMAGES / f"{board}-own.log"
    return log.read_text(encoding="utf-8", errors="replace") if log.is_file() else ""


@functools.lru_cache
def refusals(board):
    """{source: why} of a user's kernels that the library does not offer."""
    return refused.refused(own_log(board))[0]


def refusal_of(board, probe):
    """Why the library does not offer a user's kernel; None where it does."""
    return refusals(board).get(units(board)[probe.name])


def why_not_built(board, probe):
    """Of a user's kernel that there is no image of."""
    return refused.reason(own_log(board), (probe.name, probe.empty), units(board)[probe.name]) or "its build ended before it"


def path_of(board, name):
    path = IMAGES / board / "probes" / (name + ".elf")
    if not path.exists():
        raise FileNotFoundError(f"{path}: build it first (cmake --build build/{board} --target size-{name})")
    return path


def stack_depth(image):
    return (riscv_stack if image.machine == RISCV else stack).StackDepth(image)


@functools.lru_cache(maxsize=None)
def memory_of_empty(path):
    """Many probes have the same."""
    return memory(sections(path))


class Figures:
    """All that is known of one probe; `row()` has the fields that are published."""

    def __init__(self, board, probe):
        self.board, self.probe = board, probe
        self.image = Image(path_of(board, probe.name))
        self.empty = memory_of_empty(path_of(board, probe.empty))
        self.entry = self.image.functions[KERNEL]
        self.depths = stack_depth(self.image)
        self.stack_bytes = self.depths.of(self.entry)
        self._check_frame()
        self._run()

    def row(self):
        low, high = min(self.counts), max(self.counts)
        varying = {} if low == high else {"instructions_min": low, "instructions_max": high}
        return {"board": self.board, "robot": self.probe.robot, "scene": self.probe.scene,
                "algorithm": self.probe.algorithm, "scalar": self.probe.scalar, "variant": self.probe.variant,
                "contract": self.probe.contract, "instructions": high, **varying,
                "cycles_estimated": self.timing.cycles, **self.timing.fields(), "flash_bytes": self.image.flash - self.empty[0], "ram_bytes": self.image.ram - self.empty[1],
                "stack_bytes": self.stack_bytes}

    def _check_frame(self):
        """What the walk through the instructions found for the kernel is what the compiler wrote."""
        unit = units(self.board)[self.probe.name]
        file = IMAGES / self.board / f"firmware/apps/size/CMakeFiles/size-kernels-{unit}.dir/{unit}.cpp.su"
        wanted = stack.compiler_frames(file)[f"void axial::apps::size::{self.probe.function}(void*)"]
        if self.depths.own[self.entry] != wanted:
            raise stack.Unbounded(f"{self.image.path}: {KERNEL} has {self.depths.own[self.entry]} bytes, "
                                  f"the compiler says {wanted}")

    def _run(self):
        board = description(self.board)
        self.runs = execution.run(board, self.image.path, self.entry, self.depths.reached)
        self.counts = [run.count for run in self.runs]
        for run in self.runs:
            self._check_path(run.executed)
            if run.cycles:
                self._check_cycles(run)
        self.timing = timing.Model(board).worst(self.runs, self.image.instructions)

    def _check_cycles(self, run):
        """An emulator that counts cycles itself has those of the core's table, but for what it is known to leave out."""
        by_table = timing.cortex_m0.cycles(description(self.board)["timing"]["core"], run.executed, self.image.instructions)
        left_out = sum(timing.cortex_m0.is_short_in_rp2040js(self.image.instructions[address]) for address in run.executed[:-1])
        if run.cycles != by_table - left_out:
            raise execution.Mismatch(f"{self.image.path}: {by_table} cycles by the table, {run.cycles} and {left_out} known ones in the emulator")

    def _check_path(self, executed):
        """Along known instructions to a return, which is left out, as in the count."""
        unknown = set(executed).difference(self.depths.reached)
        if unknown:
            raise execution.Mismatch(f"{self.image.path}: executes {min(unknown):#x}, where no path leads")
        last = self.image.instructions[executed[-1]]
        if not RETURN.match(last.name):
            raise execution.Mismatch(f"{self.image.path}: the count ends at {last.name} {last.operands}, not at a return")
