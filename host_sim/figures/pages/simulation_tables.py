"""Writes the tables of doc/measurements/simulation.md, as tables.py does with the others.

usage: simulation_tables.py DATA_FOLDER DOCUMENT.md
"""

from tables import command, grouped, load, markdown


def number(value):
    return f"{value:.2g}"


def work(folder):
    """The front of each motion."""
    data = load(folder / "simulation.json")
    rows = [[row["subject"].removeprefix("simulation, ").replace("_", " "), row["robot"], row["variant"].replace("_", " "),
             row["scalar"], f"{row['step']:.2g}", grouped(row["work"]), f"{row['time_ratio']:.3g}", number(row["error"])]
            for row in data if row["pareto"]]
    return markdown(["motion", "robot", "integrator", "scalar", "step, s", "kernel calls", "time over one kernel", "error"], rows)


JOINTS, DRIVES = ("scara", "puma560"), ("scara_quill", "palletiser")  # robots of the loops: those of DRIVES share them
OF_DRIVES = ("exact parameters", "parameters 5 % off", "encoders of 16 bits", "torques 2 ms late")  # what is shown of them


def loop_rows(folder, robots=JOINTS):
    return [(robot, row) for robot in robots for row in load(folder / f"loop-{robot}.json")]


def loops(folder):
    return loop_table(loop_rows(folder))


def driven_loops(folder):
    return loop_table([(robot, row) for robot, row in loop_rows(folder, DRIVES) if row["name"] in OF_DRIVES])


def loop_table(found):
    rows = [[robot, row["name"], row["scalar"], "host" if row["board"] == "host" else f"{row['board']} in QEMU",
             "feed-forward" if row["feeds_forward"] else "feedback alone", f"{row['seconds']:g}",
             f"{row['tool_error_rms'] * 1e3:.3g}", f"{row['tool_error_max'] * 1e3:.3g}",
             f"{row['ratio']:.3g}" if "ratio" in row else ""] for robot, row in found]
    return markdown(["robot", "situation", "number", "torques by", "loop", "motion, s", "tool error, RMS, mm", "largest, mm",
                     "feedback alone over this"], rows)


def provenance(folder):
    made = load(folder / "motion_provenance.json")
    loop = load(folder / "loop_provenance.json")
    text = f"Motions: commit `{made['commit']}`, {made['compiler']}, `{made['flags']}`.\n"
    boards = sorted({row["board"] for _, row in loop_rows(folder)} - {"host"})
    compiled = "; ".join(f"`{board}`: {loop['boards'][board]['compiler']}; `{loop['boards'][board]['flags']}`" for board in boards)
    of_drives = load(folder / "driven_loop_provenance.json")["commit"]
    return text + f"Loops: commit `{loop['commit']}`, of shared drives `{of_drives}`; {compiled}.\n"


TABLES = {"simulation": work, "loops": loops, "driven_loops": driven_loops, "simulation_provenance": provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
