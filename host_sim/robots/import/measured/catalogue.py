"""Imports every description of tests/data/descriptions and writes what doc/measurements/imported.md shows.

usage: catalogue.py PROGRAM DESCRIPTIONS DATA_FOLDER DOCUMENT

PROGRAM is the importer; writes DATA_FOLDER/import.json (its --json of each file) and the marked table of DOCUMENT.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tools/output"))
from document import fill, markdown  # noqa: E402


def imported(program, folder, entry, scratch):
    options = [f"--{end}={entry[end]}" for end in ("root", "tip") if end in entry]
    options += ["--as-published"] if entry.get("as_published") else []
    run = subprocess.run([program, folder / entry["file"], "-o", scratch / "robot.hpp", "--json", scratch / "robot.json", *options],
                         capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(run.stderr)
    row = json.loads((scratch / "robot.json").read_text(encoding="utf-8"))
    keep = ("joints", "masses", "states", "seed", "pose_error", "torque_error", "mass_matrix_error")
    return {"file": entry["file"], **{key: row[key] for key in keep}, "warnings": len(row["warnings"]),
            "source": entry.get("source", row["source"])}


def table(rows):
    number = "{:.1e}".format
    return markdown(["description", "joints", "frames and tool", "torques", "mass matrix", "warnings", "source"],
                    [[row["file"], str(len(row["joints"])), number(row["pose_error"]),
                      number(row["torque_error"]) if row["masses"] else "no masses",
                      number(row["mass_matrix_error"]) if row["masses"] else "no masses", str(row["warnings"]),
                      row["source"]] for row in rows])


def main(program, folder, data, document):
    folder = pathlib.Path(folder)
    entries = json.loads((folder / "catalogue.json").read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as scratch:
        rows = [imported(program, folder, entry, pathlib.Path(scratch)) for entry in entries]
    (pathlib.Path(data) / "import.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    commit = subprocess.run([pathlib.Path(__file__).resolve().parents[3] / "tools/system/commit.sh"], check=True, capture_output=True, text=True).stdout.strip()
    fill(document, lambda name: f"Imported at commit `{commit}`.\n" if name == "import_provenance" else table(rows))


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
