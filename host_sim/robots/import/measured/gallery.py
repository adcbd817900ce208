"""Writes robots/gallery: a header of each machine of its gallery.json, by the importer, and the rows of its README.

usage: gallery.py PROGRAM ENGINE FOLDER [NAME...]

PROGRAM is the importer, ENGINE the folder of the package mujoco-js. FOLDER has copies of the repositories, as OWNER+NAME; meshes need not be there.
"""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[4]
GALLERY = ROOT / "robots/gallery"
sys.path.insert(0, str(ROOT / "host_sim/tools/output"))
from document import fill, markdown  # noqa: E402


def imported(program, engine, folder, entry):
    file = pathlib.Path(folder) / entry["repository"].replace("/", "+") / entry["file"]
    header = GALLERY / f"{entry['name']}.hpp"
    header.unlink(missing_ok=True)
    ends = [f"--{end}={entry[end]}" for end in ("root", "tip") if end in entry]
    run = subprocess.run([program, file, "--engine", engine, "--name", entry["name"], "-o", header, *ends, *entry.get("options", [])], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{entry['name']}: {run.stderr}")
    header.write_text(with_provenance(header.read_text(encoding="utf-8"), entry), encoding="utf-8")


def with_provenance(text, entry):
    """Whose numbers these are, before what the importer says of them."""
    lines = [f"// {entry['robot']}.", "//", f"// data:     {entry['repository']}, commit {entry['commit'][:12]},",
             f"//           {entry['file']};", f"//           {entry['licence']}; numbers alone are taken over",
             "// published: geometry, bodies, and limits, friction and rotors as far as that file has them",
             "// measured: nothing here; assumed: as the lines say that begin so"]
    text = "\n".join(lines) + "\n" + text.split("\n", 2)[2]
    text = re.sub(r"\n// yours:.*", "", text)
    text = re.sub(r"\n#ifndef AXIAL_ONE_HEADER.*?#endif\n#endif\n", "\n#include <axial/robot/chain.hpp>\n", text, flags=re.S)
    text = text.replace("\nstruct ", f"\n/// {entry['robot']}.\nstruct ", 1)
    text = re.sub(r"(const char\* name = .*;)", r"\1  ///< on the command line, in files and in JSON", text)
    return text.replace("  static constexpr auto chain", "  /// Its description; sources and assumptions stand at the top of the file.\n  static constexpr auto chain", 1)


def row(entry):
    text = (GALLERY / f"{entry['name']}.hpp").read_text(encoding="utf-8")
    kinds = re.findall(r"axial::(revolute|prismatic)\(\)", text)
    letters = "".join("R" if kind == "revolute" else "P" for kind in kinds)
    joints = re.sub(r"(.)\1+", lambda run: f"{len(run.group())}{run.group(1)}", letters)
    assumed = re.findall(r"^// assumed:  (.*?)(?=^// \w|^#)", text, re.M | re.S)
    said = "; ".join(re.sub(r":.*", "", " ".join(line.replace("\n//", " ").split())) for line in assumed)
    return [f"`{entry['name']}`", entry["robot"], joints, f"{entry['repository']}, `{entry['commit'][:12]}`", entry["licence"], said]


def main(program, engine, folder, *names):
    entries = json.loads((GALLERY / "gallery.json").read_text(encoding="utf-8"))
    for entry in entries:
        if not names or entry["name"] in names:
            imported(program, engine, folder, entry)
    head = ["name", "machine", "joints", "source, commit", "licence of the data", "assumed"]
    fill(GALLERY / "README.md", {"gallery": markdown(head, [row(entry) for entry in entries], len(head))}.get)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
