"""The kernels' rows: what host_sim/figures/errors says of a kernel beside what its probe costs on each board."""

import pathlib
import sys

import pareto

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "boards/size"))
import routes  # noqa: E402
from size import CYCLES  # noqa: E402

KEY = ("robot", "scene", "algorithm", "variant", "scalar")
ERRORS = ("states", "error", "error_rms", "error_torque", "error_certified")
COSTS = ("instructions_min", *CYCLES, "flash_bytes", "ram_bytes", "stack_bytes")
FIELDS = ("subject", "robot", "scalar", "variant", "board", "error", "work", "unit_of_work", "pareto", "job", "scene", "algorithm", "form",
          *ERRORS[:1], *ERRORS[2:], "instructions", *COSTS)
SCENES = {"sine_cosines": "given sine-cosine pairs", "full_parameters": "full parameters", "base_parameters": "base parameters",
          "elastic": "12 Hz"}
SUBJECTS = {"torque_by_separation": "separation"}


def key(row):
    return tuple(row[name] for name in KEY)


def subject_of(algorithm):
    """The kernel, whatever its route."""
    return SUBJECTS.get(algorithm, routes.job_of(algorithm))


def job_of(row):
    """What is interchangeable: the closed form and separation compute what inverse dynamics computes. With sine-cosine pairs
    from the caller it is a smaller job."""
    subject = subject_of(row["algorithm"])
    job = "inverse_dynamics" if subject in ("closed_form", "separation") else subject
    return job + "_of_pairs" if row["scene"] == "sine_cosines" else job


def variant_of(row):
    route = routes.route_of(row["algorithm"])
    parts = [route.replace("_", " ")] if route else []
    parts += [SCENES[row["scene"]]] if row["scene"] != "bare" else []
    return ", ".join(parts + [row["variant"]])


def derivatives(errors):
    """The errors of derivatives, a row per block."""
    names = ("robot", "algorithm", "variant", "scalar", "states")
    return [{**{name: row[name] for name in names}, "block": block, **figures}
            for row in errors for block, figures in row.get("blocks", {}).items()]


def joined(errors, sizes):
    """Three rows a kernel and board: its work in instructions, in microseconds and in bytes (flash, static RAM and stack). A kernel that no
    board was measured for has none."""
    known = {key(error): error for error in errors}
    rows = []
    for size in sizes:
        error = known.get(key(size))
        if error is None or size["contract"] != "off":
            continue
        both = {**{name: error[name] for name in ERRORS if name in error},
                **{name: size[name] for name in ("instructions", *COSTS) if name in size}}
        names = {"subject": subject_of(size["algorithm"]), "robot": size["robot"], "scalar": size["scalar"], "variant": variant_of(size),
                 "board": size["board"], "job": job_of(size), "scene": size["scene"], "algorithm": size["algorithm"],
                 "form": size["variant"]}
        total = size["flash_bytes"] + size["ram_bytes"] + size["stack_bytes"]
        for unit, work in (("instructions", size["instructions"]), ("microseconds", size["microseconds"]), ("bytes", total)):
            row = {**names, **both, "work": work, "unit_of_work": unit}
            rows.append({name: row[name] for name in FIELDS if name in row})
    pareto.mark(rows, lambda row: (row["job"], row["robot"], row["board"], row["unit_of_work"]))
    return [{name: row[name] for name in FIELDS if name in row} for row in rows]
