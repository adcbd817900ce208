"""Writes the tables of doc/measurements/builds.md.

usage: any_build_tables.py DATA_FOLDER DOCUMENT.md
"""

import tables

ORDER = ("-O0", "-Og", "-O1", "-Os", "-O2", "-O3", "as our boards")


class Data:
    def __init__(self, folder):
        self.rows = tables.load(folder / "any_build.json")
        self.provenance = tables.load(folder / "any_build_provenance.json")


def name_of(row):
    return f"{'GCC' if row['compiler'] == 'gcc' else 'Clang'} {row['flags']}" + (", `AXIAL_USER_OPTIONS`" if row["user_options"] else "")


def shown(row, field):
    """Nothing where it was not measured."""
    if not row:
        return ""
    return "fault" if row[field] is None else tables.grouped(row[field])


def builds(data):
    """A line per build; instructions, largest frame and flash of each kernel."""
    kernels = tables.unique((row["board"], row["algorithm"], row["scalar"]) for row in data.rows)
    header = ["build"]
    for board, algorithm, scalar in kernels:
        header += [f"{board}, {scalar} {algorithm.replace('_', ' ')}: instructions", "largest frame", "flash"]
    names = tables.unique(name_of(row) for row in sorted(data.rows, key=lambda row: (row["user_options"], row["compiler"] == "clang", ORDER.index(row["flags"]))))
    found = {(name_of(row), row["board"], row["algorithm"], row["scalar"]): row for row in data.rows}
    lines = []
    for name in names:
        rows = [found.get((name, *kernel), {}) for kernel in kernels]
        lines.append([name] + [shown(row, field) for row in rows for field in ("instructions", "frame_bytes", "flash_bytes")])
    return tables.markdown(header, lines)


def provenance(data):
    flags = "".join(f"- `{board}`: `{own}`\n" for board, own in data.provenance["flags"].items())
    return f"Measured in QEMU at commit `{data.provenance['commit']}` with {data.provenance['compiler']} and {data.provenance['clang']}; our boards' own flags:\n\n{flags}"


if __name__ == "__main__":
    tables.command(__doc__, {"builds": builds, "provenance": provenance}, Data)
