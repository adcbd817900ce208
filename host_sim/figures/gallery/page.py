"""The gallery as one HTML page that needs no other file: gallery.html with the data put in."""

import html
import json
import pathlib
import re
import sys

from catalogue import NUMBERS, ROOT

sys.path.insert(0, str(ROOT / "host_sim/figures/report"))
import snippet  # noqa: E402

TEMPLATE = pathlib.Path(__file__).with_name("gallery.html")
NAMES = ("robot", "board", "number", "algorithm")
FIGURES = ("microseconds", "instructions", "cycles", "flash_bytes", "ram_bytes", "stack_bytes", "error")
TITLES = {"inverse_dynamics": "torque", "gravity": "gravity", "forward_dynamics": "forward dynamics", "feedforward": "safe loop"}
HEADERS = {"float": "axial/axial.hpp", "fixed32": "axial/fixed.hpp"}
ROBOT = "ROBOT_TYPE"  # what the page replaces by the robot's type
DECLARED = {"q": "axial::Positions<Robot, T> q{};", "qd": "axial::Velocities<Robot, T> qd{};",
            "qdd": "axial::Accelerations<Robot, T> qdd{};", "tau": "axial::EffortsOf<Scene, T> tau{};",
            "state": "axial::FeedforwardState<Scene, T> state{};  // the last safe torque, kept between calls"}


def code(number, algorithm):
    """What one writes behind the includes; its scene is the one that was measured."""
    using, calling = snippet.lines({"robot": "", "type": ROBOT, "scene": "bare", "algorithm": algorithm, "form": "unrolled", "scalar": number})
    arguments = re.search(r"\((.*)\)", calling)[1].split(", ")
    return [using, "using Robot = axial::robot_of<Scene>;", f"using T = {snippet.NUMBERS[number][0]};", *(DECLARED[name] for name in arguments), calling]


def include(header):
    return f"<{header}>" if header.startswith("robots/") else f'"{header}"'


def robots_of(rows, robots):
    """Each robot that has a row: what it is, how it is included."""
    machines, found = {robot.name: robot.machine for robot in robots}, {}
    for row in rows:
        robot = found.setdefault(row["robot"], {"name": row["robot"], "machine": machines.get(row["robot"], row["robot"]), "joints": None,
                                                "type": snippet.robot_type(row["robot"]), "include": include(row["header"])})
        robot.update({name: row[name] for name in ("joints", "type") if name in row})
    return list(found.values())


def rounded(value):
    return float(f"{value:.4g}") if isinstance(value, float) else value


def data(rows, robots):
    fields = [*NAMES, *FIGURES, "cycles_kind", "why"]
    return {"titles": TITLES, "robots": robots_of(rows, robots), "fields": fields, "headers": HEADERS,
            "rows": [[rounded(row.get(name)) for name in fields] for row in rows],
            "code": {number: {algorithm: code(number, algorithm) for algorithm in TITLES} for number in NUMBERS}}


def provenance(made):
    boards = "".join(f"<li><b>{board}</b>: instructions by {html.escape(made['emulators'][board])}. {html.escape(says)} Flags: "
                     f"<code>{html.escape(made['flags'].get(board, 'not built here'))}</code></li>" for board, says in made["models"].items())
    commits = ", ".join(f"<code>{html.escape(commit)}</code> ({count} rows)" for commit, count in made["commits"].items())
    return f"<p>Measured at commit {commits or 'none yet'}, by {html.escape(made['compiler'])}.</p><ul>{boards}</ul>"


def write(path, rows, robots, made):
    parts = {"<!-- PROVENANCE -->": provenance(made), "/* DATA */": json.dumps(data(rows, robots), separators=(",", ":")).replace("</", "<\\/")}
    text = TEMPLATE.read_text(encoding="utf-8")
    for mark, part in parts.items():
        text = text.replace(mark, part)
    pathlib.Path(path).write_text(text, encoding="utf-8")
