"""Cells that are measured: files of build/gallery, and the rows of doc/data/gallery.json, so that none is measured twice."""

import json
import os
import pathlib
import subprocess

from catalogue import HOST, ROOT, sources

FOLDER = pathlib.Path(os.environ.get("AXIAL_GALLERY", ROOT / "build/gallery"))
COMMITTED = ROOT / "doc/data/gallery.json"
OF_HOST = ("joints", "error_commit", "error_sources")  # of any row
ERRORS = ("error", "error_torque", "error_certified")  # of a row with figures
SAME_TORQUE = {"feedforward": "inverse_dynamics"}  # the safe loop answers that torque, where it is inside the limits


def place_of(cell):
    return FOLDER / f"{cell.robot.key}-{cell.number}-{cell.place}.json"


def commit():
    return subprocess.run([ROOT / "host_sim/tools/system/commit.sh"], check=True, capture_output=True, text=True).stdout.strip()


def keep(cell, rows):
    """Written whole or not at all: an interrupted run goes on behind the last cell."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    own = {"error_commit": commit(), "error_sources": sources(cell)} if cell.place == HOST else {"commit": commit(), "sources": sources(cell)}
    path = place_of(cell)
    path.with_suffix(".new").write_text(json.dumps([{**row, **own} for row in rows], indent=1) + "\n", encoding="utf-8")
    path.with_suffix(".new").rename(path)


class Store:
    def __init__(self, committed=COMMITTED):
        rows = json.loads(committed.read_text(encoding="utf-8")) if committed.is_file() else []
        self._committed = {}
        for row in rows:
            self._committed.setdefault((row["robot"], row["number"], row["board"]), []).append(row)
            self._committed.setdefault((row["robot"], row["number"], HOST), []).append(row)

    def rows(self, cell):
        """What is known of a cell, measured from these sources or from others; nothing where it never was."""
        path = place_of(cell)
        if path.is_file():
            return json.loads(path.read_text(encoding="utf-8"))
        return self._committed.get((cell.robot.key, cell.number, cell.place), [])

    def is_current(self, cell):
        """Whether it need not be measured again."""
        key = "error_sources" if cell.place == HOST else "sources"
        rows = self.rows(cell)
        return bool(rows) and all(row.get(key) == sources(cell) for row in rows)

    def joined(self, cell):
        """A board's rows, with what the host says of them; a header may have moved since."""
        errors = {row["algorithm"]: row for row in self.rows(cell._replace(place=HOST))}
        return [{**with_errors(row, errors), "header": cell.robot.header} for row in self.rows(cell)]


def with_errors(row, errors):
    found = errors.get(SAME_TORQUE.get(row["algorithm"], row["algorithm"]), {})
    names = OF_HOST if "why" in row else (*OF_HOST, *ERRORS)
    return {**row, **{name: found[name] for name in names if name in found}}
