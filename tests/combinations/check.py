#!/usr/bin/python3
"""Compiles and runs combinations of numbers, features, joints, twists and algorithms; holds what is not offered to its sentence.

usage: check.py [options]
  --compiler gcc|clang  default: both, one after the other
  --root DIR      the project (default: where this file is)
  --work DIR      where programs are written (default: a temporary folder)
  --part I/N      only every N-th combination and refusal, from the I-th on (I from 0)
  --only TEXT     only combinations whose description, algorithm or sentence has this text
  --jobs N        compilers at once (default: one a processor)
  --json FILE     an array of objects: compiler, combination, algorithm, refused, passed, message
  --list          says the combinations and stops
  --table         writes the table of doc/guides/not_offered.md and stops
  --check-table   exits 1 where doc/guides/not_offered.md has another table
Exits 1 where a combination does not compile, where its results are wrong, where something that is not offered compiles or
says something else first.
"""
import argparse
import concurrent.futures
import functools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import covering
import factors
import refusals

COMPILERS = {"gcc": "g++", "clang": "clang++"}
FLAGS = ["-std=c++17", "-O0", "-ffp-contract=off", "-DAXIAL_INLINE=", "-DAXIAL_USER_OPTIONS"]
# A user's build may be as strict as ours, whose warnings are GCC's.
FLAGS_OF = {"gcc": ["-fmax-errors=20", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Werror"], "clang": []}
BEGIN, END = "<!-- table not_offered -->", "<!-- end -->"
STRUCTURE = {"base": ("fixed",), "water": ("none",)}


@functools.cache
def combinations():
    """First what leaves every algorithm to offer, then what loads and features add."""
    plain = {factor: STRUCTURE.get(factor, values) for factor, values in factors.FACTORS.items()}
    structures = covering.covering_array(plain, refusals.is_refused, refusals.SEEDS)
    rows = covering.covering_array(factors.FACTORS, refusals.is_refused, structures)
    met = {meeting for row in rows for meeting in meetings(row)}
    for factor, values in factors.FACTORS.items():
        for value in values:
            row = {**factors.DEFAULT, factor: value}
            if not refusals.is_refused(row) and not meetings(row, factor) <= met:
                rows.append(row)
    return rows


def meetings(row, *of):
    """Algorithms that a row offers, with the values that they meet."""
    return {(algorithm, f, row[f]) for algorithm in refusals.offered(row) for f in of or factors.FACTORS}


def witnesses():
    """What must not compile: each refusal for each of its algorithms, where nothing else refuses it."""
    for number, refusal in enumerate(refusals.REFUSALS):
        c = {**factors.DEFAULT, **refusal.example}
        algorithms = refusal.algorithms
        if algorithms == refusals.ALGORITHMS:  # of the scene: one algorithm stands for all, another one for each scene
            algorithms = ("InverseDynamics", refusals.DYNAMICS[1 + number % (len(refusals.DYNAMICS) - 1)])
        for algorithm in algorithms:
            if not refusals.is_asked(c, algorithm):
                continue
            if [r.sentence for r in refusals.refusals_of(c, algorithm)] == [refusal.sentence]:
                yield refusal, c, algorithm


class Builder:
    def __init__(self, compiler, root, work):
        self.compiler, self.root, self.work = compiler, root, work
        self.flags = FLAGS + FLAGS_OF[compiler] + [f"-I{root}/firmware/include", f"-I{root}"]
        self.reference = work / "reference.o"

    def prepare(self):
        source = self.root / "tests/combinations/reference.cpp"
        subprocess.run([COMPILERS[self.compiler], *self.flags, "-c", source, "-o", self.reference], check=True)

    def compile(self, name, text):
        """What the compiler says, empty where it compiles; the object file."""
        source, product = self.work / f"{name}.cpp", self.work / f"{name}.o"
        source.write_text(text)
        command = [COMPILERS[self.compiler], *self.flags, "-c", str(source), "-o", str(product)]
        done = subprocess.run(command, capture_output=True, text=True)
        return (done.stderr or "the compiler failed") if done.returncode else "", product

    def run(self, name, product):
        program = self.work / name
        link = subprocess.run([COMPILERS[self.compiler], str(product), str(self.reference), "-o", str(program)],
                              capture_output=True, text=True)
        if link.returncode:
            return link.stderr
        done = subprocess.run([str(program)], capture_output=True, text=True, timeout=60)
        program.unlink()
        if done.returncode < 0:
            return f"ended by signal {-done.returncode}\n{done.stdout}"
        return done.stdout if done.returncode else ""


def first_error(output):
    for line in output.splitlines():
        if "error:" in line:
            return line.split("error:", 1)[1].strip()
    return output.strip().splitlines()[0] if output.strip() else ""


def outcome(builder, c, algorithm, refused, message):
    return {"compiler": builder.compiler, "combination": factors.text(c), "algorithm": algorithm, "refused": refused,
            "passed": not message, "message": message}


def check_combination(builder, index, c):
    """An outcome for each algorithm; one program for all of them, as long as it compiles."""
    names = refusals.offered(c)
    output, product = builder.compile(f"c{index}", factors.source(c, names))
    if output:
        return check_each_algorithm(builder, index, c, names)
    output = builder.run(f"c{index}", product)
    failed = parse(output)
    if output and not failed:
        failed = {name: output for name in names}
    return [outcome(builder, c, name, False, failed.get(name, "")) for name in names]


def check_each_algorithm(builder, index, c, names):
    outcomes = []
    for name in names:
        output, product = builder.compile(f"c{index}_{name}", factors.source(c, [name]))
        message = first_error(output) if output else builder.run(f"c{index}_{name}", product)
        outcomes.append(outcome(builder, c, name, False, message))
    return outcomes


def parse(output):
    """The lines of a program's output by the algorithm that they end with."""
    failed, lines = {}, []
    for line in output.splitlines():
        if line.startswith("failed: "):
            failed[line[len("failed: "):]] = "; ".join(lines)
            lines = []
        else:
            lines.append(line)
    return failed


def check_refusal(builder, index, refusal, c, algorithm):
    output, _ = builder.compile(f"r{index}", factors.source(c, [algorithm]))
    message = ""
    if not output:
        message = f"it compiles; take it off the list: {refusal.sentence}"
    elif refusal.sentence not in first_error(output):
        message = f"says '{first_error(output)}', not '{refusal.sentence}'"
    return [outcome(builder, c, algorithm, True, message)]


def table():
    rows = ["| not offered | what to do |", "|---|---|"]
    rows += [f"| {r.what} | {r.sentence.removeprefix('axial: ')} |" for r in refusals.REFUSALS]
    return "\n".join(rows)


def with_table(page):
    before, rest = page.split(BEGIN, 1)
    return f"{before}{BEGIN}\n{table()}\n{END}{rest.split(END, 1)[1]}"


def part_of(items, part):
    first, step = (int(x) for x in part.split("/"))
    return items[first::step]


def arguments():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--compiler", choices=COMPILERS, action="append")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--part", default="0/1")
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--json", type=pathlib.Path)
    for flag in ("--list", "--table", "--check-table"):
        parser.add_argument(flag, action="store_true")
    options = parser.parse_args()
    options.compiler = options.compiler or list(COMPILERS)
    return options


def tasks(builder):
    for index, c in enumerate(combinations()):
        yield (factors.text(c) + " ".join(refusals.offered(c)), check_combination, (builder, index, c))
    for index, (refusal, c, algorithm) in enumerate(witnesses()):
        yield (refusal.sentence + factors.text(c) + algorithm, check_refusal, (builder, index, refusal, c, algorithm))


class Progress:
    """On a terminal one line that counts; elsewhere a line every half minute, so that a log stays readable."""

    def __init__(self, compiler, count):
        self.compiler, self.count, self.done, self.begin, self.next = compiler, count, 0, time.monotonic(), 30

    def step(self):
        self.done += 1
        seconds = time.monotonic() - self.begin
        if sys.stderr.isatty():
            print(f"\r{self.compiler}: {self.done} of {self.count}, {seconds:.0f} s", end="", file=sys.stderr, flush=True)
        elif seconds >= self.next:
            print(f"{self.compiler}: {self.done} of {self.count}, {seconds:.0f} s", file=sys.stderr, flush=True)
            self.next = seconds + 30

    def say(self, text):
        print(("\r\033[K" if sys.stderr.isatty() else "") + text, flush=True)


def check_all(compiler, options, work):
    builder = Builder(compiler, options.root, work)
    builder.prepare()
    chosen = part_of([task for task in tasks(builder) if options.only in task[0]], options.part)
    outcomes, progress = [], Progress(compiler, len(chosen))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for found in concurrent.futures.as_completed([pool.submit(check, *rest) for _, check, rest in chosen]):
            outcomes += found.result()
            for o in found.result():
                if not o["passed"]:
                    progress.say(f"{compiler}: {o['algorithm']}: {o['combination']}\n  {o['message']}")
            progress.step()
    refused = sum(o["refused"] for o in outcomes)
    progress.say(f"{compiler}: {len(outcomes) - refused} combinations offered, {refused} refused, "
                 f"{sum(not o['passed'] for o in outcomes)} wrong")
    return outcomes


def run(options):
    if options.work:
        options.work.mkdir(parents=True, exist_ok=True)
        return [o for compiler in options.compiler for o in check_all(compiler, options, options.work)]
    with tempfile.TemporaryDirectory() as folder:
        return [o for compiler in options.compiler for o in check_all(compiler, options, pathlib.Path(folder))]


def main():
    options = arguments()
    page = options.root / "doc/guides/not_offered.md"
    if options.list:
        for c in combinations():
            print(factors.text(c), "|", " ".join(refusals.offered(c)))
        return 0
    if options.table:
        page.write_text(with_table(page.read_text()))
        return 0
    if options.check_table:
        same = with_table(page.read_text()) == page.read_text()
        print("" if same else "doc/guides/not_offered.md: another table; make it by tests/combinations/check.py --table")
        return 0 if same else 1
    outcomes = run(options)
    if options.json:
        outcomes.sort(key=lambda o: (o["compiler"], o["combination"], o["algorithm"]))
        options.json.write_text(json.dumps(outcomes, indent=1) + "\n")
    return 1 if any(not o["passed"] for o in outcomes) else 0


if __name__ == "__main__":
    sys.exit(main())
