"""Mutants from the code, not from the tests: single changes by operators, drawn over the headers, hal, apps and host_sim."""

import collections
import random
import re

import table

FOLDERS = ("firmware/include/axial", "hal", "firmware/apps", "host_sim")
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


def draw(count, seed):
    """That many different changes. Of a drawn mutant the filter is the number of its line."""
    source, all_changes, drawn = random.Random(seed), changes(), {}
    while len(drawn) < count:
        path, number, name, line, changed = source.choice(all_changes[source.choice(sorted(all_changes))])
        file = str(path.relative_to(table.ROOT))
        placed, breaks = around(path.read_text(), number, line, changed), f"{name}, {file}:{number + 1}: {changed.strip()}"
        if placed and breaks not in drawn:
            drawn[breaks] = table.Mutant(name=f"drawn.{len(drawn) + 1}", file=file, old=placed[0], new=placed[1], test="", filter=str(number), breaks=breaks,
                                         by_compiler=True)
    return list(drawn.values())
