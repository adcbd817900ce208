"""Mutants from the code, not from the tests: single changes by operators, drawn over the headers, hal, apps and host_sim."""

import collections
import pathlib
import random
import re

import table

FOLDERS = ("firmware/include/axial", "hal", "firmware/apps", "host_sim")
TESTS_OF_ONE = 4  # that a drawn mutant is tried against, one after the other
# (name, pattern of what stands there, what stands there instead)
OPERATORS = (
    ("comparison turned", r" (<|>|<=|>=) ", lambda m: {"<": " > ", ">": " < ", "<=": " >= ", ">=": " <= "}[m[1]]),
    ("comparison with its end", r" (<|>|<=|>=) ", lambda m: {"<": " <= ", ">": " >= ", "<=": " < ", ">=": " > "}[m[1]]),
    ("equality turned", r" (==|!=) ", lambda m: " != " if m[1] == "==" else " == "),
    ("sign turned", r" ([+-]) (?=[\w(])", lambda m: " - " if m[1] == "+" else " + "),
    ("term dropped", r" [+-] [\w.]+(?=[;,)])", lambda m: ""),
    ("factor dropped", r" \* [\w.]+(?=[;,)])", lambda m: ""),
    ("constant doubled", r"(?<![\w.])(\d+\.\d+(?:e-?\d+)?)(?![\w.])", lambda m: repr(2.0 * float(m[1]) or 1.0)),
    ("check removed", r"(?<=\bif )\((?!constexpr)(?=.*\) (?:return|continue|break)\b)", lambda m: "(false && "),
    ("minimum for maximum", r"\b(smaller|larger|fmin|fmax|min|max)\(", lambda m: {"smaller": "larger", "larger": "smaller", "fmin": "fmax",
                                                                               "fmax": "fmin", "min": "max", "max": "min"}[m[1]] + "("),
    ("and for or", r" (&&|\|\|) ", lambda m: " || " if m[1] == "&&" else " && "),
    ("truth turned", r"\b(true|false)\b", lambda m: "false" if m[1] == "true" else "true"),
)
NO_CODE = re.compile(r"^\s*(//|#|\*|///|static_assert|template\b|using\b|\")|AXIAL_|\boperator\b|<<|>>")


def lines_of(path):
    """(number, line) of the lines that compute something; what a macro or a sentence is made of is left out."""
    macro = False
    for number, line in enumerate(path.read_text().splitlines()):
        skipped = macro or NO_CODE.search(line) or '"' in line
        macro = line.endswith("\\")
        if not skipped and line.strip():
            yield number, line.split("  //")[0]


def changes():
    """Every change that there is: (file, line number, operator, line, changed line), by operator, so that none is drawn for being common."""
    found = collections.defaultdict(list)
    for folder in FOLDERS:
        for path in sorted((table.ROOT / folder).rglob("*.[hc]pp")):
            for number, line in lines_of(path):
                for name, pattern, instead in OPERATORS:
                    for match in re.finditer(pattern, line):
                        changed = line[:match.start()] + instead(match) + line[match.end():]
                        if changed != line:
                            found[name].append((path, number, name, line, changed))
    return found


def around(text, number, old, new):
    """The changed line with as much in front of it as makes it stand once."""
    lines = text.splitlines()
    for before in range(number + 1):
        front = "".join(each + "\n" for each in lines[number - before:number])
        if text.count(front + old) == 1:
            return front + old, front + new
    return None


def tests_for(file, mutants):
    """The unit test of that file's name; sources that kill mutants of that file, then of its folder, the commonest first."""
    folder = str(pathlib.PurePath(file).parent)
    mirror = "unit/" + file.removeprefix("firmware/include/axial/").removesuffix(".hpp") + "_test.cpp"
    own = collections.Counter(m.test for m in mutants if m.file == file)
    near = collections.Counter(m.test for m in mutants if str(pathlib.PurePath(m.file).parent) == folder)
    ranked = [mirror] * (table.ROOT / "tests" / mirror).is_file() + [test for count in (own, near) for test, _ in count.most_common() if not test.startswith("compile_fail/")]
    return list(dict.fromkeys(ranked))[:TESTS_OF_ONE]


def attempts(file, mutants, killers):
    """(test, filter) in the order of trying: the tests that killed mutants of that file, compiled alone, then whole sources."""
    tests, named = tests_for(file, mutants), collections.defaultdict(set)
    for mutant in mutants:
        killer = killers.get(mutant.name, "")
        if mutant.file == file and re.fullmatch(r"[\w/]+\.\w+", killer):
            named[mutant.test].add(killer)
    return [(test, ":".join(sorted(named[test]))) for test in tests if named[test]] + [(test, "") for test in tests]


def draw(mutants, count, seed, killers):
    """That many mutants, each as often as tests may see it: drawn.N/K is its K-th attempt; all first ones first."""
    source, all_changes = random.Random(seed), changes()
    drawn = []
    while len(drawn) < count:
        path, number, name, line, changed = source.choice(all_changes[source.choice(sorted(all_changes))])
        file = str(path.relative_to(table.ROOT))
        placed, tries = around(path.read_text(), number, line, changed), attempts(file, mutants, killers)
        if placed and tries:
            drawn.append((file, *placed, tries, f"{name}, {file}:{number + 1}: {changed.strip()}"))
    made = [(k, table.Mutant(name=f"drawn.{i}/{k}", file=file, old=old, new=new, test=test, filter=tests, breaks=breaks, by_compiler=True))
            for i, (file, old, new, tries, breaks) in enumerate(drawn, 1) for k, (test, tests) in enumerate(tries, 1)]
    return [mutant for _, mutant in sorted(made, key=lambda each: each[0])]


def base(name):
    """Of which change drawn.N/K is an attempt."""
    return name.split("/")[0]


def survivors(rows, mutants):
    """What no test noticed, in words; a change that does not compile is noticed by the compiler."""
    noticed = {base(row["mutant"]) for row in rows if row["killed_by"]}
    said = {base(mutant.name): mutant.breaks for mutant in mutants}
    return [f"{name}: {breaks}" for name, breaks in said.items() if name not in noticed]
