"""Imports the public files of tests/import/FORMAT/public.json and writes what doc/measurements/FORMAT.md shows.

usage: public.py FORMAT PROGRAM ENGINE FOLDER DATA_FOLDER DOCUMENT

FORMAT is mjcf or sdf, PROGRAM the importer, ENGINE the folder of the package mujoco-js or the program dart_engine. FOLDER has copies of the repositories,
as OWNER+NAME; meshes need not be there.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[4]
sys.path.insert(0, str(ROOT / "host_sim/tools/output"))
from document import fill, markdown  # noqa: E402


def imported(program, engine, folder, entry, scratch):
    file = pathlib.Path(folder) / entry["repository"].replace("/", "+") / entry["file"]
    options = [f"--{end}={entry[end]}" for end in ("root", "tip") if end in entry]
    run = subprocess.run([program, file, "--engine", engine, "-o", scratch / "robot.hpp", "--json", scratch / "robot.json", "--as-published", *options],
                         capture_output=True, text=True)
    if run.returncode != 0:
        said = [line for line in run.stderr.splitlines() if line.startswith("import: ") and "warning" not in line][-1]
        return {**entry, "refused": said.removeprefix("import: ").replace(f"{file.parent}/", "")}
    row = json.loads((scratch / "robot.json").read_text(encoding="utf-8"))
    if not row["engine"]["name"]:
        sys.exit(f"{file}: its engine was not asked: {row['engine']['why_not']}")
    keep = ("pose_error", "torque_error", "mass_matrix_error", "engine")
    return {**entry, "joints": len(row["joints"]), **{key: row[key] for key in keep}, "warnings": len(row["warnings"])}


def options_of(row):
    return "".join(f" --{end} {row[end]}" for end in ("root", "tip") if end in row)


def compared(rows):
    number = "{:.1e}".format
    return markdown(["robot", "joints", "poses", "torques", "mass matrix", "bodies", "bound", "file"],
                    [[row["robot"], str(row["joints"]), *(number(row["engine"][key]) for key in ("pose", "torque", "mass_matrix", "body", "bound")),
                      f"{row['repository']}, {row['file']}{options_of(row)}"] for row in rows if "refused" not in row])


def refused(rows):
    return markdown(["robot", "what is said", "repository"],
                    [[row["robot"], row["refused"].split("; ")[0], row["repository"]] for row in rows if "refused" in row], 3)


def repositories(rows):
    return markdown(["repository", "commit"], sorted({(row["repository"], f"`{row['commit'][:12]}`") for row in rows}), 2)


def main(form, program, engine, folder, data, document):
    entries = json.loads((ROOT / f"tests/import/{form}/public.json").read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as scratch:
        rows = [imported(program, engine, folder, entry, pathlib.Path(scratch)) for entry in entries]
    commit = subprocess.run([ROOT / "host_sim/tools/system/commit.sh"], check=True, capture_output=True, text=True).stdout.strip()
    (pathlib.Path(data) / f"{form}.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    tables = {f"{form}_provenance": f"Imported at commit `{commit}`: {sum('refused' not in row for row in rows)} of {len(rows)} files.\n",
              form: compared(rows), f"{form}_refused": refused(rows), f"{form}_repositories": repositories(rows)}
    fill(document, tables.get)


if __name__ == "__main__":
    if len(sys.argv) != 7:
        sys.exit(__doc__)
    main(*sys.argv[1:])
