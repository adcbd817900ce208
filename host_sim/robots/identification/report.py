"""What identify.py says: text, rows of JSON, lines of the header's comment."""

import pathlib

import numpy as np

import base_parameters
import least_squares

SMALL = 0.01  # of the largest parameter of a kind: smaller ones count as this large
SHOWN = 60  # characters of a combination


def identified(found, i):
    """Whether a base parameter's standard deviation is a small part of it, of the prior, or of a hundredth of its kind's largest."""
    alike = [k for k, column in enumerate(found.columns) if unit_kind(found.robot.kinds[column]) == unit_kind(found.robot.kinds[found.columns[i]])]
    largest = np.abs(found.fit.values[alike]).max()
    return found.fit.deviations[i] <= least_squares.POOR * max(abs(found.fit.values[i]), abs(found.prior[i]), SMALL * largest)


def unit_kind(kind):
    return {"mx": "first moment", "my": "first moment", "mz": "first moment", "rotor": "inertia"}.get(kind, "inertia" if kind[0] == "I" else kind)


def combination(found, i):
    return base_parameters.expression(found.base.combinations[i], [found.robot.names[k] for k in found.free])


def rows(found, judged):
    return _parameter_rows(found) + _standard_rows(found) + _torque_rows(found, judged) + [_fit_row(found)]


def _parameter_rows(found):
    fit = found.fit
    return [{"kind": "base", "robot": found.robot.name, "parameter": combination(found, i), "value": float(fit.values[i]),
             "prior": float(found.prior[i]), "consistent": float(found.consistent.base[i]), "deviation": float(fit.deviations[i]),
             "confidence_95": float(fit.intervals[i]), "identified": bool(identified(found, i)),
             "combination": {found.robot.names[k]: float(c) for k, c in zip(found.free, found.base.combinations[i]) if c != 0.0}}
            for i in range(len(found.base))]


def _standard_rows(found):
    without = {found.robot.names[found.free[k]] for k in found.base.without_effect}
    return [{"kind": "standard", "robot": found.robot.name, "parameter": name, "value": float(value), "prior": float(prior),
             "has_effect": name not in without}
            for name, value, prior in zip(found.robot.names, found.consistent.standard, found.robot.prior)]


def _torque_rows(found, judged):
    result = []
    for log, equations in judged.items():
        size, errors = found.errors(equations)
        for joint in range(len(found.robot)):
            result.append({"kind": "torque", "robot": found.robot.name, "log": str(log), "joint": joint + 1, "unit": found.robot.unit(joint),
                           "rms": float(size[joint]), **{f"error_{name}": float(each[joint]) for name, each in errors.items()}})
    return result


def _fit_row(found):
    fit = found.fit
    return {"kind": "fit", "robot": found.robot.name, "rows": fit.rows, "parameters": len(found.base), "cutoff_Hz": found.smoother.cutoff,
            "rate_Hz": found.smoother.rate, "condition": float(fit.condition), "condition_scaled": float(fit.condition_scaled),
            "residual": float(found.residuals().max()), "consistency_cost": found.consistent.cost, "rank_gap": [float(value) for value in found.base.gap]}


def text(found, judged, suspicions=()):
    """suspicions: sentences of what may be wrong with the log."""
    return "\n".join([*_heading(found), "", *_parameters(found), "", *_torques(found, judged), *_notes(found, suspicions)])


def _heading(found):
    fit, smoother = found.fit, found.smoother
    smoothing = f"smoothed to {smoother.cutoff:g} Hz, zero phase" if smoother.cutoff else "not smoothed"
    return [f"{found.robot.name}: {len(found.base)} base parameters of {len(found.free)} standard ones "
            f"(diagonal of R at the rank: {found.base.gap[0]:.1g}, then {found.base.gap[1]:.1g})",
            f"{fit.rows} equations; {smoother.rate:.4g} Hz, {smoothing}",
            f"condition of the weighted regressor {fit.condition:.3g}; with columns of one length {fit.condition_scaled:.3g}"]


def _parameters(found):
    fit = found.fit
    lines = [f"{'base parameter':<{SHOWN}} {'prior':>11} {'value':>11} {'+- 95 %':>9} {'dev., %':>8}"]
    for i in range(len(found.base)):
        name = combination(found, i)
        name = name if len(name) <= SHOWN else name[:SHOWN - 3] + "..."
        relative = 100 * fit.deviations[i] / max(abs(fit.values[i]), 1e-300)
        mark = "" if identified(found, i) else "  not identified"
        lines.append(f"{name:<{SHOWN}} {found.prior[i]:>11.4g} {fit.values[i]:>11.4g} {fit.intervals[i]:>9.2g} {relative:>8.2g}{mark}")
    return lines


def _torques(found, judged):
    lines = ["RMS of predicted less measured torque, % of the measured torque's RMS"]
    for log, equations in judged.items():
        size, errors = found.errors(equations)
        lines.append(f"{str(log)[-40:]:<40} {'RMS':>12} {'prior':>9} {'base':>9} {'identified':>11}")
        for joint in range(len(found.robot)):
            cells = [f"{100 * errors[name][joint]:.3g}" for name in ("prior", "base", "identified")]
            lines.append(f"  {found.robot.noun} {joint + 1:<32} {size[joint]:>8.3g} {found.robot.unit(joint):<3} {cells[0]:>9} {cells[1]:>9} {cells[2]:>11}")
    return lines


def _notes(found, suspicions):
    notes = [*found.log.notes, *suspicions]
    poor = [i for i in range(len(found.base)) if not identified(found, i)]
    if poor:
        notes.append(f"{len(poor)} base parameters are not identified by this motion (deviation above {100 * least_squares.POOR:g} % of the "
                     "value and of the prior): marked above; in the header they stay near the prior")
    without = [found.robot.names[found.free[k]] for k in found.base.without_effect]
    if without:
        notes.append("no torque depends on " + ", ".join(without) + ": as the prior has them, made consistent")
    for joint, (count, first) in enumerate(found.fit.outliers):
        if count:
            notes.append(f"{found.robot.noun} {joint + 1}: {count} rows are beyond {least_squares.OUTLIER:g} standard deviations, the first at {first:.3f} s "
                         "(contact, saturation, stiction?); they were not left out")
    for link in found.consistent.changed_prior:
        notes.append(f"link {link + 1} of the prior is massless or not physically consistent; the nearest body stands for it")
    if found.consistent.cost > 4.0:
        notes.append(f"physical consistency costs {found.consistent.cost:.3g} squared standard deviations a parameter: the model or the log misses "
                     "something (wrong units, gear ratio, gravity, flexible joints?)")
    return ["", *("note: " + note for note in notes)] if notes else []


def header_content(found, name, judged):
    """Name and comment of the header. Only a log that the fit did not see verifies anything."""
    fitted, *others = judged.items()
    return {"name": name, "source": f"; inertial parameters and friction identified from {pathlib.Path(fitted[0]).name}",
            "notes": ["every link is physically consistent; what the data does not determine is near the description that it started from"],
            "rotors_fitted": "rotor" in {found.robot.kinds[k] for k in found.free},
            "fitted": _fitted(found, *fitted), "figures": [_predicted(found, *other) for other in others]}


def _fitted(found, log, equations):
    kinds = {found.robot.kinds[k] for k in found.free}
    sought = ["masses, centres of mass, inertias"] + ["rotors"] * ("rotor" in kinds) + ["friction"] * ("viscous" in kinds)
    kept = ["rotors"] * ("rotor" not in kinds) + ["friction"] * ("viscous" not in kinds)
    poor = [combination(found, i) for i in range(len(found.base)) if not identified(found, i)]
    lines = [f"{', '.join(sought)}: {len(found.base)} base parameters, of which this motion determines {len(found.base) - len(poor)}; "
             f"{found.fit.rows} equations, condition {found.fit.condition:.3g}", _predicted(found, log, equations)]
    lines += [f"not {', '.join(kept)}, which are as before"] if kept else []
    return lines + ([f"not determined, near what it started from: {'; '.join(poor)}"] if poor else [])


def _predicted(found, log, equations):
    each = ", ".join(f"{100 * error:.2g}" for error in found.residuals(equations))
    return f"RMS of predicted less measured torque of {pathlib.Path(log).name}, % of the measured torque's RMS, {found.robot.noun} by {found.robot.noun}: {each}"
