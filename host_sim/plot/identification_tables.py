"""Writes the tables of doc/guides/identification.md, as tables.py does with the others.

usage: identification_tables.py DATA_FOLDER DOCUMENT.md
"""

from tables import command, load, markdown


def study(folder):
    """A row per robot; the exact log beside the noisy one."""
    data = load(folder / "identification.json")
    exact, noisy = ([row for row in data if row["case"] == case] for case in ("exact", "noisy"))
    header = ["robot", "base parameters of standard ones", "exact log: error over the largest", "over itself", "noisy log: condition",
              "error over the largest", "torque predicted, prior", "identified"]
    rows = [[e["robot"], f"{e['base_parameters']} of {e['standard_parameters']}", f"{e['base_error_over_largest']:.1e}",
             f"{e['base_error_relative']:.1e}", f"{n['condition']:.0f}", f"{n['base_error_over_largest']:.1e}",
             f"{100 * n['torque_error_prior']:.0f} %", f"{100 * n['torque_error_identified']:.2f} %"] for e, n in zip(exact, noisy)]
    return markdown(header, rows)


def provenance(folder):
    made = load(folder / "identification_provenance.json")
    return f"Commit `{made['commit']}`, {made['compiler']}; {made['libraries']}.\n"


TABLES = {"identification": study, "identification_provenance": provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
