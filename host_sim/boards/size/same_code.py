"""Whether a change of the headers changes what the compiler makes of the kernels: machine code before and after, kernel by kernel.

usage: same_code.py BEFORE [--scene NAME] [--number NAME] [--build NAME] [--kernel NAME] [--json FILE]
       each a name or a list, separated by commas; BEFORE is a revision of git, or a folder, with headers and robots.
Ends with 1 where a kernel of a robot with one drive for each joint is not the same, or one of joints that share drives has more instructions.
"""

import argparse
import collections
import concurrent.futures
import functools
import hashlib
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
from typing import NamedTuple

import flags
import size

PADDING = re.compile(r"(nop|data16|cs nop|xchg +%ax,%ax)")
ROOT = pathlib.Path(__file__).resolve().parents[3]
CORTEX_M4F = ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-fno-exceptions", "-fno-rtti")


class Build(NamedTuple):
    compiler: str
    flags: tuple
    board: str = ""  # whose toolchain file has the flags

    def command(self):
        own = flags.own_flags(self.board) if self.board else self.flags
        return (self.compiler, *own, "-std=c++17", "-ffp-contract=off", "-ffunction-sections", "-g0", "-Wno-psabi")

    def objdump(self):
        return re.sub("(g|clang)\\+\\+$", "objdump", self.compiler)


BUILDS = {
    "stm32f405": Build("arm-none-eabi-g++", (), "stm32f405"),
    "nrf51": Build("arm-none-eabi-g++", (), "nrf51"),
    "rv32_virt": Build("riscv64-unknown-elf-g++", (), "rv32_virt"),
    "cortex_m4f-O2": Build("arm-none-eabi-g++", ("-O2", *CORTEX_M4F)),
    "host-gcc-O2": Build("g++", ("-O2",)),
    "host-clang-O2": Build("clang++", ("-O2",)),
}
NUMBERS = {"float": "float", "fixed32": "axial::Fixed32"}


class Scene(NamedTuple):
    robot: str
    features: str
    numbers: tuple = ("float", "fixed32")
    kernels: tuple = ("inverse_dynamics", "gravity_torque", "mass_matrix", "forward_dynamics", "forward_kinematics", "jacobian")
    shares_drives: bool = False

    def definition(self):
        words = self.robot.split("::")[-1]
        return f"axial::Scene<robots::{words}, {', '.join('axial::' + each for each in self.features.split())}>"


EVERY = Scene._field_defaults["kernels"]
SCENES = {
    "puma560": Scene("Puma560", "Gravity RotorInertia", kernels=(*EVERY, "inverse_dynamics_derivatives")),
    "scara": Scene("Scara", "Gravity RotorInertia", kernels=(*EVERY, "separate", "inverse_dynamics_derivatives")),
    "panda-looped": Scene("Panda", "Gravity Looped", kernels=("inverse_dynamics", "gravity_torque", "mass_matrix", "forward_kinematics")),
    "two_arm": Scene("TwoArm", "Gravity", numbers=("float",)),
    "puma560-loaded": Scene("Puma560", "RuntimeGravity RotorInertia Friction Payload"),
    "puma560-rotors": Scene("Puma560", "Gravity RotorInertia RotorDynamics", numbers=("float",), kernels=EVERY[:4]),
    "scara-floating": Scene("Scara", "RuntimeGravity RotorInertia FloatingBase", numbers=("float",), kernels=("inverse_dynamics",)),
    "puma560-water": Scene("Puma560", "Gravity RotorInertia Underwater", numbers=("float",), kernels=("inverse_dynamics",)),
    "wrist_arm": Scene("WristArm", "Gravity RotorInertia", kernels=EVERY[:4], shares_drives=True),
    "gripper": Scene("Gripper", "Gravity RotorInertia", kernels=EVERY[:4], shares_drives=True),
}
ARGUMENTS = {"inverse_dynamics": "q, qd, qdd, in", "forward_dynamics": "q, qd, tau, in", "inverse_dynamics_derivatives": "q, qd, qdd, in"}
HEADERS = """#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/robots.hpp>
using S = {scene};
using R = axial::robot_of<S>;
using Number = {number};
struct Given {{
  axial::Positions<R, Number> q;
  axial::Velocities<R, Number> qd;
  axial::Accelerations<R, Number> qdd;
  axial::EffortsOf<S, Number> tau;
  axial::Inputs<S, Number> in;
}};
"""
KERNEL = """
extern "C" auto {kernel}(const Given& g) {{ return axial::{kernel}<S>({given}); }}
"""


class Case(NamedTuple):
    """A source of its own for each kernel: constants of several would share a pool."""
    scene: str
    number: str
    build: str
    kernel: str

    def source(self):
        words = ARGUMENTS.get(self.kernel, "q, in").split(", ")
        return HEADERS.format(scene=SCENES[self.scene].definition(), number=NUMBERS[self.number]) + KERNEL.format(
            kernel=self.kernel, given=", ".join(f"g.{word}" for word in words))


class Missing(Exception):
    """A source that one of both sides does not compile."""


class Code:
    """What an object holds: functions as lines in which each symbol is a place, and data."""

    def __init__(self, dump, contents):
        self.functions, self.data = {}, contents
        lines = None
        for line in dump.splitlines():
            if begin := re.match(r"^[0-9a-f]+ <(.+)>:$", line):
                lines = self.functions.setdefault(begin[1], [])
            elif (reloc := re.match(r"^\s+[0-9a-f]+: (R_\S+)\s+(\S+)", line)) and lines:
                lines[-1] = (*lines[-1][:2], (*lines[-1][2], (reloc[1], reloc[2])))
            elif (code := re.match(r"^\s+[0-9a-f]+:\t([0-9a-f ]+)(\t.*)?$", line)) and lines is not None:
                lines.append((code[1].strip(), re.sub("<.*?>", "", code[2] or "").split(";")[0].split("//")[0].split("#")[0].strip(), ()))

    def of(self, kernel):
        """The kernel and all that it reaches in this object: [(bytes, places)], as many lines as instructions."""
        order, every = {kernel: 0}, []
        for name in order_of(order):
            for raw, text, relocations in without_padding(self.functions[name]):
                every.append((raw, text if not relocations else "", tuple((kind, self._place(symbol, order)) for kind, symbol in relocations)))
        return every

    def _place(self, symbol, order):
        name, sign, offset = re.match(r"([^+-]+|\S+?)(?:([+-])(0x[0-9a-f]+))?$", symbol).groups()
        name = name.removeprefix(".text.")
        if name in self.functions:
            return order.setdefault(name, len(order)), sign, offset
        return self.data.get(name, name if not name.startswith(("_Z", ".")) else ""), sign, offset


def without_padding(lines):
    end = len(lines)
    while end and PADDING.match(lines[end - 1][1]):
        end -= 1
    return lines[:end]


def order_of(known):
    """The names, those too that are added meanwhile."""
    position = 0
    while position < len(known):
        yield list(known)[position]
        position += 1


def contents_of(objdump, path):
    """{section's or symbol's name: digest of the section}, of sections that hold no code."""
    digests, section, words = collections.defaultdict(str), None, None
    for line in subprocess.run([objdump, "-s", path], check=True, capture_output=True, text=True).stdout.splitlines():
        if begin := re.match(r"^Contents of section (\S+):$", line):
            section = begin[1]
            words = [] if section.startswith((".rodata", ".data", ".srodata")) else None
        elif words is not None and line.startswith(" "):
            digests[section] = hashlib.sha256((digests[section] + line[1:line.find("  ")]).encode()).hexdigest()
    for line in subprocess.run([objdump, "-t", path], check=True, capture_output=True, text=True).stdout.splitlines():
        if (symbol := re.match(r"^([0-9a-f]+) .{7} (\S+)\t\S+ (?:\.hidden )?(\S+)$", line)) and symbol[2] in digests:
            digests.setdefault(symbol[3], f"{digests[symbol[2]]} {symbol[1]}")
    return dict(digests)


def code(case, tree, folder):
    """What the compiler makes of the case with the headers of a tree."""
    build = BUILDS[case.build]
    source, made = folder / "kernels.cpp", folder / "kernels.o"
    source.write_text(case.source(), encoding="utf-8")
    done = subprocess.run([*build.command(), f"-I{tree}/firmware/include", f"-I{tree}", "-c", source, "-o", made], capture_output=True, text=True)
    if done.returncode:
        said = next((line for line in done.stderr.splitlines() if "error" in line), done.stderr[:200])
        raise Missing(re.sub(r"^\S*?(firmware/|robots/|kernels\.cpp)", r"\1", said))
    objdump = "objdump" if build.compiler in ("g++", "clang++") else build.objdump()
    dump = subprocess.run([objdump, "-dr", "-w", made], check=True, capture_output=True, text=True).stdout
    return Code(split_relocations(dump), contents_of(objdump, made))


def split_relocations(dump):
    """objdump -w puts a relocation behind its instruction: each gets a line."""
    return re.sub(r"\t([0-9a-f]+): (R_\S+)\s+(\S+)(?=\s*$|\s+[0-9a-f]+: R_)", r"\n\t\t\t\1: \2\t\3", dump, flags=re.MULTILINE)


def compare(case, before, after):
    """The row of a case: is its code the same, and how many instructions has it."""
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        try:
            was, now = (code(case, tree, pathlib.Path(folder)).of(case.kernel) for tree in (before, after))
        except Missing as problem:
            return {**case._asdict(), "same": False, "before": None, "after": None, "problem": str(problem)}
    return {**case._asdict(), "same": was == now, "before": len(was), "after": len(now), "problem": ""}


def fails(row):
    if row["problem"]:
        return True
    return row["after"] > row["before"] if SCENES[row["scene"]].shares_drives else not row["same"]


def compare_all(cases, before, after):
    """Rows in the order of the cases; a line on standard error every half minute."""
    began, said, rows = time.monotonic(), 0.0, []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for row in pool.map(functools.partial(compare, before=before, after=after), cases):
            rows.append(row)
            seconds = time.monotonic() - began
            if seconds - said > 30.0 or len(rows) == len(cases):
                print(f"same-code: {len(rows)} of {len(cases)} kernels, {seconds:.0f} s", file=sys.stderr, flush=True)
                said = seconds
    return rows


def print_rows(rows):
    """What differs, what does not compile, and one line that counts."""
    differ = [row for row in rows if not row["same"] and not row["problem"]]
    if differ:
        cells = [[*(row[name] for name in Case._fields), "fails" if fails(row) else "no more", str(row["before"]), str(row["after"])]
                 for row in differ]
        size.print_columns([["scene", "number", "build", "kernel", "", "before", "after"], *cells], 5)
    for row in rows:
        if row["problem"]:
            print(f"{' '.join(row[name] for name in Case._fields)}: {row['problem']}")
    same = sum(row["same"] for row in rows)
    print(f"{same} of {len(rows)} kernels have the same machine code; instructions as they stand in the object")


def tree_of(before, folder):
    """Headers and robots of a revision; a folder is one already."""
    if pathlib.Path(before, "firmware/include").is_dir():
        return pathlib.Path(before).resolve()
    done = subprocess.run(["git", "-C", ROOT, "archive", before, "firmware/include", "robots"], capture_output=True)
    if done.returncode:
        sys.exit(f"axial same-code: {before} is no folder with firmware/include, and no revision: {done.stderr.decode().strip()}")
    subprocess.run(["tar", "-x", "-C", folder], input=done.stdout, check=True)
    return pathlib.Path(folder)


def names(option, known, text):
    """Of a list; all where there is none."""
    wanted = list(known) if text is None else text.split(",")
    for name in wanted:
        if name not in known:
            sys.exit(f"axial same-code: unknown {option} '{name}'; there are: {', '.join(known)}")
    return wanted


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0], prog="axial same-code")
    parser.add_argument("before")
    for option in ("scene", "number", "build", "kernel"):
        parser.add_argument(f"--{option}")
    parser.add_argument("--json")
    return parser.parse_args()


def main():
    options = parse_arguments()
    kernels = {kernel: None for scene in SCENES.values() for kernel in scene.kernels}
    wanted = [names(option, known, getattr(options, option))
              for option, known in (("scene", SCENES), ("number", NUMBERS), ("build", BUILDS), ("kernel", kernels))]
    cases = [case for case in map(Case._make, itertools.product(*wanted))
             if case.number in SCENES[case.scene].numbers and case.kernel in SCENES[case.scene].kernels]
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        rows = compare_all(cases, tree_of(options.before, folder), ROOT)
    print_rows(rows)
    if options.json:
        size.write_json(options.json, rows)
    sys.exit(1 if any(map(fails, rows)) else 0)


if __name__ == "__main__":
    main()
