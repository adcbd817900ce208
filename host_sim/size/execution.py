"""A probe under QEMU: what it counted, and every instruction that its kernel executed."""

import itertools
import os
import re
import subprocess

LISTED = re.compile(rb"^0x([0-9a-f]{8}):", re.MULTILINE)  # an instruction of a block


class Mismatch(Exception):
    pass


def ranges(addresses):
    """Address ranges, as -dfilter takes them, that hold all of these and little else."""
    found = []
    for address in sorted(addresses):
        if found and address - found[-1][1] <= 4:
            found[-1][1] = address
        else:
            found.append([address, address])
    return ",".join(f"{first:#x}..{last + 1:#x}" for first, last in found)


def run(qemu, path, entry, reached, timeout=120):
    """[(count, executed addresses)] for every state that the probe runs. `entry`: the kernel's first address;
    `reached`: all that it can reach. QEMU lists each block that it translates, and logs each that it enters."""
    reader, writer = os.pipe()
    command = [qemu["program"], *qemu["arguments"], "-serial", "null", "-kernel", str(path),
               "-d", "in_asm,exec,nochain", "-dfilter", ranges(reached), "-D", f"/dev/fd/{writer}"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, pass_fds=[writer])
    os.close(writer)
    with os.fdopen(reader, "rb") as log:
        executed = addresses(log.read())
    output = process.communicate(timeout=timeout)[0]
    if process.returncode != 0 or not output.endswith("end\n"):
        raise Mismatch(f"{path}: ended with {process.returncode}: {output[-200:]}")
    counts = [int(line.split(",")[1]) for line in output.splitlines() if line.startswith("count,")]
    return list(zip(counts, calls(path, executed, entry, counts)))


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
