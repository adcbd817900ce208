"""Wait states of a flash behind a small cache of lines, at their worst: nothing fetched ahead, an empty cache at the start."""

import collections


def waits(flash, run):
    """`flash`: of board.json, wait_states, line_bytes and lines of a cache on the chip; or miss_cycles, line_bytes, sets, ways and range of one
    in front of a serial flash. `run`: executed addresses and, for the latter, all words fetched or read."""
    return serial_waits(flash, run.accesses) if "sets" in flash else parallel_waits(flash, run.executed)


def parallel_waits(flash, executed):
    cache, misses = collections.OrderedDict(), 0
    previous = None
    for address in executed:
        line = address // flash["line_bytes"]
        if line == previous:
            continue
        previous = line
        if line not in cache:
            misses += 1
            if len(cache) == flash["lines"]:
                cache.popitem(last=False)
        cache[line] = True
        cache.move_to_end(line)
    return misses * flash["wait_states"]


class Set:
    """Lines that are there for certain, whichever a cache throws out: all while they have room, then the last one alone."""

    def __init__(self):
        self.met, self.there = set(), set()

    def misses(self, line, ways):
        if line in self.there:
            return False
        self.met.add(line)
        self.there = self.there | {line} if len(self.met) <= ways else {line}
        return True


def serial_waits(flash, accesses):
    """RAM, outside the range, has none."""
    begin, end = (int(text, 16) for text in flash["range"])
    sets, misses = collections.defaultdict(Set), 0
    for line in (address // flash["line_bytes"] for address in accesses if begin <= address < end):
        misses += sets[line % flash["sets"]].misses(line, flash["ways"])
    return misses * flash["miss_cycles"]
