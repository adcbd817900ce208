"""What a user's build makes of kernels: each of KERNELS compiled with each of BUILDS, linked as a probe is and run in QEMU.

usage: builds.py measure [--json FILE]
       builds.py boards             prints the boards
       builds.py targets BOARD      prints what must be built for a board: probes without a kernel
       builds.py provenance FILE    writes compilers, flags and commit
"""

import argparse
import concurrent.futures
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
from typing import NamedTuple

import flags
import measure
import size
import stack
from image import memory, sections

OURS = "as our boards"
FAULT = 70  # what an image ends with (hal/semihosting.hpp)
LEVELS = ("-O0", "-Og", "-O1", "-Os", "-O2", "-O3")


class Build(NamedTuple):
    compiler: str  # gcc or clang
    level: str  # or OURS: all flags of the toolchain file
    users: bool = False  # whether the user's options hold in the headers too

    @property
    def name(self):
        return f"{self.compiler}, {self.level}" + (", AXIAL_USER_OPTIONS" if self.users else "")


class Kernel(NamedTuple):
    board: str
    algorithm: str
    scalar: str
    robot: str = "panda"

    @property
    def probe(self):
        """The probe that is linked likewise."""
        return measure.Probe("", self.robot, "bare", self.algorithm, "unrolled", "off", self.scalar)


KERNELS = (Kernel("stm32f405", "feedforward", "float"), Kernel("stm32f405", "forward_dynamics", "float"),
           Kernel("nrf51", "inverse_dynamics", "fixed32"), Kernel("nrf51", "forward_dynamics", "fixed32"))
BUILDS = (Build("gcc", OURS), *(Build("gcc", level) for level in LEVELS), *(Build("gcc", level, True) for level in ("-O0", "-Og", "-Os", "-O2")),
          *(Build("clang", level) for level in ("-O0", "-O1", "-Os", "-O2")))
# Of the toolchain file's flags, those that any firmware has: the target, sections, no exceptions.
SHARED = ("-m", "-ffp-contract=", "-ffunction-sections", "-fdata-sections", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics")
SOURCE = flags.HEADER + flags.SOURCE


def probe_command(kernel):
    """The last two commands of the probe's build: how its source is compiled and how it is linked."""
    listing = subprocess.run(["ninja", "-C", measure.IMAGES / kernel.board, "-t", "commands", "size-" + kernel.probe.name], check=True,
                             capture_output=True, text=True).stdout.splitlines()
    unit = measure.units(kernel.board)[kernel.probe.name] + ".cpp.obj"
    return next(line for line in listing if f"/{unit} -c" in line), listing[-1]


def chosen_flags(build, board):
    own = flags.own_flags(board)
    if build.level == OURS:
        return list(own)
    return [flag for flag in own if flag.startswith(SHARED)] + [build.level] + ["-DAXIAL_USER_OPTIONS"] * build.users


def system_includes(compiler):
    """Where a cross compiler has its headers, for another one."""
    said = subprocess.run([compiler, "-E", "-v", "-x", "c++", os.devnull], check=True, capture_output=True, text=True).stderr
    folders = map(os.path.realpath, said.split("search starts here:")[-1].split("End of search list")[0].split())
    return [word for folder in folders if "/lib/gcc/" not in folder for word in ("-isystem", folder)]


def compiler(build, gcc):
    return [gcc] if build.compiler == "gcc" else ["clang++", "--target=arm-none-eabi", "-fshort-enums", "-Wno-#pragma-messages", *system_includes(gcc)]


def linked(command, made, image):
    """The probe's link, of another kernel into another image; Clang's objects have a note that others lack, of which the linker warns."""
    words = [word for word in shlex.split(command.strip(": &")) if word not in ("&&", ":", "-Wl,--fatal-warnings")]
    at = words.index("-o")
    return words[:at] + ["-o", str(image), str(made)]


def work():
    """What is measured: on the smallest core GCC's levels, and beside them the one that takes the most stack."""
    return [(kernel, build) for kernel in KERNELS for build in BUILDS
            if kernel.scalar == "float" or (build.compiler == "gcc" and (not build.users or build.level == "-Og"))]


def row(work):
    kernel, build = work
    compiled, link = probe_command(kernel)
    taken_apart = flags.split(compiled, ())
    inputs = [word for word in taken_apart.inputs if word != "-DAXIAL_USER_OPTIONS"]
    folder = measure.IMAGES / kernel.board
    with tempfile.TemporaryDirectory(prefix="axial-") as temporary:
        source, made, image = (pathlib.Path(temporary) / ("kernel" + ending) for ending in (".cpp", ".o", ".elf"))
        source.write_text(SOURCE % kernel.algorithm, encoding="utf-8")
        subprocess.run([*compiler(build, taken_apart.compiler[-1]), *chosen_flags(build, kernel.board), "-fstack-usage", "-g0", "-Wno-psabi",
                        *inputs, "-c", source, "-o", made], check=True, cwd=folder)
        subprocess.run(linked(link, made, image), check=True, cwd=folder, stderr=subprocess.DEVNULL if build.compiler == "clang" else None)
        empty = measure.memory_of_empty(measure.path_of(kernel.board, kernel.probe.empty))
        return {"compiler": build.compiler, "flags": build.level, "user_options": build.users, **kernel._asdict(),
                "instructions": max(counts(kernel.board, image), default=None), "frame_bytes": max(stack.compiler_frames(made.with_suffix(".su")).values()),
                "flash_bytes": memory(sections(image))[0] - empty[0]}


def counts(board, image):
    """What the probe prints: a count for each state; none where it ends in a fault, as where the stack runs over."""
    qemu = measure.description(board)["qemu"]
    done = subprocess.run([qemu["program"], *qemu["arguments"], "-serial", "null", "-kernel", image], stdin=subprocess.DEVNULL, timeout=120,
                          capture_output=True, text=True, check=False)
    if done.returncode not in (0, FAULT):
        raise subprocess.CalledProcessError(done.returncode, image, done.stdout)
    return [int(line.split(",")[1]) for line in (done.stdout + done.stderr).splitlines() if line.startswith("count,")]


def rows(work):
    with concurrent.futures.ProcessPoolExecutor(int(os.environ.get("AXIAL_JOBS", os.cpu_count()))) as pool:
        return list(pool.map(row, work))


def run_measure(options):
    found = rows(work())
    header = ["compiler", "flags", "user_options", "board", "algorithm", "scalar", "instructions", "frame_bytes", "flash_bytes"]
    size.print_columns([header] + [[str(each[name]) for name in header] for each in found], 6)
    if options.json:
        size.write_json(options.json, found)


def run_boards(_):
    print(*sorted({kernel.board for kernel in KERNELS}))


def run_targets(options):
    print(*sorted({"size-" + kernel.probe.empty for kernel in KERNELS if kernel.board == options.board}))


def run_provenance(options):
    boards = {kernel.board for kernel in KERNELS}
    clang = subprocess.run(["clang++", "--version"], check=True, capture_output=True, text=True).stdout.split("\n")[0]
    size.write_json(options.file, {**size.provenance({board: " ".join(flags.own_flags(board)) for board in sorted(boards)}), "clang": clang})


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0], prog="axial size --builds")
    verbs = parser.add_subparsers(required=True)
    for run in (run_measure, run_boards, run_targets, run_provenance):
        verb = verbs.add_parser(run.__name__.removeprefix("run_"))
        verb.set_defaults(run=run)
        if run is run_measure:
            verb.add_argument("--json")
        if run is run_targets:
            verb.add_argument("board")
        if run is run_provenance:
            verb.add_argument("file")
    options = parser.parse_args()
    try:
        options.run(options)
    except (OSError, stack.Unbounded, subprocess.CalledProcessError) as error:
        sys.exit(f"axial size --builds: {error}")


if __name__ == "__main__":
    main()
