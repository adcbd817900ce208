"""A user's robot for ./axial choose: what must be built, and its rows in the report's form.

usage: own.py targets BOARD ALGORITHM
       own.py rows BOARD ALGORITHM PROGRAM FILE     PROGRAM: errors-own_<job> of the host; FILE gets the rows
"""

import argparse
import json
import pathlib
import subprocess
import sys

import kernels

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "boards/size"))
import measure  # noqa: E402

ALONE = {"feedforward", "elastic_feedforward"}  # one of a kind: nothing to choose from


def chosen(board, algorithm):
    """Every way to compute what the algorithm computes."""
    return [probe for probe in measure.own_probes(board) if kernels.subject_of(probe.algorithm) == algorithm and algorithm not in ALONE]


def targets(options):
    found = chosen(options.board, options.algorithm)
    if not found:
        sys.exit(f"axial choose: unknown algorithm '{options.algorithm}' for a header; there are: "
                 f"{', '.join(sorted({kernels.subject_of(probe.algorithm) for probe in measure.own_probes(options.board)} - ALONE))}")
    print(*sorted({f"size-{name}" for probe in found for name in (probe.name, probe.empty)}))


def rows(options):
    found = chosen(options.board, options.algorithm)
    refusals = {probe: measure.refusal_of(options.board, probe) for probe in found}
    if all(refusals.values()):
        sys.exit(f"axial choose: {next(iter(refusals.values())).removeprefix('axial: ')}")
    errors = json.loads(subprocess.run([options.program], check=True, capture_output=True, text=True).stdout)
    sizes = [measure.Figures(options.board, probe).row() for probe in found if not refusals[probe]]
    pathlib.Path(options.file).write_text(json.dumps(kernels.joined(errors, sizes)) + "\n", encoding="utf-8")


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    subs = parser.add_subparsers(dest="action", required=True)
    for name in ("targets", "rows"):
        sub = subs.add_parser(name)
        sub.add_argument("board")
        sub.add_argument("algorithm")
    sub.add_argument("program")
    sub.add_argument("file")
    return parser.parse_args()


if __name__ == "__main__":
    asked = parse()
    {"targets": targets, "rows": rows}[asked.action](asked)
