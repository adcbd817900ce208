"""What compiler flags do to the kernels: each of KERNELS compiled with each set of flags.txt as each of BOARDS compiles it.
Nothing is run: an unrolled kernel is one straight line, so its instructions as they stand are those that a call executes;
flags that leave loops have no count.

usage: flags.py measure [--sets FILE] [--output FOLDER] [--json FILE]
       flags.py boards             prints the boards, which must be configured: ninja tells how it compiles a kernel
       flags.py provenance FILE    writes compiler, flags and commit
"""

import argparse
import concurrent.futures
import csv
import functools
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from typing import NamedTuple

import flag_sets
import execution
import measure
import size
import stack
from image import Image

SETS = pathlib.Path(__file__).parent / "flags.txt"
BOARDS = ("stm32f405", "mps2_an500")
KERNELS = (*((robot, algorithm) for robot in ("puma560", "panda")
             for algorithm in ("inverse_dynamics", "mass_matrix", "forward_dynamics")), ("scara", "closed_form"))
LEAVING = re.compile(r"^lr$|^pc, \[sp\]|\bpc\}$")  # operands of a return
RETURNS, LONGEST = ("bx", "pop", "ldr", "ldm"), 200_000
FIGURES = ("instructions", "cycles_estimated", "flash_bytes", "stack_bytes")
FIELDS = ("flags", "changes", "board", "robot", "scene", "algorithm", "scalar", "variant", "contract", *FIGURES)
LINK = ("-nostartfiles", "--specs=nano.specs", "-Wl,--gc-sections", f"-Wl,-e,{measure.KERNEL}")


class NotStraight(Exception):
    pass


# Precompiled once for all sets, with the functions whose results are deduced: naming the kernel's result instantiates them.
HEADER = """#include <firmware/apps/size/kernel.hpp>
using namespace axial::apps::size;
using Algorithm = algorithms::%s;
using Chosen = System::scene<scenes::bare, axial::apps::Robot>;
using Result = decltype(Algorithm::run<Chosen>(std::declval<const Argument<axial::apps::Robot, System::Number>&>()));
"""
SOURCE = 'extern "C" void %s(void* argument) { run<Algorithm, Chosen>(argument); }\n' % measure.KERNEL


class Compilation(NamedTuple):
    """How the build of a board compiles kernels of a robot."""
    compiler: tuple
    inputs: tuple  # definitions, folders, language
    flags: tuple

    def precompile(self, algorithm, header):
        header.write_text(HEADER % algorithm, encoding="utf-8")
        self._compile(self.flags, "-x", "c++-header", header, "-o", f"{header}.gch")

    def compile(self, flags, header, folder):
        """An image of the kernel alone. It is linked only to have addresses; debug data would only take time."""
        source, made, image = (folder / ("kernel" + ending) for ending in (".cpp", ".o", ".elf"))
        source.write_text(SOURCE, encoding="utf-8")
        self._compile(flags, "-include", self._fitting(header, flags, folder), "-c", source, "-o", made)
        subprocess.run([self.compiler[-1], *flags, *LINK, made, "-o", image], check=True)
        return Image(image)

    def _fitting(self, header, flags, folder):
        """Precompiled, unless the flags change macros: then the front end may know them, and a copy has the text alone. Where
        they change the target, GCC itself takes the text."""
        same = macros(self.compiler[-1], tuple(flags)) == macros(self.compiler[-1], self.flags)
        return header if same else shutil.copy(header, folder)

    def _compile(self, flags, *words):
        subprocess.run([*self.compiler, *flags, "-g0", *self.inputs, *words], check=True)


@functools.lru_cache
def macros(compiler, flags):
    return subprocess.run([compiler, *flags, "-dM", "-E", "-x", "c++", os.devnull], check=True, capture_output=True).stdout


def own_flags(board):
    """Of its toolchain file."""
    toolchain = measure.ROOT / measure.description(board)["toolchain"]
    script = pathlib.Path(__file__).parent / "toolchain_flags.cmake"
    return tuple(subprocess.run(["cmake", f"-DTOOLCHAIN={toolchain}", "-P", script], check=True, capture_output=True,
                                text=True).stdout.split())


def contract(flags):
    """The last one holds."""
    return [flag.partition("=")[2] for flag in flags if flag.startswith("-ffp-contract=")][-1]


def compilations(board):
    """{(robot, algorithm): Compilation}"""
    listing = subprocess.run(["ninja", "-C", measure.IMAGES / board, "-t", "compdb"], check=True, capture_output=True, text=True)
    commands = {pathlib.Path(entry["output"]).name: entry["command"] for entry in json.loads(listing.stdout)}
    flags, units = own_flags(board), measure.units(board)
    unit = lambda robot, algorithm: units[measure.Probe("", robot, "bare", algorithm, "unrolled", contract(flags)).name]
    return {kernel: split(commands[unit(*kernel) + ".cpp.obj"], flags) for kernel in KERNELS}


def split(command, flags):
    words = shlex.split(command)
    first = next(i for i, word in enumerate(words) if word.startswith("-"))
    inputs = [word for word in words if re.match("-D|-I|-isystem|-std=", word)]
    # The headers must not choose what is compared here.
    return Compilation(tuple(words[:first]), (*inputs, "-DAXIAL_USER_OPTIONS"), flags)


def straight_line(image, entry):
    """The instructions that a call executes, calls and its return included."""
    executed, address = [], entry
    while True:
        name, operands, size_of = image.instructions[address]
        executed.append(address)
        if LEAVING.search(operands) and name.startswith(RETURNS) and not stack.CONDITIONAL.match(name):
            return executed
        address += size_of
        if stack.CALL.match(name):
            executed += straight_line(image, int(operands.split()[0], 16))
        elif name in ("b", "b.n", "b.w"):  # over a pool of constants
            address = int(operands.split()[0], 16)
        elif stack.BRANCH.match(name) or stack.COMPARE_AND_BRANCH.match(name) or LEAVING.search(operands) or len(executed) > LONGEST:
            raise NotStraight(f"{image.function_at(address)}: {name} {operands}")


def cost(image, board):
    """Instructions and cycles; none where a branch or a loop hides them. The kernel's return is left out, as
    where QEMU counts."""
    try:
        executed = straight_line(image, image.functions[measure.KERNEL])
    except NotStraight:
        return None, None
    return len(executed) - 1, measure.timing.Model(measure.description(board)).of(execution.Run(len(executed) - 1, executed), image.instructions).cycles


def figures(work):
    """The row of one kernel, board and set."""
    chosen, board, (robot, algorithm), compilation, header = work
    flags = chosen.apply(compilation.flags)
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        image = compilation.compile(flags, header, pathlib.Path(folder))
    instructions, estimate = cost(image, board)
    return {"flags": chosen.name, "changes": " ".join(chosen.changes), "board": board, "robot": robot, "scene": "bare",
            "algorithm": algorithm, "scalar": "float", "variant": "unrolled", "contract": contract(flags),
            "instructions": instructions, "cycles_estimated": estimate, "flash_bytes": image.flash,
            "stack_bytes": stack.StackDepth(image).of(image.functions[measure.KERNEL])}


def precompiled(pool, folder):
    """[(board, kernel, Compilation, header)], the headers in the folder."""
    known = [(board, kernel, compilation, pathlib.Path(folder, "-".join((board, *kernel)) + ".hpp"))
             for board in BOARDS for kernel, compilation in compilations(board).items()]
    pending = [pool.submit(compilation.precompile, algorithm, header) for _, (_, algorithm), compilation, header in known]
    for each in pending:
        each.result()
    return known


def measure_all(sets):
    """Rows, set by set; a line on standard error as each is done."""
    began, rows = time.monotonic(), []
    with tempfile.TemporaryDirectory(prefix="axial-") as folder, concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        known = precompiled(pool, folder)
        pending = [[pool.submit(figures, (chosen, *each)) for each in known] for chosen in sets]
        try:
            for done, (chosen, of_set) in enumerate(zip(sets, pending), 1):
                rows += [row.result() for row in of_set]
                print(f"flags: {done} of {len(sets)}, {chosen.name} ({time.monotonic() - began:.0f} s)", file=sys.stderr, flush=True)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return rows


def total(rows, figure):
    """Over the kernels: their sum, of the stack the largest; none where one is not known."""
    values = [row[figure] for row in rows]
    return None if None in values else max(values) if figure == "stack_bytes" else sum(values)


def print_totals(rows):
    """A line a set and board; the last column compares with the first set."""
    groups = {}
    for row in rows:
        groups.setdefault((row["flags"], row["board"]), []).append(row)
    cells = [["flags", "board", *FIGURES, "cycles"]]
    for (name, board), of_set in groups.items():
        totals = {figure: total(of_set, figure) for figure in FIGURES}
        cycles_of_set, first = totals["cycles_estimated"], total(groups[rows[0]["flags"], board], "cycles_estimated")
        change = "" if None in (cycles_of_set, first) else f"{cycles_of_set / first - 1:+.1%}"
        cells.append([name, board, *("loops" if value is None else str(value) for value in totals.values()), change])
    size.print_columns(cells, 2)
    print(f"sums over {len(KERNELS)} kernels, of the stack the largest; cycles by the core's model")


def run_measure(options):
    rows = measure_all(flag_sets.parse(options.sets.read_text(encoding="utf-8")))
    print_totals(rows)
    if options.json:
        size.write_json(options.json, rows)
    options.output.mkdir(parents=True, exist_ok=True)
    with open(options.output / "flags.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print(f"written: {options.output}/flags.csv")


def run_boards(_):
    print(*BOARDS)


def run_provenance(options):
    size.write_json(options.file, size.provenance({board: " ".join(own_flags(board)) for board in BOARDS}))


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0], prog="axial size --flags")
    verbs = parser.add_subparsers(required=True)
    verbs.add_parser("boards").set_defaults(run=run_boards)
    provenance = verbs.add_parser("provenance")
    provenance.add_argument("file")
    provenance.set_defaults(run=run_provenance)
    every = verbs.add_parser("measure")
    every.add_argument("--sets", type=pathlib.Path, default=SETS)
    every.add_argument("--output", type=pathlib.Path, default=measure.ROOT / "output/size")
    every.add_argument("--json")
    every.set_defaults(run=run_measure)
    return parser.parse_args()


def main():
    options = parse_arguments()
    try:
        options.run(options)
    except (OSError, flag_sets.Invalid, stack.Unbounded, subprocess.CalledProcessError) as error:
        sys.exit(f"axial size --flags: {error}")


if __name__ == "__main__":
    main()
