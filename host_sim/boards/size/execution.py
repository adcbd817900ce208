"""A probe in its emulator: what it counted, and every instruction that its kernel executed."""

import itertools
import os
import pathlib
import re
import struct
import subprocess
import tempfile
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[3]
LISTED = re.compile(rb"^0x([0-9a-f]{8}):", re.MULTILINE)  # an instruction of a block


KERNEL = ("-kernel", "{}")  # how QEMU takes an image, where board.json has no other way
RETURN = 2  # cycles of BX, which a runner's count of an empty kernel holds


class Mismatch(Exception):
    pass


class Run(NamedTuple):
    """Of the kernel on one state."""

    count: int  # instructions without the return
    executed: list  # their addresses, and the return's
    accesses: list = ()  # words of flash behind a cache, in order: fetched or read. Of a runner alone, as is
    cycles: int = 0  # what the emulator counted, without the return


def ranges(addresses):
    """Address ranges, as -dfilter takes them, that hold all of these and little else."""
    found = []
    for address in sorted(addresses):
        if found and address - found[-1][1] <= 4:
            found[-1][1] = address
        else:
            found.append([address, address])
    return ",".join(f"{first:#x}..{last + 1:#x}" for first, last in found)


def run(board, path, entry, reached):
    """A Run for every state of the probe. `board`: its board.json. `entry`: the kernel's first address; `reached`: all that it can reach."""
    return run_in_qemu(board["qemu"], path, entry, reached) if "qemu" in board else run_by_runner(board["runner"], path, entry)


def printed_counts(path, code, output):
    if code != 0 or not output.endswith("end\n"):
        raise Mismatch(f"{path}: ended with {code}: {output[-200:]}")
    return [int(line.split(",")[1]) for line in output.splitlines() if line.startswith("count,")]


def run_by_runner(runner, path, entry, timeout=600):
    """The board counts cycles; the runner writes what was executed (host_sim/boards/rp2040/calls.js)."""
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        file = pathlib.Path(folder, "calls")
        command = [runner["program"], str(ROOT / runner["script"]), *runner["arguments"], "-fast", "-kernel", str(path), "-calls", f"{entry:x}:{file}"]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=timeout, check=False)
        counted = printed_counts(path, done.returncode, done.stdout)
        return list(runs_of(path, file.read_bytes(), counted))


def runs_of(path, log, counted):
    """What the runner wrote, held to the cycles that the board counted."""
    words = struct.unpack(f"<{len(log) // 4}I", log)
    at, calls = 0, 0
    while at < len(words):
        cycles, of_return, count = words[at:at + 3]
        accesses = words[at + 3:at + 3 + count]
        at += 3 + count
        executed = [word for word in accesses if not word & 1]
        if calls == len(counted) or counted[calls] != cycles + of_return - RETURN:
            raise Mismatch(f"{path}: call {calls} took {cycles + of_return} cycles, {counted[calls:calls + 1]} and a return were counted")
        calls += 1
        yield Run(len(executed) - 1, executed, [word & ~1 for word in accesses], cycles)
    if calls != len(counted):
        raise Mismatch(f"{path}: {calls} calls in the trace, {len(counted)} counts")


def run_in_qemu(qemu, path, entry, reached, timeout=120):
    """QEMU lists each block that it translates, and logs each that it enters."""
    reader, writer = os.pipe()
    command = [qemu["program"], *qemu["arguments"], "-serial", "null", *(part.format(path) for part in qemu.get("image", KERNEL)),
               "-d", "in_asm,exec,nochain", "-dfilter", ranges(reached), "-D", f"/dev/fd/{writer}"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, pass_fds=[writer])
    os.close(writer)
    with os.fdopen(reader, "rb") as log:
        executed = addresses(log.read())
    output = process.communicate(timeout=timeout)[0]
    counts = printed_counts(path, process.returncode, output)
    return list(map(Run, counts, calls(path, executed, entry, counts)))


def addresses(log):
    """What was executed. QEMU lists a block before it enters it for the first time, logs it whenever it enters it, and says
    so when it left it again before executing it."""
    blocks, entered = {}, []
    for translated in log.split(b"\nIN: "):
        listing, _, entries = translated.partition(b"\n\n")
        if entries.startswith(b"Trace"):
            line = entries.partition(b"\n")[0]  # the same each time: it holds the translation's own address
            blocks[line] = [int(address, 16) for address in LISTED.findall(listing)]
        for number, part in enumerate(entries.split(b"Stopped ")):
            if number > 0:
                entered.pop()
            entered += filter(None, map(blocks.get, part.split(b"\n")))
    return list(itertools.chain.from_iterable(entered))


def calls(path, executed, entry, counts):
    """The executed addresses of each call: as many as were counted and the return, which the count leaves out."""
    starts = [i for i, address in enumerate(executed) if address == entry]
    if len(starts) != len(counts):
        raise Mismatch(f"{path}: {len(starts)} calls in the trace, {len(counts)} counts")
    for start, end, count in zip(starts, starts[1:] + [len(executed)], counts):
        if start + count + 1 > end:
            raise Mismatch(f"{path}: {end - start} instructions in the trace, {count} and a return counted")
        yield executed[start:start + count + 1]
