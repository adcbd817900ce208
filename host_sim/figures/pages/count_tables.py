"""Writes the tables of operation counts into a document, as tables.py does with the others.

usage: count_tables.py DATA_FOLDER DOCUMENT.md

DATA_FOLDER holds counts.json, congruences.json, published_counts.json and counts_provenance.json.
"""

from tables import command, load, markdown, unique

BARS = [("inverse_dynamics", "base", "inverse dynamics"), ("mass_matrix", "base", "mass matrix"),
        ("composite_body", "base", "forward dynamics by composite bodies"),
        ("articulated_body", "base", "ABA, base parameters"), ("articulated_body", "full", "ABA, full parameters")]
PLAIN = [("inverse_dynamics", "inverse dynamics"), ("bias", "bias"), ("gravity", "gravity"), ("mass_matrix", "mass matrix")]
FORMS = [("articulated_body", "full"), ("articulated_body", "base"), ("split_articulated_body", "full"),
         ("split_articulated_body", "base"), ("composite_body", "full"), ("composite_body", "base")]

DERIVATIVES = ("inverse_dynamics_derivatives", "forward_dynamics_derivatives")
RATES = ("torque_rates", "elastic_feedforward")


class Data:
    def __init__(self, folder):
        self.rows = load(folder / "counts.json")
        self.counts = {(row["robot"], row["algorithm"], row["parameters"]): row for row in self.rows}
        self.bars = {(row["robot"], row["algorithm"], row["parameters"]): row
                     for row in load(folder / "published_counts.json")["rows"]}
        self.congruences = load(folder / "congruences.json")
        self.provenance = load(folder / "counts_provenance.json")
        self.robots = unique(row["robot"] for row in self.rows)


def pair(operations):
    return f"{operations[0]}/{operations[1]}"


def ours(row):
    """Multiplications/additions, and divisions where there are some."""
    return pair((row["mul"], row["add"])) + (f" {row['div']}D" if row.get("div") else "")


def total(row):
    """M + A."""
    return row["mul"] + row["add"]


def against(row, bar):
    """Difference of M + A."""
    return f"{total(row) - sum(bar):+d}"


def counts_bars(data):
    """Count models: ours, openSYMORO's, what a trace reached; M + A compared."""
    header = ["count model, algorithm", "axial", "openSYMORO", "axial against it", "reachable", "axial against it"]
    rows = []
    for algorithm, parameters, label in BARS:
        for robot in data.robots:
            bar, row = data.bars.get((robot, algorithm, parameters)), data.counts[robot, algorithm, parameters]
            if bar:
                cells = [text for name in ("open_symoro", "reachable")
                         for text in ((pair(bar[name]), against(row, bar[name])) if name in bar else ("", ""))]
                rows.append([f"{robot}, {label}", ours(row)] + cells)
    return markdown(header, rows)


def counts_plain(data):
    """Algorithms without a choice of form: base, and full in brackets."""
    rows = []
    for robot in data.robots:
        cells = [f"{ours(data.counts[robot, name, 'base'])} ({ours(data.counts[robot, name, 'full'])})" for name, _ in PLAIN]
        closed = data.counts.get((robot, "closed_form", "base"))
        pairs = data.counts[robot, "inverse_dynamics", "base"]["sincos"]
        rows.append([robot] + cells + [ours(closed) if closed else "", str(pairs)])
    return markdown(["M/A, base (full)"] + [label for _, label in PLAIN] + ["closed form", "pairs"], rows)


def counts_forms(data):
    """Forms of forward dynamics, each count with its forward error in float and double."""
    rows = []
    for robot in data.robots:
        chosen = next(row for row in data.rows if row["robot"] == robot and row["algorithm"] == "forward_dynamics")
        for algorithm, parameters in FORMS:
            row = data.counts[robot, algorithm, parameters]
            taken = (chosen["route"], chosen["parameters"]) == (algorithm, parameters)
            rows.append([f"{robot}, {algorithm.replace('_', ' ')}, {parameters}", ours(row), str(total(row)),
                         f"{row['error_float']:.1e}", f"{row['error_double']:.1e}", "chosen" if taken else ""])
    return markdown(["robot, form, parameters", "M/A", "M + A", "error, float", "error, double", "forward_dynamics"], rows)


def times_inverse_dynamics(data, names):
    """Algorithms on base parameters, with how many times the inverse dynamics that is."""
    rows = []
    for robot in data.robots:
        of_robot = {name: data.counts.get((robot, name, "base")) for name in ("inverse_dynamics", *names)}
        if None in of_robot.values():
            continue
        plain, *derived = (total(row) for row in of_robot.values())
        rows.append([robot, str(plain)] + [text for name, count in zip(names, derived)
                                           for text in (ours(of_robot[name]), str(count), f"{count / plain:.1f}")])
    header = ["robot", "inverse dynamics"]
    for name in names:
        header += [name.replace("_", " "), "M + A", "times inverse dynamics"]
    return markdown(header, rows)


def counts_derivatives(data):
    return times_inverse_dynamics(data, DERIVATIVES)


def counts_rates(data):
    """What follows a path with its third and fourth derivative."""
    return times_inverse_dynamics(data, RATES)


def counts_congruences(data):
    """Ways to carry the inertia across a link: operations, then the error in float for every length of chain."""
    links = unique(row["links"] for row in data.congruences)
    rows = []
    for name in unique(row["congruence"] for row in data.congruences):
        of_name = {row["links"]: row for row in data.congruences if row["congruence"] == name}
        first = of_name[links[0]]
        rows.append([name, ours(first), str(total(first))] + [f"{of_name[n]['error_float']:.1e}" for n in links])
    return markdown(["congruence", "M/A a link", "M + A"] + [f"error, float, N = {n}" for n in links], rows)


def counts_provenance(data):
    p = data.provenance
    return f"Counted at commit `{p['commit']}`; errors with {p['compiler']}, `{p['flags']}`.\n"


TABLES = {table.__name__: table for table in (counts_bars, counts_plain, counts_forms, counts_derivatives, counts_rates,
                                          counts_congruences, counts_provenance)}


if __name__ == "__main__":
    command(__doc__, TABLES, Data)
