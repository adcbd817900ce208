"""Writes the tables of compile costs into a document, as tables.py does with the others.

usage: compile_cost_tables.py DATA_FOLDER DOCUMENT.md

DATA_FOLDER holds compile_cost.json and compile_cost_provenance.json.
"""

from tables import command, load, markdown, unique


class Data:
    def __init__(self, folder):
        self.rows = load(folder / "compile_cost.json")
        self.provenance = load(folder / "compile_cost_provenance.json")


def of_build(build):
    """Seconds and MiB of every number, a row per robot and kernel; what only includes is the same for all numbers."""
    def table(data):
        found = {(row["robot"], row["kernel"], row["number"]): row for row in data.rows if row["build"] == build}
        numbers = unique(row["number"] for row in data.rows)
        header = [f"{build}, robot, kernel"] + [f"{number}, {unit}" for unit in ("s", "MiB") for number in numbers]
        rows = []
        for robot, kernel in unique((robot, kernel) for robot, kernel, _ in found):
            each = [found.get((robot, kernel, number)) for number in numbers]
            rows.append([f"{robot}, {kernel.replace('_', ' ')}"] + [f"{row['seconds']:.2f}" if row else "" for row in each] +
                        [str(row["memory_MiB"]) if row else "" for row in each])
        return markdown(header, rows)
    return table


def provenance(data):
    made = data.provenance
    lines = [f"- `{build}`: {entry['compiler']}; `{entry['flags']}`\n" for build, entry in made["builds"].items()]
    runs = min(row["runs"] for row in data.rows)
    least = f"the least of {runs} runs" if runs > 1 else "one run of each"
    return (f"Measured at commit `{made['commit']}` on {made['processors']} x {made['processor']}, {least}; "
            f"the machine's mean load over the last quarter of an hour was {made['load']} at the end:\n\n" + "".join(lines))


TABLES = {f"compile_cost_{build.replace('-', '_')}": of_build(build)
          for build in ("cortex_m4f-O2", "cortex_m4f-O0", "host-gcc-O2", "host-clang-O2")}
TABLES["compile_cost_provenance"] = provenance

if __name__ == "__main__":
    command(__doc__, TABLES, Data)
