"""Runs drawn mutants, each against one test after the other until one notices it, in a folder that keeps what was found."""

import concurrent.futures
import json
import queue
import subprocess
import threading
import time
import zlib

import build
import programs
import reach
import table
import trim

FOLDER = table.ROOT / "build/mutants"
SECONDS = 40  # of compiling and running that a mutant is worth


class Verdicts:
    """A file of what became of each change: whoever interrupts a run goes on with it."""

    def __init__(self, path):
        self.path, self.lock = path, threading.Lock()
        self.rows = {row["change"]: row for row in json.loads(path.read_text())} if path.exists() else {}

    def add(self, row):
        with self.lock:
            self.rows[row["change"]] = row
            written = self.path.with_suffix(".new")
            written.write_text(json.dumps(list(self.rows.values()), indent=1) + "\n")
            written.replace(self.path)


class DrawnRun:
    """As many mutants at a time as there are copies of the sources."""

    def __init__(self, jobs, mutants, killers, seconds, folder):
        folder.mkdir(parents=True, exist_ok=True)
        self.programs = programs.CMakePrograms(folder / "cmake")
        self.reach = reach.Reach(self.programs, mutants, killers)
        self.folder, self.locks, self.seconds = folder, {}, seconds
        self.sound = {each: True for each in self.reach.recorded()}  # (test, filter) that pass unchanged, as mutants of the table have shown
        self.lock = threading.Lock()
        subprocess.run(["rm", "-rf", *(str(folder / f"copy{job}") for job in range(jobs)), str(folder / "objects")], check=True)
        self.objects = build.Objects(folder / "objects")
        self.objects.precompile()
        self.copies = queue.SimpleQueue()
        for job in range(jobs):
            (folder / f"copy{job}").mkdir()
            self.copies.put(build.Copy(folder / f"copy{job}"))
        self.jobs = jobs

    def each(self, mutants, verdicts):
        """(mutant, its row) as they come."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            futures = {pool.submit(self.judge, mutant, verdicts.get(mutant.breaks, {}).get("tried", {})): mutant for mutant in mutants}
            try:
                for future in concurrent.futures.as_completed(futures):
                    yield futures[future], future.result()
            finally:
                pool.shutdown(cancel_futures=True)

    def judge(self, mutant, tried):
        """killed_by is empty where no test noticed the change, and where none was there to try. What was tried once is not, as long as that source is the same."""
        copy, begin, spent = self.copies.get(), time.monotonic(), 0.0
        row = {"change": mutant.breaks, "mutant": mutant.name, "file": mutant.file, "killed_by": "", "tried": dict(tried)}
        try:
            for test, tests in self.reach.attempts(mutant.file, int(mutant.filter)):
                text = zlib.crc32((copy.folder / "tests" / test).read_bytes())
                cost = 1.0 if is_refusal(test) else self.reach.seconds(test, mutant.file, tests)
                if row["killed_by"] or tried.get(f"{test} {tests}") == text or spent and spent + cost > self.seconds:
                    continue
                row["killed_by"] = self.killer(copy, mutant, test, tests)
                row["tried"][f"{test} {tests}"] = text
                spent += cost
            return {**row, "seconds": round(time.monotonic() - begin, 1)}
        finally:
            self.copies.put(copy)

    def killer(self, copy, mutant, test, tests):
        """What fails with the change and not without."""
        with copy.changed(mutant.file, mutant.apply):
            failed = self.failure(copy, test, tests, mutant.file)
        if not failed:
            return ""
        if failed.startswith(f"compiler: {mutant.file}:"):
            return failed
        if (test, tests) not in self.sound:
            self.sound[test, tests] = not self.failure(copy, test, tests, mutant.file)
        return failed if self.sound[test, tests] else ""

    def failure(self, copy, test, tests, file):
        """What of those tests fails in a copy, a file of which may be changed; what does not read that file is compiled once."""
        if is_refusal(test):
            return refusal_failure(copy, test)
        sources, libraries = self.programs.of(test)
        made = copy.folder / "mutant"
        made.mkdir(exist_ok=True)
        try:
            objects = []
            text, tests = trim.trimmed((copy.folder / "tests" / test).read_text(), tests)
            with copy.changed(f"tests/{test}", lambda _: text):
                for source, flags in sources:
                    path = self.objects.path(source, flags)
                    if source == f"tests/{test}" or file in reach.read_by(source):
                        path = made / path.name
                        build.compile_source(copy, source, flags, path, self.objects.precompiled)
                    else:
                        self.compile_once(copy, source, flags, path)
                    objects.append(path)
            build.link(objects, libraries, made / "program")
        except build.BuildError as error:
            return f"compiler: {error}"
        return build.run(made / "program", tests)[2]

    def compile_once(self, copy, source, flags, path):
        with self.lock:
            lock = self.locks.setdefault(path, threading.Lock())
        with lock:
            if not path.exists():
                build.compile_source(copy, source, flags, path, self.objects.precompiled)


def is_refusal(test):
    return test.startswith("compile_fail/")


def refusal_failure(copy, test):
    """What tests/compile_fail/check.cmake says of a source of its own."""
    command = ["cmake", "-DCOMPILER=g++", f"-DSOURCE={copy.folder / 'tests' / test}", f"-DROOT={copy.folder}", "-P", "check.cmake"]
    done = subprocess.run(command, cwd=copy.folder / "tests/compile_fail", capture_output=True, text=True)
    said = [line.strip() for line in done.stderr.splitlines() if line.startswith("  ")]
    return f"{test}: {said[0] if said else 'check.cmake failed'}" if done.returncode else ""


def run(mutants, jobs, known, killers, verdicts, again=False, seconds=SECONDS, folder=FOLDER):
    """Tries those that have no verdict; those that survived too if asked to."""
    todo = [mutant for mutant in mutants if mutant.breaks not in verdicts.rows or (again and not verdicts.rows[mutant.breaks]["killed_by"])]
    print(f"{len(mutants)} drawn, {len(mutants) - len(todo)} of them judged before, in {verdicts.path}", flush=True)
    begin = time.monotonic()
    for done, (mutant, row) in enumerate(DrawnRun(jobs, known, killers, seconds, folder).each(todo, verdicts.rows) if todo else (), 1):
        verdicts.add(row)
        said = row["killed_by"] or f"SURVIVED {len(row['tried'])}: {mutant.breaks}"
        print(f"{done:3} of {len(todo)}, {time.monotonic() - begin:.0f} s  {mutant.name:10} {row['seconds']:5} s  {said}", flush=True)
    return [verdicts.rows[mutant.breaks] for mutant in mutants if mutant.breaks in verdicts.rows]
