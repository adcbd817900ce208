"""The table of mutants: tables/*.toml, read, judged, and applied to a copy of the sources."""

import dataclasses
import pathlib
import re
import tomllib
import zlib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FIELDS = {"file", "old", "new", "test", "filter", "breaks"}


class TableError(Exception):
    """The table says what cannot be: the message names the mutant."""


@dataclasses.dataclass(frozen=True)
class Mutant:
    """One change of one file, and the test that must notice it."""

    name: str
    file: str  # below the project's root
    old: str  # occurs once in the file
    new: str
    test: str  # a source below tests/
    filter: str  # GoogleTest's, empty: the whole source
    breaks: str  # what is wrong with it, in a sentence
    by_compiler: bool  # a static_assert of the test kills it: it must not compile

    def apply(self, text):
        """The file's text with the mutation."""
        found = text.count(self.old)
        if found != 1:
            raise TableError(f"{self.name}: its old text occurs {found} times in {self.file}, not once: {self.old!r}")
        return text.replace(self.old, self.new)


def read(folder=HERE / "tables", root=ROOT):
    """All mutants in the order of the tables; names are unique."""
    mutants = []
    for path in sorted(folder.glob("*.toml")):
        try:
            entries = tomllib.loads(path.read_text())
        except tomllib.TOMLDecodeError as error:
            raise TableError(f"{path}: {error}") from error
        mutants += [mutant_of(f"{path.stem}.{name}", entry, root) for name, entry in entries.items()]
    return mutants


def mutant_of(name, entry, root):
    """Judges one entry."""
    unknown = set(entry) - FIELDS - {"by_compiler"}
    missing = FIELDS - {"filter"} - set(entry)
    if unknown or missing:
        raise TableError(f"{name}: unknown {sorted(unknown)}, missing {sorted(missing)}")
    mutant = Mutant(name=name, filter=entry.get("filter", ""), by_compiler=entry.get("by_compiler", False),
                    **{field: entry[field] for field in FIELDS - {"filter"}})
    if mutant.old == mutant.new:
        raise TableError(f"{name}: changes nothing")
    for path in (mutant.file, f"tests/{mutant.test}"):
        if not (root / path).is_file():
            raise TableError(f"{name}: there is no {path}")
    return mutant


def stale(mutants, root=ROOT):
    """What is wrong with mutants that no longer apply."""
    errors = []
    for mutant in mutants:
        try:
            mutant.apply((root / mutant.file).read_text())
            expect_tests(mutant, (root / "tests" / mutant.test).read_text())
        except TableError as error:
            errors.append(str(error))
    return errors


def expect_tests(mutant, source):
    """Every suite and test that the filter names stands in the source."""
    for word in re.findall(r"\w+", mutant.filter):
        if word not in source:
            raise TableError(f"{mutant.name}: tests/{mutant.test} knows no {word}")


def part(mutants, number, count):
    """The number-th of count parts (from 1) that differ by one mutant at most. Mutants of one test keep together, for that test is compiled
    once for all of them; tests follow each other in no order, so that what is slow to compile is not all in one part."""
    together = sorted(mutants, key=lambda mutant: (zlib.crc32(mutant.test.encode()), mutant.test))
    return together[(number - 1) * len(together) // count:number * len(together) // count]
