"""Rows that are no kernel's: feed-forward at two rates, simulations, stability."""

import json
import pathlib

import pareto

BOARDS = ("stm32f405", "nrf51")
FIELDS = ("subject", "robot", "scalar", "variant", "board", "error", "work", "unit_of_work", "pareto")


def two_rate(separation):
    """Of `separation.json`: error against how often the terms are refreshed. The work is that of a tick on average; the tick
    that refreshes costs `work_worst`."""
    rows = []
    for row in separation["two_rate"]:
        for board in BOARDS:
            if row.get(f"{board}_per_tick") is None:
                continue
            for ahead, error in (("", "error"), (", ahead", "error_ahead")):
                rows.append({"subject": "two_rate_feedforward", "robot": row["robot"], "scalar": "float",
                             "variant": f"refresh every {row['ticks']} ticks{ahead}", "board": board, "error": row[error],
                             "work": row[f"{board}_per_tick"], "unit_of_work": "instructions", "pareto": False,
                             "ticks": row["ticks"], "work_worst": row[f"{board}_worst_tick"],
                             "work_full_rate": row[f"{board}_full_rate"]})
    pareto.mark(rows, lambda row: (row["robot"], row["board"]))
    return rows


def found(folder, name):
    """Rows of another program's file in the folder of data, where it is there."""
    path = pathlib.Path(folder) / name
    if not path.exists():
        return []
    rows = json.loads(path.read_text(encoding="utf-8"))
    missing = {field for row in rows for field in FIELDS if field not in row}
    if missing:
        raise ValueError(f"{path}: rows without {', '.join(sorted(missing))}")
    return rows


def stability(folder):
    """The gates of ./axial stability, where they are there."""
    path = pathlib.Path(folder) / "stability.json"
    rows = json.loads(path.read_text(encoding="utf-8")) if path.exists() else []
    return [row for row in rows if row["kind"] in ("gate", "integrator")]
