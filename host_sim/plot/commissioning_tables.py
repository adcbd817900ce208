"""Writes the tables of doc/measurements/commissioned_arms.md, as tables.py does with the others.

usage: commissioning_tables.py DATA_FOLDER DOCUMENT.md
"""

import math

from tables import command, load, markdown


def degrees(value):
    return "-" if value is None else f"{math.degrees(value):.3f}"


def arms(folder):
    """A row per arm: what is planted, errors of what is told, of twenty samples a hold and of one."""
    data = load(folder / "commissioning.json")
    often = {row["arm"]: row for row in data if row["samples"] > 1}
    once = {row["arm"]: row for row in data if row["samples"] == 1}
    header = ["arm", "joints", "wires, axes, signs planted", "numbers planted", "tilt planted, degrees", "missed", "invented", "scales told",
              "scale, %", "zero, degrees", "tilt, degrees", "one sample: scale, %", "zero, degrees", "tilt, degrees"]
    rows = []
    for name, row in often.items():
        other = once[name]
        rows.append([name, str(row["joints"]), "; ".join(row["planted"]) or "none", str(row["numbers_planted"]), degrees(row["tilt_planted"]),
                     str(len(row["missed"]) + row["tilt_missed"]), str(len(row["invented"]) + row["tilt_invented"]), str(row["scales_told"])]
                    + [cell for each in (row, other) for cell in (f"{100 * each['scale_error']:.2f}", degrees(each["zero_error"]), degrees(each["tilt_error"]))])
    return markdown(header, rows, words=(0, 2))


def whole(folder):
    """The worst of all arms."""
    header = ["samples a hold", "arms", "mistakes planted", "missed", "invented", "not told", "largest error: scale, %", "zero, degrees", "slide's zero, mm", "tilt, degrees"]
    data = load(folder / "commissioning.json")
    rows = []
    for samples in sorted({row["samples"] for row in data}, reverse=True):
        own = [row for row in data if row["samples"] == samples]
        count = lambda name: sum(len(row[name]) for row in own)
        planted = count("planted") + sum(row["numbers_planted"] + (row["tilt_planted"] > 0.0) for row in own)
        missed, invented = (count(name) + sum(row[f"tilt_{name}"] for row in own) for name in ("missed", "invented"))
        worst = lambda name: max(row[name] for row in own if row[name] is not None)
        rows.append([str(samples), str(len(own)), str(planted), str(missed), str(invented), str(count("called_untold")), f"{100 * worst('scale_error'):.2f}",
                     degrees(worst("zero_error")), f"{1000 * worst('slide_error'):.2f}", degrees(worst("tilt_error"))])
    return markdown(header, rows, words=0)


def provenance(folder):
    made = load(folder / "commissioning_provenance.json")
    return f"Commit `{made['commit']}`, {made['compiler']}; {made['libraries']}.\n"


TABLES = {"commissioning": whole, "commissioning_arms": arms, "commissioning_provenance": provenance}


if __name__ == "__main__":
    command(__doc__, TABLES)
