"""Writes the tables of doc/measurements/plant.md, as tables.py does with the others.

usage: plant_tables.py DATA_FOLDER DOCUMENT.md
"""

from tables import command, grouped, load, markdown

JOINTS = {"scara": 3, "puma560": 6, "panda": 7}
TICK_US = 1000.0
NUMBERS = ("float", "fixed32")
# What was promised: board, robot, number, method, times real time at least, error at most.
PROMISES = [("stm32f405", "puma560", "float", "runge_kutta_4", 10.0, 1e-5), ("rp2040_ram", "puma560", "fixed32", "runge_kutta_4", 1.0, 1e-4),
            ("nrf51", "scara", "fixed32", "semi_implicit", 1.0, 1e-3)]
DRIFT = 1e-4


def number(value):
    return "" if value is None else f"{value:.2g}"


def method(row):
    return row["method"].replace("_", " ")


def rows(folder):
    found = [[row["robot"], row["motion"], method(row), f"{row['step_s'] * 1e3:g}", row["scalar"],
              number(row["error"]), number(row["energy_drift"])] for row in load(folder / "plant.json")]
    return markdown(["robot", "motion", "method", "step, ms", "number", "error over travel", "energy drift"], found)


def boards_rows(folder):
    return load(folder / "plant_boards.json")


def seconds(folder):
    """{(board, robot, number, method): its driven second}, of those that fit their board."""
    return {(row["board"], row["robot"], row["scalar"], row["method"]): row for row in boards_rows(folder) if "microseconds" in row}


def longest(row):
    """Microseconds of a step at the upper end of what the core's model leaves open."""
    return row["microseconds"] * row["cycles_high"] / row["cycles"] if "cycles_high" in row else row["microseconds"]


def shown(us):
    return f"{us:.1f}" if us < 1000.0 else grouped(round(us))


def microseconds(row):
    interval = f" to {shown(longest(row))}" if "cycles_high" in row else ""
    return f"{shown(row['microseconds'])}{interval} ({row['kind']})"


def factor(value):
    return f"{value:.3g}"


def bits(row):
    return "the same" if row["same_bits"] else f"{row['difference']:.1e} of travel"


def boards(folder):
    """By Runge-Kutta; what a step costs, and how many of them a second has room for."""
    found = [[row["board"], row["robot"], row["scalar"], number(row["error"]), grouped(row["instructions"]), microseconds(row),
              factor(row["real_time_factor"]), factor(row["real_time_factor_low"]), bits(row)]
             for row in seconds(folder).values() if row["method"] == "runge_kutta_4"]
    return markdown(["board", "robot", "number", "error over travel", "instructions per step", "us per step", "times real time", "at worst", "the host's bits"], found)


def promises(folder):
    found, measured = [], seconds(folder)
    for *key, times, error in PROMISES:
        row = measured[tuple(key)]
        met = row["real_time_factor_low"] >= times and row["error"] <= error and row["same_bits"]
        found.append([row["board"], row["robot"], f"{row['scalar']}, {method(row)}", f"at least {times:g} times real time, at most {error:g} of travel",
                      f"{factor(row['real_time_factor_low'])} at worst, {number(row['error'])}", "yes" if met else "NO"])
    for row in boards_rows(folder):
        if row.get("energy_drift") is not None:
            found.append([row["board"], row["robot"], f"{row['scalar']}, {method(row)}", f"60 s of a free swing: at most {DRIFT:g} of its energy",
                          number(row["energy_drift"]), "yes" if row["energy_drift"] <= DRIFT else "NO"])
    return markdown(["board", "robot", "by", "promised", "measured", "met"], found)


def joints_in_real_time(costs):
    """Of {joints: microseconds}: the most whose step takes a tick at most. Between robots a straight line, from 0 for no joint; above the largest one
    its own cost per joint or the line from the smallest, whichever is the steeper."""
    known = [(0, 0.0), *sorted(costs.items())]
    (low, cheap), (high, dear) = known[1], known[-1]
    slope = max(dear / high, (dear - cheap) / (high - low) if high > low else 0.0)
    if dear <= TICK_US:
        return high + int((TICK_US - dear) / slope)
    most = 0
    for (before, cost_before), (after, cost_after) in zip(known, known[1:]):
        for n in range(before + 1, after + 1):
            if cost_before + (cost_after - cost_before) * (n - before) / (after - before) <= TICK_US:
                most = n
    return most


def joints(folder):
    measured = seconds(folder)
    found = []
    for board in dict.fromkeys(board for board, robot, _, _ in measured if (board, "panda") in {key[:2] for key in measured}):
        for by in ("runge_kutta_4", "semi_implicit"):
            cells = []
            for scalar in NUMBERS:
                costs = {JOINTS[robot]: longest(row) for (on, robot, kind, how), row in measured.items() if (on, kind, how) == (board, scalar, by)}
                cells.append(str(joints_in_real_time(costs)) if costs else "")
            found.append([board, by.replace("_", " "), *cells])
    return markdown(["board", "method", *NUMBERS], found)


COLUMNS = (("stm32f405", "float"), ("stm32f405", "fixed32"), ("rp2040_ram", "fixed32"))


def robot_cells(row):
    if row is None:
        return ["no image", ""]
    verdict = "" if row["pass"] else ", MISSED" if row["made"] else ", refused where it left its limits"
    return [number(row["error"]), factor(row["real_time_factor_low"]) + verdict]


def robots(folder):
    """Of the gallery, one drawn: error and times real time, the worse end, of each column's board and number."""
    measured = load(folder / "plant_robots.json")
    found = []
    for name in dict.fromkeys(row["machine"] for row in measured):
        cells = [name, number(next((row["growth"] for row in measured if row["machine"] == name and row.get("growth")), None))]
        for column in COLUMNS:
            cells += robot_cells(next((row for row in measured if (row["machine"], row["board"], row.get("scalar")) == (name, *column)), None))
        found.append(cells)
    heads = [head for board, kind in COLUMNS for head in (f"{board}, {kind}: error over travel", "times real time, at worst")]
    return markdown(["robot", "growth", *heads], found)


def robots_provenance(folder):
    commits = sorted({row["commit"] for row in load(folder / "plant_robots.json")})
    return f"Commit {', '.join(f'`{commit}`' for commit in commits)}.\n"


def provenance(folder):
    made = load(folder / "plant_provenance.json")
    return f"Commit `{made['commit']}`. On the host: {made['compiler']}, `{made['flags']}`; images of Arm boards: {made['boards']}, flags of hal/toolchains.\n"


TABLES = {"plant": rows, "plant_boards": boards, "plant_promises": promises, "plant_joints": joints, "plant_provenance": provenance,
          "plant_robots": robots, "plant_robots_provenance": robots_provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
