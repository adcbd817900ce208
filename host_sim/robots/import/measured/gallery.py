"""Writes robots/gallery: a header of each machine of its gallery.json, by the importer, their list, and the tables and pictures of its README.md's.

usage: gallery.py PROGRAM ENGINE FOLDER [NAME...]
       gallery.py --pages

PROGRAM is the importer, beside it dart_engine; ENGINE the folder of the package mujoco-js. FOLDER has copies of the repositories, as OWNER+NAME, at
the commits that gallery.json names; meshes need not be there. --pages writes list, tables and pictures from the headers that stand there.
"""

import json
import pathlib
import re
import subprocess
import sys
import textwrap

import chains

ROOT = pathlib.Path(__file__).resolve().parents[4]
GALLERY = ROOT / "robots/gallery"
sys.path.insert(0, str(ROOT / "host_sim/tools/output"))
from document import filled, markdown  # noqa: E402


def entries():
    return json.loads((GALLERY / "gallery.json").read_text(encoding="utf-8"))


def room(entry):
    return pathlib.PurePath(entry["header"]).parent.name


def engine_of(file, program, engine):
    """What a format's own engine is asked by; a URDF has none."""
    return {".xml": ["--engine", engine], ".sdf": ["--engine", pathlib.Path(program).with_name("dart_engine")]}.get(pathlib.PurePath(file).suffix, [])


def imported(program, engine, folder, entry):
    file = pathlib.Path(folder) / entry["repository"].replace("/", "+") / entry["file"]
    header = ROOT / entry["header"]
    header.unlink(missing_ok=True)
    options = [f"--{end}={entry[end]}" for end in ("root", "tip") if end in entry] + engine_of(file, program, engine) + entry.get("options", [])
    run = subprocess.run([program, file, "--name", entry["name"], "-o", header, *options], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{entry['name']}: {run.stderr}")
    header.write_text(with_provenance(header.read_text(encoding="utf-8"), entry), encoding="utf-8")


def with_provenance(text, entry):
    """Whose numbers these are, before what the importer says of them."""
    lines = [f"// {entry['robot']}.", "//", f"// data:     {entry['repository']}, commit {entry['commit'][:12]},",
             f"//           {entry['file']};", f"//           {entry['licence']}; numbers alone are taken over",
             "// published: geometry, bodies, and limits, friction and rotors as far as that file has them",
             "// measured: nothing here; assumed: as the lines say that begin so"]
    lines += [f"// doubtful: {line}" if k == 0 else f"//           {line}" for k, line in enumerate(entry.get("doubtful", "").splitlines())]
    text = "\n".join(lines) + "\n" + text.split("\n", 2)[2]
    text = re.sub(r"\n// yours:.*", "", text)
    text = re.sub(r"\n#ifndef AXIAL_ONE_HEADER.*?#endif\n#endif\n", "\n#include <axial/robot/chain.hpp>\n", text, flags=re.S)
    text = text.replace("\nstruct ", f"\n/// {entry['robot']}.\nstruct ", 1)
    text = re.sub(r"(const char\* name = .*;)", r"\1  ///< on the command line, in files and in JSON", text)
    return text.replace("  static constexpr auto chain", "  /// Its description; sources and assumptions stand at the top of the file.\n  static constexpr auto chain", 1)


def text_of(entry):
    return (ROOT / entry["header"]).read_text(encoding="utf-8")


def joints(text):
    """As RRPR or 6R; with couplings, how many drives move them."""
    letters = "".join("R" if kind == "revolute" else "P" for kind in re.findall(r"axial::(revolute|prismatic)\(\)", text))
    said = re.sub(r"(.)\1+", lambda run: f"{len(run.group())}{run.group(1)}", letters)
    followers = len(re.findall(r"\.mimic\(", text))
    return f"{said}, {len(letters) - followers} drives" if followers else said


def row(entry):
    text = text_of(entry)
    assumed = re.findall(r"^// assumed:  (.*?)(?=^// \w|^#)", text, re.M | re.S)
    said = "; ".join(re.sub(r":.*", "", " ".join(line.replace("\n//", " ").split())) for line in assumed)
    doubtful = " ".join(entry.get("doubtful", "-").split())
    return [f"`{entry['name']}`", entry["robot"], joints(text), f"{entry['repository']}, `{entry['commit'][:12]}`", entry["licence"], said, doubtful]


def list_of(machines):
    """gallery.hpp, as clang-format has it."""
    struct = [re.search(r"^struct (\w+) \{", text_of(entry), re.M)[1] for entry in machines]
    text = "// The machines of this folder, as a list of types; gallery.py writes it from gallery.json.\n#pragma once\n\n"
    text += "".join(f"#include <{header}>\n" for header in sorted(entry["header"] for entry in machines)) + "#include <robots/robots.hpp>\n"
    begun = "using Gallery = List<"
    listed = textwrap.fill(", ".join(struct) + ">;", 120, initial_indent=begun, subsequent_indent=" " * len(begun))
    return text + f"\nnamespace robots {{\n\n/// Real machines, each made by `./axial import` from a public description.\n{listed}\n\n}}  // namespace robots\n"


def filled_page(folder, tables):
    page = folder / "README.md"
    return page, filled(page.read_text(encoding="utf-8"), tables.get)


def pages(machines):
    """What is written from the headers that stand there: files and their texts."""
    rooms = list(dict.fromkeys(room(entry) for entry in machines))
    head = ["name", "machine", "joints", "source, commit", "licence of the data", "assumed", "doubtful"]
    for name in rooms:
        inside = [entry for entry in machines if room(entry) == name]
        yield filled_page(GALLERY / name, {"machines": markdown(head, [row(entry) for entry in inside], len(head))})
        yield GALLERY / name / "chains.svg", chains.sheet({entry["name"]: chains.Chain(text_of(entry)) for entry in inside})
    names = [[f"[{name}]({name}/README.md)", ", ".join(f"`{entry['name']}`" for entry in machines if room(entry) == name)] for name in rooms]
    yield filled_page(GALLERY, {"rooms": markdown(["room", "machines"], names, 2)})
    yield GALLERY / "gallery.hpp", list_of(machines)


def main(program, engine=None, folder=None, *names):
    machines = entries()
    for entry in machines if folder is not None else []:
        if not names or entry["name"] in names:
            imported(program, engine, folder, entry)
    for path, text in pages(machines):
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:] != ["--pages"] and len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
