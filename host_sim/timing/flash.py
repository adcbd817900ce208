"""Wait states of a flash behind a small cache of lines, at their worst: nothing fetched ahead, an empty cache at the start."""

import collections


def waits(flash, executed):
    """`flash`: wait_states, line_bytes and lines of board.json."""
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
