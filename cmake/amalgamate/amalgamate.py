#!/usr/bin/python3
"""Writes the library, and robots where asked, as one header: every #include <axial/...> and <robots/...> in its place.

The same sources give the same bytes. The file includes nothing but the compiler's own freestanding headers.
"""

import argparse
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = {"axial": ROOT / "firmware" / "include", "robots": ROOT}
ALWAYS = ["axial/axial.hpp", "axial/fixed.hpp", "axial/c_interface/export.hpp", "axial/fixed/c_interface/fixed_calls.hpp"]
OPTIONS = ("axial/options/begin.hpp", "axial/options/end.hpp")  # around each header's code; here, once around all of it
INCLUDE = re.compile(r"^\s*#\s*include\s*<([^>]+)>\s*(?://.*)?$")
OPENS = re.compile(r"^\s*#\s*if")
CLOSES = re.compile(r"^\s*#\s*endif")
ONCE = re.compile(r"^\s*#\s*pragma\s+once\s*$")
USERS = set()  # headers that the command line names by their files
LICENCES = ("LICENSE", "LICENSE.md", "LICENSE.txt", "COPYING")


class Wrong(Exception):
    pass


def place(name):
    """The file that #include <name> means; None for a header of the compiler's. A user's robot is named by its file."""
    if name in USERS:
        return pathlib.Path(name)
    folder = FOLDERS.get(name.split("/")[0])
    return folder / name if folder and "/" in name else None


class Text:
    """What was unfolded so far."""

    def __init__(self):
        self.lines, self.outside = [], set()
        self.seen = {}  # header: whether it stands under an #if

    def unfold(self, name, wanted_by, conditional=False):
        """A header in the place of the #include that is the first to ask for it."""
        if name in self.seen:
            if self.seen[name] and not conditional:
                raise Wrong(f"{wanted_by} needs {name}, which so far stands under an #if alone; include it before that #if")
            return
        path = place(name)
        if not path.is_file():
            raise Wrong(f"{wanted_by} asks for {name}, and there is no {path}")
        self.seen[name] = conditional
        self.lines.append(f"// ---- {path.name if name in USERS else name}")
        depth = 0
        for line in path.read_text().splitlines():
            depth += bool(OPENS.match(line)) - bool(CLOSES.match(line))
            self.add(line, name, conditional or (depth > 0 and path.suffix == ".hpp"))

    def add(self, line, name, conditional):
        include = INCLUDE.match(line)
        if include and include[1] in OPTIONS:
            return
        if include and place(include[1]):
            self.unfold(include[1], name, conditional)
        elif include:
            self.outside.add(include[1])
        elif not ONCE.match(line):
            self.lines.append(line)


def trimmed(lines):
    """Without blank lines at either end, and never two in a row: where includes stood there is one left."""
    result = []
    for line in lines:
        if line.strip() or (result and result[-1].strip()):
            result.append(line)
    while result and not result[-1].strip():
        result.pop()
    return result


def within_options(lines):
    """The lines, where every header that they include has been read, between what each of the headers stood between."""
    begin, end = (place(name).read_text().splitlines() for name in OPTIONS)
    return begin + [""] + lines + ["", *end]


def commit():
    try:
        done = subprocess.run([ROOT / "host_sim/tools/system/commit.sh"], capture_output=True, text=True, check=True)
        return done.stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown: made outside of a git repository"


def licence():
    for name in LICENCES:
        path = ROOT / name
        if path.is_file():
            return next(line.strip() for line in path.read_text().splitlines() if line.strip())
    return "the project's (its sources carry none of their own)"


def amalgamate(headers, revision):
    text = Text()
    for name in headers:
        text.unfold(name, "the command line")
    head = ["// axial in one header: rigid-body dynamics for microcontrollers, C++17.",
            f"// Licence: {licence()}.",
            f"// Commit: {revision}. Made by ./axial amalgamate from: {', '.join(pathlib.Path(name).name if name in USERS else name for name in headers)}.",
            "// Do not edit: change the sources and make it anew.",
            "#pragma once", "", "#define AXIAL_ONE_HEADER 1  // robots' headers include nothing more", ""]
    return "\n".join(head + [f"#include <{name}>" for name in sorted(text.outside)] + [""] + within_options(trimmed(text.lines))) + "\n"


def robots():
    return sorted(path.stem for path in (ROOT / "robots").glob("*.hpp"))


def arguments():
    parser = argparse.ArgumentParser(prog="./axial amalgamate", description=__doc__.split("\n")[0],
                                     formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
    parser.add_argument("-o", "--output", default="axial.hpp", metavar="FILE", help="default axial.hpp; - for standard output")
    parser.add_argument("--robot", action="append", default=[], metavar="NAME|HEADER",
                        help="also robots/NAME.hpp, or the robot of a header; may be given several times")
    parser.add_argument("--header", action="append", default=[], metavar="NAME",
                        help="also this header of the library, such as axial/simulation/motion.hpp")
    return parser.parse_args()


def main():
    options = arguments()
    USERS.update(name for name in options.robot if name not in robots() and pathlib.Path(name).is_file())
    for name in options.robot:
        if name not in robots() and name not in USERS:
            print(f"axial: no robot '{name}' in robots/ and no such header; there are: {', '.join(robots())}", file=sys.stderr)
            return 2
    for name in options.header:
        if not name.startswith("axial/") or not place(name).is_file():
            print(f"axial: no header '{name}'; name one of firmware/include, such as axial/simulation/motion.hpp",
                  file=sys.stderr)
            return 2
    headers = ALWAYS + options.header + [name if name in USERS else f"robots/{name}.hpp" for name in options.robot]
    try:
        text = amalgamate(headers, commit())
    except Wrong as error:
        print(f"axial: {error}", file=sys.stderr)
        return 1
    if options.output == "-":
        sys.stdout.write(text)
        return 0
    try:
        pathlib.Path(options.output).write_text(text)
    except OSError as error:
        print(f"axial: cannot write {options.output}: {error.strerror}; give another file with -o", file=sys.stderr)
        return 1
    print(f"axial: wrote {options.output}: {len(text.splitlines())} lines, {len(text.encode())} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
