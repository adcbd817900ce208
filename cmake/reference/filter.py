"""A header as Doxygen should see it, line by line where it was: reads the file named on the command line, writes to standard output.

- The comment at a header's top is the file's.
- What a header declares belongs to the module of its folder.
- One comment for members that are declared together, `T x{}, y{};  ///< m`, is the comment of each.
- Lines of calls/registry.hpp are the types and values that algorithm.hpp makes of them.
- Deduction guides say nothing that their template does not.
"""

import pathlib
import re
import sys

ROOT = "include/axial/"
DECLARATION = re.compile(r"^( *)((?:static |inline |constexpr |const |mutable |enum )*[\w:]+(?:<.*>)?(?: const)?[&*]? )(\w.*);( *///< (.*))?$")
NAME = re.compile(r"^\w+(\[.*\])*( = .+|\{.*\})?$")


def module(path):
    """The name of a header's module: its folder under axial/, or `robots`."""
    if ROOT not in path:
        return pathlib.Path(path).parent.name
    folder = pathlib.PurePosixPath(path[path.rindex(ROOT) + len(ROOT):]).parent
    return "_".join(folder.parts) or "axial"


def split(names):
    """`a{1, 2}, b[2]` at the commas that no bracket holds."""
    depth, parts = 0, [""]
    for letter in names:
        depth += letter in "([{<"
        depth -= letter in ")]}>"
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def comment_before(lines, at):
    """The `///` block that ends on the line before; empty lines take its place."""
    first = at
    while first > 0 and lines[first - 1].lstrip().startswith("/// "):
        first -= 1
    text = " ".join(line.lstrip()[4:] for line in lines[first:at])
    lines[first:at] = [""] * (at - first)
    return text


def apart(lines):
    """Declarations of several members, with their comment, as one each."""
    for i, line in enumerate(lines):
        joined, used = line, 1
        while re.match(r"^ +(static constexpr [^;]*|[\w:<> ]+ [^();]*),$", joined) and i + used < len(lines) and used < 4:
            joined, used = joined + " " + lines[i + used].strip(), used + 1
        found = DECLARATION.match(joined)
        if not found or found[2].startswith(("using ", "return ", "typedef ")):
            continue
        names = split(found[3])
        if len(names) < 2 or not all(NAME.match(name) for name in names):
            continue
        text = found[5]
        while text and i + used < len(lines) and lines[i + used].lstrip().startswith("///< "):
            text, used = text + " " + lines[i + used].lstrip()[5:], used + 1
        text = text or comment_before(lines, i)
        note = f"/** {text} */ " if text else ""
        lines[i:i + used] = ["".join(f"{note}{found[2]}{name}; " for name in names)] + [""] * (used - 1)


def headline(lines):
    """The comment at the top, one line further down: `\\file` stands alone."""
    end = next((i for i, line in enumerate(lines) if not line.startswith("//")), 0)
    if end > 0 and lines[end].startswith("#pragma once"):
        lines[:end + 1] = ["/** \\file"] + [line[2:].replace("<", "\\<") for line in lines[:end]]
        lines[end] += " */"


def grouped(lines, name):
    """The outermost namespace as part of a module."""
    opened = None
    for i, line in enumerate(lines):
        if opened is None and re.match(r"^namespace [\w:]+ \{$", line):
            opened = line[:-2]
            lines[i] += f" /** \\addtogroup {name} */ /**@{{*/"
        elif opened and line == f"}}  // {opened}":
            lines[i] = f"/**@}}*/ {line}"
            opened = None


def without_guides(lines):
    for i, line in enumerate(lines):
        if re.match(r"^ *(\w+)\(.*\) -> \1<.*>;$", line) and lines[i - 1].lstrip().startswith("template <"):
            lines[i - 1:i + 1] = ["", ""]


def algorithms_as_values(path, lines):
    """A type and a value of each line of the list, in the place of the macro that makes them."""
    registry = pathlib.Path(path).parent / "calls/registry.hpp"
    for i, line in enumerate(lines):
        listed = re.match(r"^(AXIAL_ALGORITHMS\w*)\(AXIAL_AS_A_VALUE\)$", line)
        if listed:
            text = registry.read_text(encoding="utf-8")
            rows = re.search(rf"#define {listed[1]}\(ROW\)((?:.*\\\n)*.*)", text)[1]
            if "OVER_MODELS(ROW)" in rows:
                rows += re.search(r"#define AXIAL_ALGORITHMS_OVER_MODELS\(ROW\)((?:.*\\\n)*.*)", text)[1]
            lines[i] = " ".join(
                f'/** axial::{function}(). */ struct {name} {{ static constexpr const char* name = "{value}"; /**< in files, tables and JSON */ '
                "template <class S, class... Given> static constexpr auto run(const Given&... given); /**< Runs it for the scene S. */ }; "
                f"inline constexpr {name} {value}; /**< axial::{function}(), as an argument. */"
                for function, name, value in re.findall(r"ROW\((\w+), \d, \w+, \w+,[\s\\]+(\w+),[\s\\]+(\w+)\)", rows))


def main():
    path = sys.argv[1]
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    headline(lines)
    without_guides(lines)
    apart(lines)
    if path.endswith("axial/algorithm.hpp"):
        algorithms_as_values(path, lines)
    grouped(lines, module(path))
    sys.stdout.write("\n".join(lines))


main()
