"""Writes the tables of doc/measurements/number_systems.md, as tables.py does with the others.

usage: number_system_tables.py DATA_FOLDER PROMISED.json DOCUMENT.md
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "plot"))
from number_systems import NAMES  # noqa: E402
from tables import fill, grouped, load, markdown, span, unique  # noqa: E402


def kernel(row):
    return f"{row['robot']}, {row['algorithm'].replace('_', ' ')}, {NAMES[row['scalar']]}"


def by_kernel(rows):
    """{(robot, algorithm, scalar): {board: row}}, in the order of the rows."""
    found = {}
    for row in rows:
        found.setdefault((row["robot"], row["algorithm"], row["scalar"]), {})[row["board"]] = row
    return found


def errors(rows):
    header = ["kernel, numbers", "largest error", "RMS error", "certified", "float's error over it"]
    floats = {key[:2]: next(iter(boards.values()))["error"] for key, boards in by_kernel(rows).items() if key[2] == "float"}
    lines = []
    for key, boards in by_kernel(rows).items():
        row = next(iter(boards.values()))
        certified = f"{row['error_certified']:.1e}" if "error_certified" in row else ""
        lines.append([kernel(row), f"{row['error']:.1e}", f"{row['error_rms']:.1e}", certified,
                      times(floats[key[:2]] / row["error"]) if row["scalar"] not in ("float", "double") else ""])
    return markdown(header, lines)


def times(ratio):
    return f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.2g}"


def per_board(rows, cell):
    boards = unique(row["board"] for row in rows)
    lines = [[kernel(next(iter(found.values())))] + [cell(found[board]) if board in found else "" for board in boards]
             for found in by_kernel(rows).values()]
    return markdown(["kernel, numbers"] + boards, lines)


def instructions(rows):
    return per_board(rows, lambda row: span(row.get("instructions_min", row["instructions"]), row["instructions"]))


def bytes_of(rows):
    return per_board(rows, lambda row: f"{grouped(row['flash_bytes'])} + {grouped(row['stack_bytes'])}")


def promises(rows, promised):
    found = by_kernel(rows)
    header = ["board, kernel, numbers", "promised at most", "measured"]
    lines = []
    for each in promised:
        measured = found[each["robot"], each["algorithm"], each["scalar"]][each["board"]]["instructions"]
        lines.append([f"{each['board']}, {kernel(each)}", grouped(each["instructions"]), grouped(measured)])
    return markdown(header, lines)


def provenance(made):
    flags = "".join(f"- `{board}`: `{flags}`\n" for board, flags in made["flags"].items())
    return (f"Measured in QEMU at commit `{made['commit']}` with {made['compiler']}:\n\n{flags}\n"
            f"Errors on the host: {made['host_compiler']}, `{made['host_flags'].strip()}`.\n")


def main(folder, promised_file, document):
    folder = pathlib.Path(folder)
    rows, made = load(folder / "number_systems.json"), load(folder / "number_systems_provenance.json")
    tables = {"number_errors": errors(rows), "number_instructions": instructions(rows), "number_bytes": bytes_of(rows),
              "number_promises": promises(rows, load(pathlib.Path(promised_file))), "number_provenance": provenance(made)}
    fill(document, tables.__getitem__)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
