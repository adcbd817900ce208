"""Writes the tables of the stability suite into a document, as tables.py does with the others.

usage: stability_tables.py DATA_FOLDER DOCUMENT.md

DATA_FOLDER holds stability.json and stability_provenance.json.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "plot"))
import stability  # noqa: E402
from stability import ENGINES, ROUTES, SCALARS, of, unique  # noqa: E402
from tables import command, load, markdown  # noqa: E402

# What each variant of the ablation is called in the document.
VARIANTS = ["textbook", "1", "2", "2p", "3", "1+2", "1+3", "2+3", "1+2p+3", "1+2+3'", "1+2+3", "1+2+3, dense", "textbook, world axes", "axial"]


class Data:
    def __init__(self, folder):
        self.rows = load(folder / "stability.json")
        self.provenance = load(folder / "stability_provenance.json")

    def kind(self, kind):
        return [row for row in self.rows if row["kind"] == kind]


def number(value):
    return "" if value is None else "0" if value == 0.0 else f"{value:.1e}"


def provenance(data):
    p = data.provenance
    return (f"Measured at commit `{p['commit']}`: {p['compiler']}, `{p['flags']}`; engines as Debian built them: "
            f"{', '.join(p['packages'])}.\n")


def verdict(data):
    rows = data.kind("gate")
    missed = [row for row in rows if not row["pass"]]
    peers = [row for row in data.kind("peer") if row["gate"] is not None]
    worst = max(peers, key=lambda row: row["ratio"])
    lines = [f"- {len(rows)} answers of ours, {len(missed)} outside their gates" +
             "".join(f"; {row['scenario']}, {row['scalar']}, {ROUTES[row['route']]}: {number(row['forward_error'])} of "
                     f"{number(row['gate'])}" for row in missed) + "\n"]
    lines.append(f"- {len(peers)} comparisons with an engine, {sum(not row['pass'] for row in peers)} in which it is more than ten "
                 f"times more exact; the largest median ratio of our error to an engine's is {worst['ratio']:.2g}\n")
    return "".join(lines)


def gates(data):
    """A row a scenario: condition, and each type's routes, the gate of articulated bodies."""
    rows = data.kind("gate")
    header = ["scenario", "N", "cond(M)"]
    for scalar in SCALARS:
        header += [f"{scalar}: ABA", "gate", "split", "composite", "default"]
    header.append("flagged by ABA")
    table = []
    for name in unique(row["scenario"] for row in sorted(rows, key=stability.family)):
        own = [row for row in rows if row["scenario"] == name]
        line = [name, str(own[0]["joints"]), number(own[0]["condition"])]
        flagged = [row["scalar"] for row in of(own, route="articulated_body") if row["status"] != "ok"]
        for scalar in SCALARS:
            by_route = {row["route"]: row for row in of(own, scalar=scalar)}
            first = by_route.get("articulated_body")
            line += [cell(first), number(first["gate"]) if first else ""]
            line += [cell(by_route.get(route)) for route in list(ROUTES)[1:]]
        table.append(line + [", ".join(flagged)])
    return markdown(header, table)


def cell(row):
    if row is None:
        return ""
    if row["condition"] is None:
        return "reported" if row["pass"] else "**not reported**"
    text = number(row["forward_error"])
    return text if row["pass"] else f"**{text}**"


def backward(data):
    """The largest backward error of a family, by route and type: what a residual sees."""
    rows = [row for row in data.kind("gate") if row["backward_error"] is not None and row["condition"] is not None and
            row["family"] != "ST14" and not row["scenario"].startswith(("S12_bits",)) and not row["scenario"].endswith("_median")]
    columns = [(scalar, route) for scalar in SCALARS for route in ROUTES]
    table = []
    for family in unique(row["family"] for row in sorted(rows, key=stability.family)):
        own = of(rows, family=family)
        table.append([family] + [number(max((row["backward_error"] for row in of(own, scalar=scalar, route=route)), default=None))
                                 for scalar, route in columns])
    return markdown(["family"] + [f"{scalar}, {ROUTES[route]}" for scalar, route in columns], table)


def fixed(data):
    rows = of(data.kind("gate"), scalar="fixed32")
    both = {row["scenario"]: row for row in data.kind("gate") if row["scalar"] == "float" and row["route"] == "split_articulated_body"}
    table = [[row["scenario"], number(row["condition"]), number(row["forward_error"]), number(row["gate"]),
              number(both[row["scenario"]]["forward_error"])] for row in sorted(rows, key=stability.family)]
    return markdown(["scenario", "cond(M)", "32-bit fixed point", "gate", "float, split ABA"], table)


BLOCKS = ["M", "dtau_dq", "dtau_dqd", "dqdd_dq", "dqdd_dqd"]


def derivatives(data):
    """A row a scenario: the error of each block in each type."""
    rows = data.kind("derivatives")
    header = ["scenario", "N", "cond(M)"]
    for scalar in SCALARS:
        header += [f"{scalar}: {block}" for block in BLOCKS] + ["accelerations' status"]
    table = []
    for name in unique(row["scenario"] for row in sorted(rows, key=stability.family)):
        own = of(rows, scenario=name)
        line = [name, str(own[0]["joints"]), number(own[0]["condition"])]
        for scalar in SCALARS:
            by_block = {row["route"]: row for row in of(own, scalar=scalar)}
            line += [cell(by_block[block]) for block in BLOCKS] + [by_block[BLOCKS[-1]]["status"].replace("_", " ")]
        table.append(line)
    return markdown(header, table)


def ablation(data):
    rows = data.kind("ablation")
    scenarios = unique((row["scenario"], row["scalar"]) for row in rows)
    errors = {(row["scenario"], row["scalar"], row["route"]): row["forward_error"] for row in rows}
    table = [[f"{scenario}, {scalar}"] + [number(errors.get((scenario, scalar, name))) for name in VARIANTS]
             for scenario, scalar in scenarios]
    return markdown(["scenario"] + VARIANTS, table)


def engines(data):
    """Medians over the perturbed instances, double; and Bullet's float beside ours."""
    rows = [row for row in data.kind("peer") if not row["status"].startswith("answers")]
    header = ["scenario", "axial, double"] + list(ENGINES.values()) + ["axial, float", "Bullet, float"]
    table = []
    for name in unique(row["scenario"] for row in sorted(rows, key=stability.family)):
        own = of(rows, scenario=name)
        double = {row["route"]: row for row in of(own, scalar="double")}
        single = {row["route"]: row for row in of(own, scalar="float")}
        line = [name, number(next(iter(double.values()))["our_median_error"])]
        line += [median(double.get(engine)) for engine in ENGINES]
        line += [number(single["bullet"]["our_median_error"]) if single else "", median(single.get("bullet"))]
        table.append(line)
    return markdown(header, table)


def median(row):
    if row is None:
        return ""
    text = "NaN" if row["median_error"] is None else number(row["median_error"])
    return text if row["pass"] else f"**{text}**"


def nominal(data):
    """The engines on the scenarios themselves: one instance each."""
    rows = [row for row in data.kind("peer") if not row["status"].startswith("answers")]
    ours = {(row["scenario"], row["scalar"]): row for row in data.kind("gate") if row["route"] == "articulated_body"}
    table = []
    for name in unique(row["scenario"] for row in sorted(rows, key=stability.family)):
        own = {row["route"]: row for row in of(rows, scenario=name, scalar="double")}
        values = ["" if engine not in own else number(own[engine]["forward_error"]) or "NaN" for engine in ENGINES]
        table.append([name, number(ours[name, "double"]["forward_error"])] + values)
    return markdown(["scenario", "axial"] + list(ENGINES.values()), table)


def singular(data):
    rows = [row for row in data.kind("peer") if row["status"].startswith("answers")]
    table = [[row["scenario"], f"{ENGINES[row['route']]}, {row['scalar']}", row["status"][len("answers "):]] for row in rows]
    ours = [row for row in data.kind("gate") if row["condition"] is None]
    table += [[row["scenario"], f"axial, {ROUTES[row['route']]}, {row['scalar']}", row["status"]] for row in ours]
    return markdown(["scenario", "who", "what it says"], sorted(table))


def motions(data):
    rows = data.kind("integrator")
    table = [[row["scenario"], row["scalar"], row["route"].replace("_", " "), f"{row['step']:.3g}", f"{row['seconds']:.3g}", row["quantity"],
              number(row["forward_error"]) or "not finite", number(row["gate"]), row["status"] if row["pass"] else "**missed**"] for row in rows]
    return markdown(["scenario", "numbers", "integrator", "step, s", "time, s", "error of", "error", "gate", "verdict"], table)


TABLES = {"stability_motions": motions, "stability_provenance": provenance, "stability_verdict": verdict, "stability_gates": gates, "stability_backward": backward,
          "stability_fixed": fixed, "stability_ablation": ablation, "stability_engines": engines, "stability_nominal": nominal,
          "stability_singular": singular, "stability_derivatives": derivatives}


if __name__ == "__main__":
    command(__doc__, TABLES, Data)
