"""Writes the tables of doc/measurements/elastic.md, as tables.py does with the others.

usage: elastic_tables.py DATA_FOLDER DOCUMENT.md
"""

import math

from tables import command, grouped, load, markdown

ROBOTS = ("puma560", "scara")


def pairs(folder, robot, chosen):
    """Rows by elastic and by rigid feed-forward of the same situation, as they stand beside each other."""
    rows = [row for row in load(folder / f"elastic-{robot}.json") if chosen(row)]
    return zip(rows[0::2], rows[1::2])


def micrometres(row):
    return f"{1e6 * row['tool_error_rms']:.3g}"


def in_the_loop(folder):
    rows = [[robot, str(elastic["resonance_Hz"]), micrometres(elastic), micrometres(rigid), f"{elastic['ratio']:.3g}",
             grouped(elastic["count_most"]), grouped(rigid["count_most"])]
            for robot in ROBOTS for elastic, rigid in pairs(folder, robot, lambda row: row["board"] != "host")]
    return markdown(["robot", "resonance, Hz", "tool error, RMS, um: elastic", "rigid", "rigid / elastic",
                     "instructions per tick: elastic", "rigid"], rows)


def stiffness(folder):
    rows = [[robot, str(elastic["resonance_Hz"]), micrometres(elastic), micrometres(rigid), f"{elastic['ratio']:.3g}"]
            for robot in ROBOTS for elastic, rigid in pairs(folder, robot, lambda row: row["name"] == "stiffness")]
    return markdown(["robot", "resonance, Hz", "tool error, RMS, um: elastic", "rigid", "rigid / elastic"], rows)


def enough_from(folder, robot, metres):
    """Hz from which rigid feed-forward's error stays below `metres`, along a line of logarithms; None: beyond what was measured."""
    points = [(row["resonance_Hz"], row["tool_error_rms"]) for row in load(folder / f"elastic-{robot}.json")
              if row["name"] == "stiffness" and row["feed_forward"] == "rigid"]
    for (soft, above), (hard, below) in zip(points, points[1:]):
        if below <= metres < above:
            share = math.log(above / metres) / math.log(above / below)
            return soft * (hard / soft) ** share
    return None


def enough(folder):
    rows = []
    for robot in ROBOTS:
        found = [enough_from(folder, robot, metres) for metres in (1e-3, 1e-4)]
        rows.append([robot] + ["beyond the table" if hertz is None else f"{hertz:.0f}" for hertz in found])
    return markdown(["robot", "rigid is enough for a tool error of 1 mm from, Hz", "of 0.1 mm from, Hz"], rows)


def spoiled(folder):
    rows = [[robot, elastic["name"], micrometres(elastic), micrometres(rigid), f"{elastic['ratio']:.3g}"]
            for robot in ROBOTS
            for elastic, rigid in pairs(folder, robot, lambda row: row["board"] == "host" and row["name"] != "stiffness")]
    return markdown(["robot", "at 12 Hz, but", "tool error, RMS, um: elastic", "rigid", "rigid / elastic"], rows)


def provenance(folder):
    made = load(folder / "elastic_provenance.json")
    board = made["boards"]["stm32f405"]
    return f"Measured at commit `{made['commit']}`; `stm32f405`: {board['compiler']}; `{board['flags']}`.\n"


TABLES = {"elastic_loop": in_the_loop, "elastic_stiffness": stiffness, "elastic_enough": enough, "elastic_spoiled": spoiled,
          "elastic_provenance": provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
