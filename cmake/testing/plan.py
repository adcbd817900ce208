#!/usr/bin/python3
"""What ./axial test builds and runs, from two configured builds of the host (build/host-sanitize, build/host-unsanitized).

usage: plan.py choose [--deep | --filter REGEX] [--part K/N]   writes build/plan: items, boards, <half>.targets; says what was chosen
       plan.py list [--deep] [--part K/N]                      what that would be, an item per line
       plan.py numbers HALF                                    ctest's numbers of the chosen tests, once they are built
       plan.py rest                                            how many items were not chosen, and how to run them
       plan.py record                                          costs of the items that were built and run, into tests/costs.json
       plan.py passed K/N                                      writes into tests/passed.json that the part passed at this commit

An item is a program of tests (<folder>.<program>), a test that is a program of its own (ctest's name), or sources that need only compile.
tests/essence.txt says which are the essence; all others are the deep half, whose parts are of about equal cost by tests/costs.json.
"""
import argparse
import fnmatch
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD, PLAN = ROOT / "build", ROOT / "build/plan"
HALVES = {"sanitized": "host-sanitize", "unsanitized": "host-unsanitized"}
UNKNOWN = 30.0  # processor seconds of an item that no record has
TEST = re.compile(r"^(TEST|TEST_F|TEST_P|TYPED_TEST|TYPED_TEST_P)\((\w+),\s*(\w+)\)", re.MULTILINE)
PREFIX = re.compile(r"^INSTANTIATE(?:_TYPED)?_TEST_SUITE_P\((\w+),\s*(\w+)", re.MULTILINE)
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


class Item:
    """Something that is built and run whole."""

    def __init__(self, half, name, targets=(), images=(), sources=()):
        self.half, self.name, self.targets, self.images, self.sources = half, name, list(targets), list(images), list(sources)

    @property
    def key(self):
        return f"{self.half}/{self.name}"

    @property
    def board(self):
        return self.images[0].split("/")[0] if self.images else ""


def configured_tests(half):
    """Of ctest: (name, labels, processors) in order; programs that are not built yet have no tests."""
    done = subprocess.run(["ctest", "--test-dir", BUILD / HALVES[half], "--show-only=json-v1"], check=True, capture_output=True, text=True)
    for test in json.loads(done.stdout)["tests"]:
        properties = {each["name"]: each["value"] for each in test.get("properties", ())}
        yield test["name"], properties.get("LABELS", []), int(properties.get("PROCESSORS", 1))


def programs(half):
    for line in (BUILD / HALVES[half] / "test_programs.txt").read_text(encoding="utf-8").splitlines():
        folder, name, place, *sources = line.split()
        yield Item(half, f"{folder}.{name}", [name], sources=[pathlib.Path(place, source.split(":")[0]) for source in sources])


def scripts(half):
    for name, labels, _ in configured_tests(half):
        if name.endswith("_NOT_BUILT") or any("." in label and ":" not in label for label in labels):
            continue
        needs = {kind: [label.split(":", 1)[1] for label in labels if label.startswith(kind + ":")] for kind in ("target", "image")}
        yield Item(half, name, needs["target"], needs["image"])


def items():
    return [item for half in HALVES for item in [*programs(half), *scripts(half)]]


def read_json(path):
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def costs():
    return read_json(ROOT / "tests/costs.json")


def cost(item, known):
    return sum(known.get(item.key, (UNKNOWN,)))


def essence_patterns():
    lines = (line.split("#")[0].strip() for line in (ROOT / "tests/essence.txt").read_text(encoding="utf-8").splitlines())
    return [line for line in lines if line]


def is_essential(item, patterns):
    return any(fnmatch.fnmatchcase(item.key if "/" in pattern else item.name, pattern) for pattern in patterns)


def parts_of(chosen, count):
    """Neighbours stay together, for they share what they need: (board, half, name) in order, cut where an equal share of the cost is full."""
    known = costs()
    order = sorted(chosen, key=lambda item: (item.half, item.board, item.name))
    whole, before = sum(cost(item, known) for item in order), 0.0
    parts = [[] for _ in range(count)]
    for item in order:
        own = cost(item, known)
        parts[min(count - 1, int((before + own / 2) * count / whole))].append(item)
        before += own
    return parts


def names_in(source, seen):
    """(kind, suite, test) of a source and of the headers beside it."""
    if source in seen or not source.exists():
        return [], []
    seen.add(source)
    text = source.read_text(encoding="utf-8", errors="replace")
    tests, prefixes = TEST.findall(text), PREFIX.findall(text)
    for name in INCLUDE.findall(text):
        more = names_in((source.parent / name).resolve(), seen)
        tests, prefixes = tests + more[0], prefixes + more[1]
    return tests, prefixes


def test_names(item):
    """What ctest will call the program's tests: of those with a type or a parameter the beginning, before < or the last /."""
    folder, seen = item.name.split(".")[0], set()
    for source in item.sources:
        tests, prefixes = names_in(source.resolve(), seen)
        for kind, suite, test in tests:
            before = [prefix for prefix, of in prefixes if of == suite]
            suites = {"TEST_P": [f"{prefix}/{suite}" for prefix in before], "TYPED_TEST_P": before}.get(kind, [suite])
            yield from (f"{folder}.{name}.{test}" for name in suites)


def matching(every, pattern):
    """Items that hold a test of that name, each in the half that costs less."""
    known, found = costs(), {}
    patterns = {pattern, re.sub(r"<.*|/[^/.]*$", "", pattern) or pattern}  # the second without a type or a parameter, which sources do not tell
    for item in every:
        if any(re.search(each, name) for each in patterns for name in (test_names(item) if item.sources else [item.name])):
            best = found.get(item.name)
            if best is None or cost(item, known) < cost(best, known):
                found[item.name] = item
    return list(found.values())


def selection(options):
    every = items()
    if options.filter:
        return matching(every, options.filter)
    patterns = essence_patterns()
    if not options.deep:
        return [item for item in every if is_essential(item, patterns)]
    deep = [item for item in every if not is_essential(item, patterns)]
    return parts_of(deep, options.part[1])[options.part[0] - 1] if options.part else deep


def write_plan(chosen, options):
    PLAN.mkdir(parents=True, exist_ok=True)
    for old in PLAN.iterdir():
        old.unlink()
    (PLAN / "items").write_text("".join(item.key + "\n" for item in chosen), encoding="utf-8")
    (PLAN / "filter").write_text(options.filter or "", encoding="utf-8")
    for half in HALVES:
        targets = sorted({target for item in chosen if item.half == half for target in item.targets})
        (PLAN / f"{half}.targets").write_text("".join(target + "\n" for target in targets), encoding="utf-8")
    images = sorted({image for item in chosen for image in item.images})
    for board in sorted({image.split("/")[0] for image in images}):
        own = [image.split("/")[1] for image in images if image.startswith(board + "/")]
        (PLAN / f"{board}.images").write_text("".join(image + "\n" for image in ["all"] * (board in images) + own), encoding="utf-8")


def describe(chosen):
    known = costs()
    boards = sorted({item.board for item in chosen if item.board})
    return (f"{len(chosen)} items: {sum(bool(item.sources) for item in chosen)} programs of tests, {sum(not item.sources for item in chosen)} others; "
            f"boards: {' '.join(boards) or 'none'}; about {sum(cost(item, known) for item in chosen):.0f} s of a processor")


def say_list(chosen):
    known = costs()
    for item in chosen:
        print(f"{cost(item, known):7.0f} s  {item.key}")


def chosen_items():
    keys = set((PLAN / "items").read_text(encoding="utf-8").split("\n"))
    return [item for item in items() if item.key in keys]


def numbers(half):
    """For ctest -I: only numbers count, so that begin, end and stride are past all tests."""
    chosen = {item.name for item in chosen_items() if item.half == half}
    pattern = (PLAN / "filter").read_text(encoding="utf-8")
    tests = list(configured_tests(half))
    found = [number for number, (name, labels, _) in enumerate(tests, 1)
             if (name in chosen or chosen & set(labels)) and re.search(pattern, name)]
    return f"{len(tests) + 1},{len(tests) + 1},1," + ",".join(map(str, found)) if found else ""


def object_costs(half):
    """{target: processor seconds}, the last record of each object."""
    last = {}
    for line in (BUILD / HALVES[half] / "compile_costs.txt").read_text(encoding="utf-8").splitlines():
        seconds, _, name = line.split()
        last[name] = float(seconds)
    found = {}
    for name, seconds in last.items():
        target = re.search(r"CMakeFiles/([^/]+)\.dir/", name)
        if target:
            found[target[1]] = found.get(target[1], 0.0) + seconds
    return found


def run_costs(half):
    """{item's name or test's name: seconds of as many processors as it takes}."""
    known = {name: (labels, processors) for name, labels, processors in configured_tests(half)}
    found = {}
    path = BUILD / HALVES[half] / "results.xml"
    for case in ElementTree.parse(path).getroot().iter("testcase") if path.exists() else ():
        labels, processors = known.get(case.get("name"), ((), 1))
        owner = next((label for label in labels if "." in label and ":" not in label), case.get("name"))
        found[owner] = found.get(owner, 0.0) + float(case.get("time")) * processors
    return found


def record():
    known = costs()
    for half in HALVES:
        compiled, run = object_costs(half), run_costs(half)
        for item in items():
            if item.half == half and (item.name in run or (item.sources and item.targets[0] in compiled)):
                built = sum(compiled.get(target, 0.0) for target in item.targets)
                known[item.key] = [round(built, 1), round(run.get(item.name, known.get(item.key, [0, 0])[1]), 1)]
    present = {item.key for item in items()}
    rows = ",\n".join(f"  {json.dumps(key)}: {json.dumps(value)}" for key, value in sorted(known.items()) if key in present)
    (ROOT / "tests/costs.json").write_text("{\n" + rows + "\n}\n", encoding="utf-8")


def passed(number, count):
    path = ROOT / "tests/passed.json"
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], check=True, capture_output=True, text=True).stdout.strip()
    known = read_json(path)
    parts = known.get("parts", {}) if known.get("of") == count else {}
    parts[str(number)] = commit
    path.write_text(json.dumps({"of": count, "parts": dict(sorted(parts.items(), key=lambda each: int(each[0])))}, indent=1) + "\n", encoding="utf-8")


def rest():
    every, chosen = items(), set((PLAN / "items").read_text(encoding="utf-8").split("\n"))
    left = [item for item in every if item.key not in chosen]
    return f"{len(left)} of {len(every)} items, of {', '.join(sorted({item.name.split('.')[0] for item in left}))}"


def part(text):
    number, count = map(int, text.split("/"))
    if not 1 <= number <= count:
        raise argparse.ArgumentTypeError("K/N with 1 <= K <= N")
    return number, count


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("command", choices=("choose", "list", "numbers", "rest", "record", "passed"))
    parser.add_argument("argument", nargs="?")
    parser.add_argument("--deep", action="store_true")
    parser.add_argument("--part", type=part)
    parser.add_argument("--filter")
    options = parser.parse_args()
    try:
        re.compile(options.filter or "")
    except re.error as error:
        print(f"axial: --filter is '{options.filter}': {error}", file=sys.stderr)
        return 2
    if options.command == "choose":
        chosen = selection(options)
        write_plan(chosen, options)
        print(describe(chosen))
        return 0 if chosen else 3
    if options.command == "list":
        say_list(selection(options))
    elif options.command == "numbers":
        print(numbers(options.argument))
    elif options.command == "rest":
        print(rest())
    elif options.command == "record":
        record()
    else:
        passed(*part(options.argument))
    return 0


if __name__ == "__main__":
    sys.exit(main())
