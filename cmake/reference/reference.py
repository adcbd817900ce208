#!/usr/bin/python3
"""The API reference: public headers and documents as browsable pages, and what of the headers lacks its comment.

usage: reference.py [--output FOLDER] [--json FILE]     writes pages, by default into output/reference
       reference.py --check [HEADER_FOLDER]...          writes none; by default of the library's and the robots' headers
Ends with 1 where a public name has no comment or a comment of a header is malformed, and lists them.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
HEADERS = [ROOT / "firmware/include", ROOT / "robots"]
GUIDES = [ROOT / "README.md", ROOT / "doc/guides", ROOT / "doc/measurements", ROOT / "hal/README.md", ROOT / "host_sim/README.md", ROOT / "firmware/README.md"]
WARNING = re.compile(r"<?([^:>]+\.h(?:pp)?)>?:(\d+): warning: (.*)")
UNDOCUMENTED = re.compile(r"(?:Member|Compound) (.*) is not documented\.")


def fail(message):
    sys.exit(f"axial: {message}")


def arguments():
    parser = argparse.ArgumentParser(prog="./axial reference", allow_abbrev=False, description="The API reference.")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/reference", help="where the pages go; default output/reference")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="what was found, as an array of objects")
    parser.add_argument("--check", action="store_true", help="write no pages")
    parser.add_argument("headers", nargs="*", type=pathlib.Path, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.headers and not given.check:
        parser.error(f"unexpected argument '{given.headers[0]}'")
    return given


def commit():
    shown = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True, check=False)
    return shown.stdout.strip()


def doxygen(inputs, folder, settings=""):
    """Runs it over `inputs` into `folder`; every line that it complains with."""
    environment = dict(os.environ, AXIAL_ROOT=str(ROOT), AXIAL_REFERENCE=str(folder), AXIAL_COMMIT=commit(),
                       AXIAL_INPUT=" ".join(f'"{path}"' for path in inputs))
    try:
        done = subprocess.run(["doxygen", "-"], input=f"@INCLUDE = {HERE / 'Doxyfile'}\n{settings}", cwd=ROOT, env=environment,
                              capture_output=True, text=True, check=False)
    except FileNotFoundError:
        fail("doxygen is not installed; ./axial reference installs it on Debian, elsewhere please install it by hand")
    if done.returncode != 0:
        fail(f"doxygen ended with status {done.returncode}: {done.stderr.strip()[-2000:]}")
    return done.stderr.splitlines()


def findings(lines, headers):
    """What is wrong with comments of `headers`, each once, in the order of files and lines."""
    found = {}
    for line in lines:
        match = WARNING.match(line)
        if match and any(pathlib.Path(match[1]).is_relative_to(folder) for folder in headers):
            name = UNDOCUMENTED.match(match[3])
            found[match[1], int(match[2]), match[3]] = name[1] if name else None
    return [{"file": os.path.relpath(file, ROOT), "line": line, "name": name, "message": message}
            for (file, line, message), name in sorted(found.items())]


def empty_types(folders):
    """Types without a member, of which Doxygen does not say that they have no comment; in the form of findings()."""
    for path in sorted(each for folder in folders for each in folder.rglob("*.hpp") if "/robots/models/" not in str(each)):
        above, depth, hidden = "", 0, None  # the last line that is no template's; braces; those outside a namespace detail
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if hidden is None and re.match(r"namespace ([\w:]+::)?detail \{", line):
                hidden = depth
            depth += line.count("{") - line.count("}")
            if hidden is not None and depth <= hidden:
                hidden = None
            name = re.match(r"\s*(?:struct|class) (\w+)\b(?!<)[^;]*\{\};", line)
            if name and hidden is None and "///<" not in line and not above.startswith("///"):
                yield {"file": os.path.relpath(path, ROOT), "line": number, "name": name[1], "message": "no comment"}
            if not line.lstrip().startswith("template") and not (name and above.startswith("///@{")):
                above = line.strip()


def report(found):
    for each in found:
        print(f"{each['file']}:{each['line']}: " + (f"{each['name']} has no comment" if each["name"] else each["message"]),
              file=sys.stderr)
    if found:
        fail(f"{len(found)} comments to write or mend: a /// line before each name, or ///< behind it")


def write_json(path, found):
    try:
        path.write_text(json.dumps(found, indent=1) + "\n")
    except OSError as error:
        fail(f"{path}: {error.strerror}")


def check(headers):
    for folder in headers:
        if not folder.is_dir():
            fail(f"{folder}: no such folder")
    with tempfile.TemporaryDirectory() as folder:
        lines = doxygen([*headers, HERE / "modules.dox"], folder, "GENERATE_HTML = NO\nGENERATE_XML = YES\nFILE_PATTERNS = *.hpp *.h *.dox\n")
    return findings(lines, headers) + list(empty_types(headers))


def write_pages(output):
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        fail(f"{output}: {error.strerror}")
    print("axial: reading headers and documents, some 10 s", flush=True)
    lines = doxygen([*HEADERS, HERE / "modules.dox", *GUIDES], output.resolve())
    print(f"axial: {output / 'index.html'}")
    return findings(lines, HEADERS) + list(empty_types(HEADERS))


def main():
    given = arguments()
    found = check([folder.resolve() for folder in given.headers] or HEADERS) if given.check else write_pages(given.output)
    if given.json:
        write_json(given.json, found)
    report(found)


main()
