#!/usr/bin/python3
"""The tables of doc/measurements/test_cost.md, from tests/costs.json and from what the builds here wrote down of their compilers
(doc/data/test_cost.json). usage: compile_table.py [--from-data]: with it the builds are not read again."""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, DATA = ROOT / "doc/measurements/test_cost.md", ROOT / "doc/data/test_cost.json"
BUILDS = ("host-sanitize", "host-unsanitized")
ROWS = 40


def sources(build):
    """Rows of what a build's compilers cost, the last time for each object."""
    path = ROOT / "build" / build / "compile_costs.txt"
    lines = (line.split(" ", 2) for line in path.read_text(encoding="utf-8").splitlines()) if path.exists() else ()
    last = {name: (float(seconds), int(megabytes)) for seconds, megabytes, name in lines if (path.parent / name).exists()}
    for name, (seconds, megabytes) in last.items():
        yield {"build": build, "source": re.sub(r"CMakeFiles/[^/]+\.dir/|\.o$", "", name), "seconds": seconds, "megabytes": megabytes}


def anew():
    """What was not built here keeps its row."""
    known = {(row["build"], row["source"]): row for row in (json.loads(DATA.read_text(encoding="utf-8"))["sources"] if DATA.exists() else ())}
    known.update({(row["build"], row["source"]): row for build in BUILDS for row in sources(build)})
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], check=True, capture_output=True, text=True).stdout.strip()
    rows = sorted(known.values(), key=lambda row: (-row["seconds"], row["build"], row["source"]))
    text = ",\n".join("  " + json.dumps(row) for row in rows)
    DATA.write_text(f'{{"commit": "{commit}", "sources": [\n{text}\n]}}\n', encoding="utf-8")


def table_of_sources(rows):
    yield from ("| source | build | s | MiB |", "| --- | --- | ---: | ---: |")
    for row in rows[:ROWS]:
        yield f"| `{row['source']}` | {row['build']} | {row['seconds']:.1f} | {row['megabytes']} |"


def table_of_sums(rows):
    yield from ("| build | sources | s | largest s | largest MiB |", "| --- | ---: | ---: | ---: | ---: |")
    for build in BUILDS:
        own = [row for row in rows if row["build"] == build]
        yield f"| {build} | {len(own)} | {sum(row['seconds'] for row in own):.0f} | {max(row['seconds'] for row in own):.1f} | {max(row['megabytes'] for row in own)} |"


def table_of_items(costs):
    yield from ("| program or test | compiling, s | running, s |", "| --- | ---: | ---: |")
    for name, (built, run) in sorted(costs.items(), key=lambda each: -sum(each[1]))[:ROWS]:
        yield f"| `{name}` | {built:.0f} | {run:.0f} |"


def main(arguments):
    if "--from-data" not in arguments:
        anew()
    data = json.loads(DATA.read_text(encoding="utf-8"))
    costs = json.loads((ROOT / "tests/costs.json").read_text(encoding="utf-8"))
    tables = {"test_cost_sums": [f"Measured at commit `{data['commit']}`.", "", *table_of_sums(data["sources"])],
              "test_cost_sources": table_of_sources(data["sources"]), "test_cost_items": table_of_items(costs)}
    page = PAGE.read_text(encoding="utf-8")
    for name, lines in tables.items():
        page = re.sub(rf"(<!-- table {name} -->\n).*?(<!-- end -->)", lambda found: found[1] + "\n".join(lines) + "\n" + found[2], page, flags=re.DOTALL)
    PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
