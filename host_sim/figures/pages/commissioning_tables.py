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


def verdicts(folder):
    """A row per kind of fault, none first: how many logs, of how many the poses tell it, what is said of them."""
    kinds, data = {}, load(folder / "accusations.json")
    for row in data:
        kinds.setdefault(row["fault"][0] if row["fault"] else "none", []).append(row)
    header = ["fault planted", "logs", "poses can tell it", "of these named, and nothing else", "poses cannot tell it", "of these named all the same", "false accusations"]
    rows = []
    for kind, own in kinds.items():
        tellable = [row for row in own if row["tellable"]]
        named = lambda some: sum(row["outcome"] == "named" for row in some)
        others = [row for row in own if row["fault"] and not row["tellable"]]
        false = sum(row["outcome"] == "false" for row in own)
        rows.append([kind, str(len(own)), str(len(tellable)), str(named(tellable)), str(len(others)), str(named(others)), str(false)])
    total = [str(sum(int(row[k]) for row in rows)) for k in range(1, len(header))]
    return markdown(header, [*rows, ["all", *total]])


def untold(folder):
    """A row per fault that the poses cannot tell: why, and what is said."""
    rows = []
    for row in load(folder / "accusations.json"):
        if row["fault"] and not row["tellable"]:
            kind, joints = row["fault"]
            said = " or ".join(" and ".join(_named(*each) for each in way) for way in row["ways"]) or "; ".join(_named(*each) for each in row["claims"]) or "nothing wrong"
            rows.append([row["arm"], _named(kind, joints), row["like"], said])
    return markdown(["arm", "fault planted", "as well explained by", "verdict"], rows, words=4)


def _named(kind, joints):
    return kind if kind in ("sides negated", "mass", "tilt") else f"{kind} {', '.join(str(j + 1) for j in joints)}"


def drawn(folder):
    """A row per arm."""
    arms = {}
    for row in load(folder / "accusations.json"):
        arms.setdefault(row["arm"], []).append(row)
    count = lambda rows, outcome: sum(row["outcome"] == outcome for row in rows)
    rows = [[name, str(own[0]["joints"]), str(sum(row["fault"] is None for row in own)), str(count(own, "nothing wrong")), str(sum(row["fault"] is not None for row in own)),
             str(sum(row["tellable"] for row in own)), str(count(own, "named")), str(count(own, "false"))] for name, own in arms.items()]
    return markdown(["arm", "joints", "logs without a fault", "called so", "logs with one", "poses can tell it", "named", "false accusations"], rows)


def provenance(folder, of="commissioning"):
    made = load(folder / f"{of}_provenance.json")
    return f"Commit `{made['commit']}`, {made['compiler']}; {made['libraries']}.\n"


TABLES = {"commissioning": whole, "commissioning_arms": arms, "commissioning_provenance": provenance,
          "accusations_provenance": lambda folder: provenance(folder, "accusations"), "verdicts": verdicts, "untold": untold, "verdict_arms": drawn}


if __name__ == "__main__":
    command(__doc__, TABLES)
