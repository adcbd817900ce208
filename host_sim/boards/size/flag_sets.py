"""Sets of compiler flags: the lines of flags.txt, and what each makes of a board's own flags."""

import re
from typing import NamedTuple

CHANGE = re.compile(r"^!?-\S")


class Invalid(Exception):
    pass


class FlagSet(NamedTuple):
    name: str
    changes: tuple

    def apply(self, flags):
        """The flags with the changes made."""
        added = [change for change in self.changes if not change.startswith("!")]
        removed = [change[1:] for change in self.changes if change.startswith("!")]
        absent = [flag for flag in removed if flag not in flags]
        if absent:
            raise Invalid(f"'{self.name}' takes away {' '.join(absent)}, which is not among {' '.join(flags)}")
        return [flag for flag in flags if flag not in removed] + added


def parse(text):
    sets = []
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            try:
                sets.append(_parse_line(line.split(), [other.name for other in sets]))
            except Invalid as error:
                raise Invalid(f"line {number}: {error}") from None
    if not sets or sets[0].changes:
        raise Invalid("the first set must change nothing: the others are compared with it")
    return sets


def _parse_line(words, names):
    first = next((i for i, word in enumerate(words) if CHANGE.match(word)), len(words))
    name, changes = " ".join(words[:first]), words[first:]
    strange = [word for word in changes if not CHANGE.match(word)]
    if strange:
        raise Invalid(f"'{strange[0]}' is not a flag")
    if not name:
        raise Invalid("a set without a name")
    if name in names:
        raise Invalid(f"a second '{name}'")
    return FlagSet(name, tuple(changes))
