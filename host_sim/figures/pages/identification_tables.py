"""Writes the tables of doc/measurements/identified_arms.md, as tables.py does with the others.

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


def verdicts(folder):
    """A row per kind of mistake, none first."""
    kinds = {}
    for row in load(folder / "identification_verdicts.json"):
        kinds.setdefault(row["mistake"] or "none", []).append(row)
    header = ["mistake planted", "logs", "the log can tell it", "of these named, and no other", "it cannot", "of these named all the same", "false accusations"]
    rows = []
    for kind, own in kinds.items():
        can, cannot = ([row for row in own if row["mistake"] and row["tellable"] == which] for which in (True, False))
        named = lambda some: str(sum(row["outcome"] == "named" for row in some))
        rows.append([kind, str(len(own)), str(len(can)), named(can), str(len(cannot)), named(cannot), str(sum(row["outcome"] == "false" for row in own))])
    return markdown(header, [*rows, ["all", *(str(sum(int(row[k]) for row in rows)) for k in range(1, len(header)))]])


def provenance(folder, of="identification"):
    made = load(folder / f"{of}_provenance.json")
    return f"Commit `{made['commit']}`, {made['compiler']}; {made['libraries']}.\n"


TABLES = {"identification": study, "identification_verdicts": verdicts, "identification_provenance": provenance,
          "verdicts_provenance": lambda folder: provenance(folder, "identification_verdicts")}


if __name__ == "__main__":
    command(__doc__, TABLES)
