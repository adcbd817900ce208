"""What a kernel costs whoever compiles it: processor seconds and peak memory of one source that calls it.

usage: compile_cost.py [choice] [--runs N] [--output FOLDER] [--json FILE]
       compile_cost.py provenance FILE    writes commit, compilers, flags, processor and its load
choice: [--build NAME] [--robot NAME] [--number NAME] [--kernel NAME], each a name or a list, separated by commas
The kernel `headers` is a source that includes the library and calls nothing.
"""

import argparse
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[3]
CORTEX_M4F = ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-fno-exceptions", "-fno-rtti")
BUILDS = {
    "cortex_m4f-O2": ("arm-none-eabi-g++", "-O2", *CORTEX_M4F),
    "cortex_m4f-O0": ("arm-none-eabi-g++", "-O0", *CORTEX_M4F),
    "host-gcc-O2": ("g++", "-O2"),
    "host-clang-O2": ("clang++", "-O2"),
}
ROBOTS = {"puma560": "Puma560", "panda": "Panda"}
NUMBERS = {"float": "float", "double": "double", "fixed32": "axial::Fixed32"}
KERNELS = {
    "headers": None,
    "inverse_dynamics": "axial::inverse_dynamics<Robot>(q, qd, qdd)",
    "gravity": "axial::gravity_torque<Robot>(q)",
    "mass_matrix": "axial::mass_matrix<Robot>(q)",
    "forward_dynamics": "axial::forward_dynamics<Robot>(q, qd, tau)",
    "forward_kinematics": "axial::forward_kinematics<Robot>(q)",
    "jacobian": "axial::jacobian<Robot>(q)",
    "separation": "axial::separate<Robot>(q)",
    "momenta": "axial::momentum_terms<Robot>(q, qd)",
}
CHOICES = {"build": BUILDS, "robot": ROBOTS, "number": NUMBERS, "kernel": KERNELS}
HEADERS = """#include <axial/{umbrella}.hpp>
#include <axial/dynamics/momentum.hpp>
#include <robots/{robot}.hpp>
"""
CALL = """
using Robot = robots::{type};
using Number = {number};
auto kernel([[maybe_unused]] const axial::Positions<Robot, Number>& q, [[maybe_unused]] const axial::Velocities<Robot, Number>& qd,
            [[maybe_unused]] const axial::Accelerations<Robot, Number>& qdd, [[maybe_unused]] const axial::Efforts<Robot, Number>& tau) {{
  return {call};
}}
"""


class Case(NamedTuple):
    build: str
    robot: str
    number: str
    kernel: str

    @property
    def source(self):
        headers = HEADERS.format(umbrella="fixed" if self.number == "fixed32" else "axial", robot=self.robot)
        call = KERNELS[self.kernel]
        return headers if call is None else headers + CALL.format(type=ROBOTS[self.robot], number=NUMBERS[self.number], call=call)


def flags(build):
    return ("-std=c++17", *BUILDS[build][1:])


def compiled(build, source, product):
    """(processor seconds, peak KiB) of one compilation: of the compiler's own processes, whatever else the machine does."""
    command = [BUILDS[build][0], *flags(build), f"-I{ROOT}/firmware/include", f"-I{ROOT}", "-c", source, "-o", product]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    errors = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stderr.close()
    if process.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{errors}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss


def measure(case, runs, folder):
    """The least of the runs: what other processes do to caches and clock only adds."""
    source = folder / "kernel.cpp"
    source.write_text(case.source, encoding="utf-8")
    seconds, memory = zip(*(compiled(case.build, source, folder / "kernel.o") for _ in range(runs)))
    return {**case._asdict(), "runs": runs, "seconds": round(min(seconds), 2), "memory_MiB": round(min(memory) / 1024)}


class Progress:
    """On a terminal one line that counts; elsewhere a line every half minute, so that a log stays readable."""

    def __init__(self, count):
        self.count, self.done, self.begin, self.next = count, 0, time.monotonic(), 30

    def step(self):
        self.done += 1
        seconds = time.monotonic() - self.begin
        text = f"compiling: {self.done} of {self.count}, {seconds:.0f} s"
        if sys.stderr.isatty():
            print(f"\r{text}", end="" if self.done < self.count else "\n", file=sys.stderr, flush=True)
        elif seconds >= self.next:
            print(text, file=sys.stderr, flush=True)
            self.next = seconds + 30


def measure_all(cases, runs):
    """Rows in the order of the cases, one compiler at a time: two would share caches and memory bandwidth."""
    progress, rows = Progress(len(cases)), []
    with tempfile.TemporaryDirectory() as folder:
        for case in cases:
            rows.append(measure(case, runs, pathlib.Path(folder)))
            progress.step()
    return rows


def chosen(options):
    """Headers are the same source for every number: they count once, as float's."""
    names = []
    for choice, known in CHOICES.items():
        wanted = getattr(options, choice)
        names.append(list(known) if wanted is None else wanted.split(","))
        for name in names[-1]:
            if name not in known:
                raise ValueError(f"unknown {choice} '{name}'; there are: {', '.join(known)}")
    cases = [Case(*each) for each in itertools.product(*names)]
    return [case for case in cases if case.kernel != "headers" or case.number == names[2][0]]


def print_table(rows):
    header = ["build", "robot", "number", "kernel", "seconds", "MiB"]
    cells = [header] + [[row["build"], row["robot"], row["number"], row["kernel"], f"{row['seconds']:.2f}", str(row["memory_MiB"])]
                        for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(header))]
    for line in cells:
        print("  ".join(cell.rjust(width) if i > 3 else cell.ljust(width)
                        for i, (cell, width) in enumerate(zip(line, widths))).rstrip())


def write_json(path, value):
    pathlib.Path(path).write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")


def run_measure(options):
    rows = measure_all(chosen(options), options.runs)
    print_table(rows)
    folder = pathlib.Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    write_json(folder / "compile_cost.json", rows)
    if options.json:
        write_json(options.json, rows)
    print(f"written: {folder}/compile_cost.json")


def first_line(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\n")[0]


def processor():
    lines = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))


def provenance(names):
    builds = {build: {"compiler": first_line(BUILDS[build][0], "--version"), "flags": " ".join(flags(build))} for build in names}
    return {"commit": first_line(ROOT / "host_sim/tools/system/commit.sh"), "builds": builds, "processor": processor(),
            "processors": os.cpu_count(), "load": round(os.getloadavg()[2], 1)}


def run_provenance(options):
    write_json(options.file, provenance(BUILDS))


def parse(arguments):
    parser = argparse.ArgumentParser(usage=__doc__)
    if arguments[:1] == ["provenance"]:
        parser.set_defaults(run=run_provenance)
        parser.add_argument("verb")
        parser.add_argument("file")
        return parser.parse_args(arguments)
    parser.set_defaults(run=run_measure)
    for choice in CHOICES:
        parser.add_argument("--" + choice)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--output", default=ROOT / "output/compile_cost")
    parser.add_argument("--json")
    options = parser.parse_args(arguments)
    if options.runs < 1:
        parser.error("--runs wants one or more")
    return options


def main():
    options = parse(sys.argv[1:])
    try:
        options.run(options)
    except ValueError as error:
        sys.exit(f"axial: {error}")


if __name__ == "__main__":
    main()
