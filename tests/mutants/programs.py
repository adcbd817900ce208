"""What each test source is compiled and linked with: programs.toml where it says, else what CMake does for the program that has it."""

import collections
import functools
import json
import pathlib
import re
import subprocess

import build

TESTS = build.ROOT / "tests"
TEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\(\w+,\s*(\w+)\)", re.MULTILINE)
LONG = 2.0  # s that a program runs: it is optimised a little
OWN_LIBRARIES = ("-lgtest", "/libgtest", "libgtest_main")  # every program of mutants is linked to them


class CMakePrograms(build.Programs):
    """As build.Programs, for every test source; configured once in a folder, from which nothing is built."""

    def __init__(self, folder):
        super().__init__()
        query = folder / ".cmake/api/v1/query"
        query.mkdir(parents=True, exist_ok=True)
        (query / "codemodel-v2").touch()
        subprocess.run(["cmake", "-S", str(build.ROOT), "-B", str(folder), "-G", "Ninja", "-DAXIAL_DEVELOPER=ON", "-DAXIAL_TESTS=all", "-DAXIAL_BATCHES=OFF"], check=True,
                       stdout=subprocess.DEVNULL)
        found = [json.loads(path.read_text()) for path in sorted((folder / ".cmake/api/v1/reply").glob("target-*.json"))]
        self.targets = {target["name"]: target for target in found}
        self.archives = {pathlib.Path(made["path"]).name: target for target in found if "LIBRARY" in target["type"] for made in target.get("artifacts", [])}
        costs = json.loads((TESTS / "costs.json").read_text())
        self.run_seconds = {name.split(".")[-1]: seconds for name, (_, seconds) in sorted(costs.items())}
        self.owners, self.parts = {}, collections.Counter()
        for line in (folder / "test_programs.txt").read_text().splitlines():
            _, program, place, *sources = line.split()
            for source in sources:
                path = pathlib.Path(place) / source.split(":")[0]
                if path.is_relative_to(TESTS) and is_test(str(path.relative_to(build.ROOT))):
                    self.owners.setdefault(str(path.relative_to(TESTS)), program)
                    self.parts[str(path.relative_to(TESTS))] += 1

    def of(self, test):
        if test in self.tests or test not in self.owners:
            return super().of(test)
        return self.by_cmake(test)

    @functools.lru_cache(maxsize=None)
    def by_cmake(self, test):
        """Of the program's own sources those that hold no other tests; of its libraries the sources and the libraries that are not ours."""
        program = self.targets[self.owners[test]]
        own = [(source, flags) for source, flags in sources_of(program) if not is_test(source)]
        flags = next((flags for source, flags in sources_of(program) if is_test(source)), [])
        sources, link = [(f"tests/{test}", few_robots(test, flags)), *own], []
        for part in program["link"]["commandFragments"]:
            name = pathlib.Path(part["fragment"]).name
            if name in self.archives:
                sources += [each for each in sources_of(self.archives[name]) if each not in sources]
            elif part["role"] == "libraries" and not any(known in part["fragment"] for known in OWN_LIBRARIES):
                link.append(part["fragment"])
        slow = ["-O1"] if self.run_seconds.get(self.owners[test], 0.0) > LONG else []
        return [(source, [*flags, *slow]) for source, flags in sources], link


def is_test(source):
    return "/parts/" in source or (source.startswith("tests/") and bool(TEST.search((build.ROOT / source).read_text())))


def few_robots(test, flags):
    """As under sanitizers, where a source knows fewer robots."""
    knows = "AXIAL_FEW_ROBOTS" in (build.ROOT / "tests" / test).read_text()
    return [*flags, "-DAXIAL_FEW_ROBOTS=1"] if knows and not any("FEW_ROBOTS" in flag for flag in flags) else flags


def sources_of(target):
    """(source below the root, what it is defined and what it includes) of what a target compiles."""
    found = []
    for group in target.get("compileGroups", []):
        flags = [f"-D{each['define']}" for each in group.get("defines", [])]
        for each in group.get("includes", []):
            path = pathlib.Path(each["path"])
            place = str(path.relative_to(build.ROOT)) or "." if path.is_relative_to(build.ROOT) else str(path)
            flags.append(("-isystem" if each.get("isSystem") else "-I") + place)
        found += [(target["sources"][index]["path"], flags) for index in group["sourceIndexes"] if not target["sources"][index]["path"].endswith("cmake_pch.hxx.cxx")]
    return found
