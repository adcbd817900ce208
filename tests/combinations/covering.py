"""A covering array of strength 2: few rows in which every pair of values of two factors occurs that may occur."""
import itertools
import random


def pairs_of(row, factors):
    return {(f, row[f], g, row[g]) for f, g in itertools.combinations(factors, 2)}


def completed(factors, part, refused):
    """A row with these values: defaults elsewhere, or one factor off its default where they are refused beside it."""
    row = {**{f: values[0] for f, values in factors.items()}, **part}
    trials = itertools.chain([row], ({**row, f: value} for f, values in factors.items() if f not in part for value in values))
    return next((trial for trial in trials if not refused(trial)), None)


def possible_pairs(factors, refused):
    """Pairs that some row holds which is not refused, and those that none does."""
    possible, impossible = set(), set()
    for f, g in itertools.combinations(factors, 2):
        for a, b in itertools.product(factors[f], factors[g]):
            (possible if completed(factors, {f: a, g: b}, refused) else impossible).add((f, a, g, b))
    return possible, impossible


def _candidate(factors, wanted, refused, rng):
    """A row around one pair that is still wanted; values by what they add, in a random order of factors."""
    f, a, g, b = rng.choice(wanted)
    row = completed(factors, {f: a, g: b}, refused)
    open_pairs = set(wanted)
    order = [h for h in factors if h not in (f, g)]
    rng.shuffle(order)
    chosen = {f, g}
    for h in order:
        best, most = [], -1
        for value in factors[h]:
            trial = {**row, h: value}
            if refused(trial):
                continue
            gain = sum(1 for k in chosen
                       if ((k, trial[k], h, value) if list(factors).index(k) < list(factors).index(h)
                           else (h, value, k, trial[k])) in open_pairs)
            if gain > most:
                best, most = [value], gain
            elif gain == most:
                best.append(value)
        row[h] = rng.choice(best)
        chosen.add(h)
    return row


def covering_array(factors, refused, seeds=(), candidates=12, seed=1):
    """Rows, the given ones first; the same for the same arguments."""
    rng = random.Random(seed)
    possible, _ = possible_pairs(factors, refused)
    rows = [dict(row) for row in seeds]
    names = list(factors)
    for row in rows:
        possible -= pairs_of(row, names)
    while possible:
        wanted = sorted(possible)
        trials = [_candidate(factors, wanted, refused, rng) for _ in range(candidates)]
        row = max(trials, key=lambda trial: len(pairs_of(trial, names) & possible))
        rows.append(row)
        possible -= pairs_of(row, names)
    return rows
