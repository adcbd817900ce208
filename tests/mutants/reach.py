"""Which tests may notice a change: those whose program reads the file, the likeliest and lightest first."""

import collections
import functools
import json
import math
import pathlib
import re

import table
import trim

COSTS = table.ROOT / "doc/data/test_cost.json"
ANY = 2.0  # s that a test costs whatever is in it
ONCE = 0.3  # of what is compiled once for many mutants
UNKNOWN = 2.0  # s to compile a source without a cost
FOCUSED = 6  # sources of which tests that name something of the file are tried alone
RARE = 2.0  # of a name: one test source of seven has it
NEAR = 8  # lines around a change whose words count more
SEARCHED = ("firmware/include", ".", "tests", "host_sim")
INCLUDE = re.compile(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]', re.MULTILINE)
DECLARED = re.compile(r"\b(?:struct|class)\s+(\w{4,})|^.*\bconstexpr\b[^=(]*?(\w{4,})(?: =|\(|\{)|^(?! *(?:return|if|for|else))[\w ].*? [*&]?(\w{4,})\([^;]*\{$", re.MULTILINE)
WORD = re.compile(r"\b[A-Za-z_]\w{3,}\b")


@functools.lru_cache(maxsize=None)
def text_of(file):
    return (table.ROOT / file).read_text()


@functools.lru_cache(maxsize=None)
def words_of(file):
    return frozenset(WORD.findall(text_of(file)))


@functools.lru_cache(maxsize=None)
def words_of_test(test):
    """Of a test source and of the headers beside it."""
    return frozenset().union(*(words_of(file) for file in read_by(f"tests/{test}") if file == f"tests/{test}" or re.match("tests/(?!oracle)", file)))


def stems_of(path):
    """How the words of a file's name begin."""
    return {word[:5] for word in pathlib.PurePath(path).stem.removesuffix("_test").split("_")}


@functools.lru_cache(maxsize=None)
def declared_in(file):
    """Names of types, functions and constants of a file, more or less."""
    return frozenset(name for names in DECLARED.findall(text_of(file)) for name in names if name)


@functools.lru_cache(maxsize=None)
def includes_of(file):
    """Files of the project that a file names."""
    places = (str(pathlib.PurePath(file).parent), *SEARCHED)
    named = [[pathlib.PurePath(place, name) for place in places] for name in INCLUDE.findall(text_of(file))]
    return [str(found) for found in (next((each for each in tried if (table.ROOT / each).is_file()), None) for tried in named) if found]


@functools.lru_cache(maxsize=None)
def read_by(source):
    """A source and all files that it reads, whatever is defined."""
    seen, waiting = {source}, [source]
    while waiting:
        new = [file for file in includes_of(waiting.pop()) if file not in seen]
        seen.update(new), waiting.extend(new)
    return seen


def is_read_by(programs, test, file):
    """Whether the program of a test source is made of a file."""
    return any(file in read_by(source) for source, _ in programs.of(test)[0] if source.endswith(".cpp"))


def blocks_of(text):
    """(kind, suite, name, text) of the tests of a source."""
    return [(*block.groups()[:3], block[0]) for block in trim.BLOCK.finditer(text)]


class Reach:
    """The tests of all programs and what each costs."""

    def __init__(self, programs, mutants, killers):
        self.programs, self.mutants, self.killers = programs, mutants, killers
        # By the file's name: folders move.
        self.costs = collections.defaultdict(float)
        for row in json.loads(COSTS.read_text())["sources"]:
            self.costs[re.sub(r"_\d+\.", ".", pathlib.PurePath(row["source"]).name)] += row["seconds"]
        self.tests = sorted(test for test in {*programs.owners, *programs.tests} if (table.ROOT / "tests" / test).is_file())
        counted = collections.Counter(word for test in self.tests for word in words_of_test(test))
        self.rarity = {word: math.log(len(self.tests) / count) for word, count in counted.items()}
        stems = collections.Counter(stem for test in self.tests for stem in stems_of(test))
        self.stem_rarity = {stem: math.log(len(self.tests) / count) for stem, count in stems.items()}

    def attempts(self, file, number):
        """(test, filter) in the order of trying: what killed mutants of that file; what expects a refusal there; tests that name something of it; whole sources."""
        own = [mutant for mutant in self.mutants if mutant.file == file]
        refusals = list(dict.fromkeys((mutant.test, "") for mutant in own if mutant.test.startswith("compile_fail/")))
        known = self.recorded_of(file)
        far = sorted((test for test in self.tests if is_read_by(self.programs, test, file)), key=lambda test: -self.likeliness(test, file, number))
        focused = [(test, tests) for test in far for tests in [self.naming(test, file)] if tests]
        whole = [(test, part) for test in far for part in self.parts_of(test)]
        return list(dict.fromkeys([*known, *refusals, *focused[:FOCUSED], *whole]))

    def naming(self, test, file):
        """The filter of a source's tests that name what the file declares, where that is rare."""
        rare = {name for name in declared_in(file) if self.rarity.get(name, 0.0) > RARE}
        blocks = [(kind, suite, name) for kind, suite, name, text in blocks_of(text_of(f"tests/{test}")) if rare & set(WORD.findall(text))]
        return ":".join(f"{suite}{'/*' if kind == 'TYPED_TEST' else ''}.{name}" for kind, suite, name in blocks)

    def recorded_of(self, file):
        """(test, filter) of what killed mutants of that file."""
        named = collections.defaultdict(set)
        for mutant in self.mutants:
            if mutant.file == file and re.fullmatch(r"[\w/]+\.\w+", self.killers.get(mutant.name, "")):
                named[mutant.test].add(self.killers[mutant.name])
        return [(test, ":".join(sorted(tests))) for test, tests in sorted(named.items(), key=lambda each: -len(each[1]))]

    def recorded(self):
        return {each for file in {mutant.file for mutant in self.mutants} for each in self.recorded_of(file)}

    def seconds(self, test, file, tests=""):
        """To compile what reads the file, by what it cost once: the same on any machine, whoever else works there."""
        all_blocks = [name for kind, suite, block, _ in blocks_of(text_of(f"tests/{test}")) for name in trim.names(kind, suite, block)[:1]]
        kept = sum(trim.selects(tests, name) for name in all_blocks) if tests else len(all_blocks)
        share = (1.0 + kept) / (1.0 + len(all_blocks))
        runs = share * self.programs.run_seconds.get(self.programs.owners.get(test, ""), 0.0)
        weighed = ((share if source == f"tests/{test}" else 1.0 if file in read_by(source) else ONCE, source) for source, _ in self.programs.of(test)[0])
        return ANY + runs + sum(weight * self.costs.get(pathlib.PurePath(source).name, UNKNOWN) for weight, source in weighed if source.endswith(".cpp"))

    def likeliness(self, test, file, number):
        """Words that a test shares with the file and with the lines around the change, the rare ones first, per second of the compiler."""
        source, lines = words_of_test(test), text_of(file).splitlines()
        near = set(WORD.findall("\n".join(lines[max(0, number - NEAR):number + NEAR])))
        shared = sum(self.rarity[word] * (4.0 if word in near else 1.0) * (4.0 if word in declared_in(file) else 1.0) for word in source & words_of(file))
        recorded = sum(1 for mutant in self.mutants if mutant.test == test and mutant.file == file)
        called = sum(self.stem_rarity[stem] for stem in stems_of(test) & stems_of(file))
        return (shared / math.sqrt(len(source)) + 4.0 * recorded + 4.0 * called) / math.sqrt(self.seconds(test, file))

    def parts_of(self, test):
        """Filters of a source's tests that together select all: as many as CMake makes programs of it."""
        parts, text = self.programs.parts[test], text_of(f"tests/{test}")
        if parts < 2:
            return [""]
        names = [f"{suite}{'/*' if kind == 'TYPED_TEST' else ''}.{name}" for kind, suite, name, _ in blocks_of(text)]
        return [":".join(names[part::parts]) for part in range(parts) if names[part::parts]] if "TEST_P(" not in text else [""]
