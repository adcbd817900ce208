"""The report as one HTML page that needs no other file: pictures inlined, every row in a table with filters."""

import base64
import html
import json
import pathlib

NAMES = ("subject", "robot", "board", "scalar", "variant", "unit_of_work")
TITLES = {"work_precision": "Inverse dynamics: error against time", "work_precision_bytes": "Inverse dynamics: error against bytes",
          "work_precision_forward": "Forward dynamics: error against time",
          "work_precision_two_rate": "Feed-forward at two rates: error against how often its terms are refreshed",
          "work_precision_simulation": "Simulation: global error against work"}
TEMPLATE = pathlib.Path(__file__).with_name("page.html")


def identity(row):
    """The same kernel on the same board, whatever the unit of work."""
    return tuple(row[name] for name in ("board", "robot", "algorithm", "scene", "form", "scalar"))


def picture(path):
    data = base64.b64encode(path.read_bytes()).decode("ascii")
    title = html.escape(TITLES.get(path.stem, path.stem.replace("_", " ")))
    return f'<figure><figcaption>{title}</figcaption><img alt="{title}" src="data:image/png;base64,{data}"></figure>'


def provenance(made):
    if not made:
        return ""
    flags = "".join(f"<li>{html.escape(board)}: <code>{html.escape(of)}</code></li>" for board, of in made["flags"].items())
    return f"<p>Measured in QEMU at commit <code>{html.escape(made['commit'])}</code> with {html.escape(made['compiler'])}.</p><ul>{flags}</ul>"


def compact(rows):
    """Rows as lists, which is a third of the bytes."""
    fields = [*NAMES, "error", "error_rms", "error_torque", "work", "cycles", "cycles_kind", "pareto"]
    known = lambda row, name: None if name == "error" and row.get("diverged") else row.get(name)
    value = lambda row, name: float(f"{row[name]:.3g}") if isinstance(known(row, name), float) else known(row, name)
    return {"fields": fields, "rows": [[value(row, name) for name in fields] for row in rows]}


def stability_table(rows):
    """Every scenario's worst."""
    if not rows:
        return ""
    fields = [name for name in ("scenario", "scalar", "route", "forward_error", "backward_error", "gate", "pass", "status") if name in rows[0]]
    cell = lambda value: f"{value:.1e}" if isinstance(value, float) else "" if value is None else html.escape(str(value))
    lines = "".join("<tr>" + "".join(f"<td>{cell(row.get(name))}</td>" for name in fields) + "</tr>" for row in rows)
    head = "".join(f"<th>{name.replace('_', ' ')}</th>" for name in fields)
    return f"<h2>Stability</h2><details><summary>{len(rows)} rows</summary><table><tr>{head}</tr>{lines}</table></details>"


def write(path, rows, stability, pictures, made):
    text = TEMPLATE.read_text(encoding="utf-8")
    parts = {"PICTURES": "\n".join(map(picture, pictures)), "STABILITY": stability_table(stability), "PROVENANCE": provenance(made),
             "DATA": json.dumps(compact(rows), separators=(",", ":")).replace("</", "<\\/")}
    for name, part in parts.items():
        text = text.replace(f"<!-- {name} -->" if name != "DATA" else "/* DATA */", part)
    pathlib.Path(path).write_text(text, encoding="utf-8")
