"""Writes the tables of doc/measurements/linearisation.md, as tables.py does with the others.

usage: linearisation_tables.py DATA_FOLDER DOCUMENT.md
"""

from tables import command, grouped, load, markdown


def pushes(folder):
    rows = [[row["name"], by(row), row["controller"], f"{row['recovery_seconds']:.3f}", f"{row['effort_over_limit']:.2f}",
             f"{1e3 * row['overshoot']:.2g}"] for row in regulated(folder) if any(row["push"])]
    return markdown(["situation", "torques by", "loop", "back within 1 mrad, s", "largest torque over its limit", "beyond, mrad"], rows)


def motions(folder):
    rows = [[row["name"], by(row), row["controller"], f"{row['seconds']:g}", f"{1e3 * row['tool_error_rms']:.3g}",
             f"{1e3 * row['tool_error_max']:.3g}", "" if row["board"] == "host" else grouped(row["count_most"])]
            for row in regulated(folder) if not any(row["push"])]
    return markdown(["situation", "torques by", "loop", "motion, s", "tool error, RMS, mm", "largest, mm", "instructions per tick"], rows)


def velocities(folder):
    rows = [[row["name"], by(row), row["controller"], largest(row["velocity_error_filter"]), largest(row["velocity_error_difference"]),
             largest(row["velocity_error_ten_ticks"]), f"{row['torque_change_over_limit']:.2g}", f"{1e3 * row['tool_error_rms']:.3g}",
             grouped(row["count_most"]) if row["count_most"] else ""] for row in load(folder / "ekf-puma560.json")]
    return markdown(["encoders", "torques by", "loop", "velocity error, mrad/s: filter", "difference of a tick", "of ten ticks",
                     "torque change per tick over its limit", "tool error, RMS, mm", "instructions per tick"], rows)


def largest(errors):
    return f"{1e3 * max(errors):.3g}" if errors else ""


def regulated(folder):
    return load(folder / "lqr-puma560.json")


def by(row):
    return "host" if row["board"] == "host" else f"{row['board']} in QEMU"


def provenance(folder):
    made = load(folder / "linearisation_provenance.json")
    board = made["boards"]["stm32f405"]
    return f"Measured at commit `{made['commit']}`; `stm32f405`: {board['compiler']}; `{board['flags']}`.\n"


TABLES = {"pushes": pushes, "regulated_motions": motions, "velocities": velocities, "linearisation_provenance": provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
