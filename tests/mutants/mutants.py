#!/usr/bin/python3
"""Changes one line of the library at a time and expects the test that the table names to fail. See README.md."""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import queue
import re
import subprocess
import sys
import tempfile
import time

import build
import drawn
import drawn_run
import essence
import table
import trim

KILLERS = table.HERE / "killers.json"  # by mutant, the test that killed it last: it is compiled alone, the whole source only if it passes


def parts_of(text):
    """K/N."""
    number, count = map(int, text.split("/"))
    if not 1 <= number <= count:
        raise argparse.ArgumentTypeError("1 <= K <= N")
    return number, count


def arguments():
    parser = argparse.ArgumentParser(prog="./axial mutants", description="Each mutant changes one place of the sources; the test that "
                                     "the table names must fail with it and pass without. Ends with status 1 if a mutant survives.")
    parser.add_argument("--only", metavar="REGEX", help="only mutants whose names match")
    parser.add_argument("--part", metavar="K/N", type=parts_of, help="the K-th of N parts of the same size")
    parser.add_argument("--rotate", metavar="N", type=int, help="one part of N: which one, the commit tells")
    parser.add_argument("--essence", metavar="N", type=int, help="N mutants, which ones the commit tells, against tests of ./axial test alone")
    parser.add_argument("--draw", metavar="N", type=int, help="N mutants made from the code by operators, each against tests of its file and folder")
    parser.add_argument("--seed", metavar="N", type=int, help="of --essence and --draw, instead of the commit")
    parser.add_argument("--again", action="store_true", help="of --draw: try survivors of an earlier run once more")
    parser.add_argument("--seconds", metavar="N", type=float, default=drawn_run.SECONDS, help="of --draw: of compiling and running that a mutant is worth")
    parser.add_argument("--record", action="store_true", help="remember which test killed which mutant: it is tried first")
    parser.add_argument("--list", action="store_true", help="say which mutants there are, and run none")
    parser.add_argument("--check", action="store_true", help="only see whether every mutant's text stands in its file, once")
    parser.add_argument("--json", metavar="FILE", help="the rows as an array of objects: mutant, file, killed_by (empty: survived)")
    parser.add_argument("--jobs", metavar="N", type=int, default=os.cpu_count(), help="mutants at a time")
    return parser.parse_args()


def commit_number():
    """The same for the same commit; 0 where there is none."""
    done = subprocess.run(["git", "-C", str(table.ROOT), "rev-parse", "HEAD"], capture_output=True, text=True)
    return int(done.stdout.strip()[:8], 16) if done.returncode == 0 else 0


def chosen(mutants, options):
    if options.only:
        mutants = [mutant for mutant in mutants if re.search(options.only, mutant.name)]
    if options.rotate:
        options.part = commit_number() % options.rotate + 1, options.rotate
        print(f"part {options.part[0]} of {options.rotate}; to repeat it: ./axial mutants --part {options.part[0]}/{options.rotate}")
    mutants = table.part(mutants, *options.part) if options.part else mutants
    seed = commit_number() if options.seed is None else options.seed
    if options.essence:
        mutants = essence.sample(mutants, options.essence, seed)
    return mutants


def known_killers():
    return json.loads(KILLERS.read_text()) if KILLERS.exists() else {}


class Run:
    """Mutants in copies of the sources, as many at a time as there are copies."""

    def __init__(self, folder, jobs):
        self.folder = folder
        self.killers = known_killers()
        self.programs = build.Programs()
        self.objects = build.Objects(folder / "objects")
        self.objects.precompile()
        self.copies = queue.SimpleQueue()
        for i in range(jobs):
            (folder / f"copy{i}").mkdir()
            self.copies.put(build.Copy(folder / f"copy{i}"))
        self.pool = concurrent.futures.ThreadPoolExecutor(jobs)

    def in_copy(self, work, *arguments):
        """work(copy, ...) with a copy that nobody else has."""
        copy = self.copies.get()
        try:
            return work(copy, *arguments)
        finally:
            self.copies.put(copy)

    def each(self, work, items):
        """(item, result) as they come."""
        futures = {self.pool.submit(self.in_copy, work, item): item for item in items}
        for future in concurrent.futures.as_completed(futures):
            yield futures[future], future.result()

    def tests_of(self, mutant):
        """Filters to try in turn: the test that killed it last, then all that the table names."""
        last = re.fullmatch(r"([\w/]+\.(\w+))(/\w+)?", self.killers.get(mutant.name, ""))
        if not last or not re.search(rf"\b{last[2]}\b", (table.ROOT / "tests" / mutant.test).read_text()):
            return [mutant.filter]
        return list(dict.fromkeys([last[0], mutant.filter]))

    def compile_unchanged(self, mutants):
        """The objects of all programs, of the tests that some mutant's filter selects; a compile-fail source has none."""
        filters = collections.defaultdict(set)
        for mutant in mutants:
            filters[f"tests/{mutant.test}"].add("" if mutant.by_compiler else self.tests_of(mutant)[0])
        sources = {(source, tuple(flags)) for mutant in mutants if not drawn_run.is_refusal(mutant.test)
                   for source, flags in self.programs.of(mutant.test)[0]}
        items = [(source, flags, "" if "" in filters[source] else ":".join(filters[source])) for source, flags in sorted(sources)]
        for (source, *_), _ in self.each(self.compile_one, items):
            progress(f"compiled {source}")

    def compile_one(self, copy, item):
        source, flags, tests = item
        with copy.changed(source, lambda text: trim.only_tests(text, tests)):
            build.compile_source(copy, source, list(flags), self.objects.path(source, flags), self.objects.precompiled)

    def unchanged_failures(self, mutants):
        """What is wrong with the tests before anything is changed, by the test. A killer on record that is no test any
        more, or none that can be compiled alone, is forgotten: what the table names is tried."""
        filters, failures, stale = collections.defaultdict(set), {}, []
        for mutant in mutants:
            filters[mutant.test].add((self.tests_of(mutant)[0] or "*", mutant.by_compiler))
        for (test, _), (failure, missing) in self.each(self.unchanged_failure, sorted(filters.items())):
            lost = [mutant for mutant in mutants if mutant.test == test and self.tests_of(mutant)[0] in missing]
            stale += [mutant for mutant in lost if mutant.filter != self.tests_of(mutant)[0]]
            named = sorted(mutant.filter for mutant in lost if mutant.filter == self.tests_of(mutant)[0])
            failure = failure or (f"no test is called {named[0]}" if named else "")
            failures.update({test: failure} if failure else {})
        if not stale:
            return failures
        for mutant in stale:
            del self.killers[mutant.name]
        self.compile_unchanged(stale)
        return {**self.unchanged_failures(stale), **failures}

    def unchanged_failure(self, copy, item):
        """What fails, and the filters that select no test."""
        test, filters = item
        if drawn_run.is_refusal(test):
            return drawn_run.refusal_failure(copy, test), set()
        sources, libraries = self.programs.of(test)
        program, missing = self.folder / re.sub(r"\W", "_", test), set()
        build.link([self.objects.path(source, flags) for source, flags in sources], libraries, program)
        for tests, by_compiler in sorted(filters):
            passed, ran, failed = build.run(program, tests)
            if ran == 0 and not by_compiler:
                missing.add(tests)
            elif not passed:
                return f"fails unchanged: {failed}", missing
        return "", missing

    def killed_by(self, copy, mutant):
        """The test that fails, empty where none does; and what is wrong with the mutant itself."""
        try:
            with copy.changed(mutant.file, mutant.apply):
                if drawn_run.is_refusal(mutant.test):
                    failure = drawn_run.refusal_failure(copy, mutant.test)
                    return failure, ""
                return self.failing_test(copy, mutant), ""
        except (table.TableError, build.BuildError) as error:
            return "", str(error)

    def failing_test(self, copy, mutant):
        killer = ""
        for tests in self.tests_of(mutant):
            killer = killer or self.failing_of(copy, mutant, tests)
        return killer

    def failing_of(self, copy, mutant, tests):
        """The first of those tests that fails with the mutant."""
        sources, libraries = self.programs.of(mutant.test)
        suite, objects = tests.split(".")[0], []
        if not any(self.objects.depend_on(source, flags, mutant.file) for source, flags in sources):
            raise table.TableError(f"{mutant.test} does not include {mutant.file}")
        for source, flags in sources:
            path = self.objects.path(source, flags)
            if not self.objects.depend_on(source, flags, mutant.file):
                objects.append(path)
                continue
            text = (copy.folder / source).read_text()
            if source == f"tests/{mutant.test}" and not mutant.by_compiler:
                text, tests = trim.trimmed(text, tests)
            path = copy.folder / "mutant" / path.name
            path.parent.mkdir(exist_ok=True)
            try:
                with copy.changed(source, lambda _, kept=text: kept):
                    build.compile_source(copy, source, flags, path, self.objects.precompiled)
            except build.BuildError as error:
                if mutant.by_compiler:
                    return f"compiler: {error}"
                raise table.TableError(f"does not compile: {error}") from error
            objects.append(path)
        program = copy.folder / "mutant" / "program"
        build.link(objects, libraries, program)
        return build.run(program, tests)[2].replace(tests.split(".")[0], suite)


def progress(text):
    """A line that the next one overwrites; nothing where nobody looks."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text[:100]}", end="", file=sys.stderr, flush=True)


def run_all(mutants, jobs, rows):
    """Appends a row per mutant; raises TableError or BuildError where the table or the unchanged sources are at fault."""
    faults = []
    with tempfile.TemporaryDirectory(prefix="axial-mutants-", ignore_cleanup_errors=True) as folder:
        run = Run(pathlib.Path(folder), jobs)
        run.compile_unchanged(mutants)
        failures = run.unchanged_failures(mutants)
        faults += [f"{test}: {failure}" for test, failure in sorted(failures.items())]
        sound = [mutant for mutant in mutants if mutant.test not in failures]
        for mutant, (killer, fault) in run.each(run.killed_by, sound):
            progress("")
            rows.append({"mutant": mutant.name, "file": mutant.file, "killed_by": killer})
            faults += [f"{mutant.name}: {fault}"] if fault else []
            print(f"{len(rows):3} of {len(mutants)}  {mutant.name:44} {killer or fault or 'SURVIVED: ' + mutant.breaks}", flush=True)
    if faults:
        raise table.TableError("\n".join(faults))


def summary(rows):
    """Killed of tried, per table."""
    killed = collections.Counter(row["mutant"].split(".")[0] for row in rows if row["killed_by"])
    tried = collections.Counter(row["mutant"].split(".")[0] for row in rows)
    print()
    for name, count in tried.items():
        print(f"{name:16} {killed[name]:3} of {count} killed")
    print(f"{'all':16} {sum(killed.values()):3} of {len(rows)} killed")


def record(rows):
    known = known_killers()
    known.update({row["mutant"]: row["killed_by"] for row in rows if row["killed_by"]})
    names = {mutant.name for mutant in table.read()}
    KILLERS.write_text(json.dumps({name: killer for name, killer in sorted(known.items()) if name in names}, indent=0) + "\n")


def draw(options):
    """Ends with status 0 whatever survives: whether a change means something, a person says."""
    seed = commit_number() if options.seed is None else options.seed
    mutants = [mutant for mutant in drawn.draw(options.draw, seed) if re.search(options.only or "", mutant.breaks)]
    if options.list:
        print(*(f"{mutant.name:10} {mutant.breaks}" for mutant in mutants), sep="\n")
        return 0
    verdicts = drawn_run.Verdicts(drawn_run.FOLDER / f"drawn-{seed}.json")
    rows = drawn_run.run(mutants, options.jobs, table.read(), known_killers(), verdicts, options.again, options.seconds)
    alive = [f"{row['mutant']}: {row['change']}" for row in rows if not row["killed_by"]]
    print(f"{len(rows)} judged, {len(alive)} not noticed", *alive, sep="\n")
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1) + "\n")
    return 0


def main():
    options = arguments()
    start = time.monotonic()
    rows = []
    try:
        if options.draw:
            return draw(options)
        mutants = chosen(table.read(), options)
        rows += [{"mutant": mutant.name, "file": mutant.file, "killed_by": ""} for mutant in mutants if not mutant.test]
        mutants = [mutant for mutant in mutants if mutant.test]
        stale = table.stale(mutants)
        if stale:
            raise table.TableError("\n".join(stale))
        if options.list or options.check:
            for mutant in mutants if options.list else []:
                print(f"{mutant.name:44} {mutant.file:60} {mutant.breaks}")
            print(f"{len(mutants)} mutants, each applies")
            return 0
        run_all(mutants, options.jobs, rows)
    except (table.TableError, build.BuildError) as error:
        print(f"\n{error}", file=sys.stderr)
        return 2
    rows.sort(key=lambda row: row["mutant"])
    if options.record:
        record(rows)
    summary(rows)
    print(f"{time.monotonic() - start:.0f} s")
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1) + "\n")
    if options.essence:
        survivors = [row["mutant"] for row in rows if not row["killed_by"]]
        print(f"not killed by the essence: {' '.join(survivors) or 'none'}")
        return 0 if len(survivors) <= (1 - essence.SHARE) * len(rows) else 1
    return 0 if all(row["killed_by"] for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
