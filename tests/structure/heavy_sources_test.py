#!/usr/bin/python3
"""No source of the host's builds takes its compiler over a minute or a gigabyte; written down by cmake/testing/compile_cost.py while they are built.

usage: heavy_sources_test.py BUILD...     a build's folder has compile_costs.txt: processor seconds, megabytes, object, a line per compilation
A minute is meant of this project's measurements; a slower or a busy machine has twice as long. Megabytes have no such allowance.
"""
import pathlib
import sys

SECONDS, ALLOWANCE, MEGABYTES = 60.0, 2.0, 1024


def last_costs(build):
    """{object: (seconds, megabytes)} of what stands there still."""
    lines = (line.split(" ", 2) for line in (build / "compile_costs.txt").read_text(encoding="utf-8").splitlines())
    return {name: (float(seconds), int(megabytes)) for seconds, megabytes, name in lines
            if (build / name).exists()}


def heavy(build):
    for name, (seconds, megabytes) in sorted(last_costs(build).items()):
        if seconds > SECONDS * ALLOWANCE or megabytes > MEGABYTES:
            yield f"{build.name}/{name}: {seconds:.0f} s, {megabytes} MiB; at most {SECONDS:.0f} s (here {ALLOWANCE:g} times that) and {MEGABYTES} MiB: " \
                  "SPLIT its tests (cmake/AxialTest.cmake), or give robots sources of their own"


def main(builds):
    written = [build for build in map(pathlib.Path, builds) if (build / "compile_costs.txt").exists()]
    found = [line for build in written for line in heavy(build)]
    print(*found, sep="\n")
    print(f"{sum(len(last_costs(build)) for build in written)} objects looked at")
    return 1 if found or not written else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
