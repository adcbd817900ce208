#!/usr/bin/python3
"""Checks the structure of the tree: includes point one way and never in a circle, kernels know no number system, the
library stays freestanding and uses no name that macros of others take, answers are [[nodiscard]], folders explain
themselves, nothing is there that a program left.

usage: check.py ROOT
Prints each violation and exits 1 if there is one.
"""
import collections
import pathlib
import re
import subprocess
import sys

LIBRARY = "firmware/include/axial"
# A room may include itself and what stands in front of it.
KERNELS = ("scalar", "spatial", "robot", "scene", "links", "recursion", "base", "dynamics", "separation", "derivatives", "elastic", "transmissions", "tool")
LAYERS = {"options": set(), **{room: set(KERNELS[:i]) for i, room in enumerate(KERNELS)}}
LAYERS |= {
    "closed_form": LAYERS["recursion"],
    "control": set(KERNELS),
    "simulation": set(KERNELS),
    "calls": {*KERNELS, "control"},
    "batch": {*KERNELS, "control"},
    "c_interface": {*KERNELS, "control", "calls"},
    "fixed": {*KERNELS, "closed_form", "control", "simulation", "calls", "c_interface", "algorithm.hpp", "fixed.hpp"},
}
MOST_TESTS = 50  # files of a folder of tests: a screen; cases and data are rows of a list, not tests
LISTS = {"tests/compile_fail", "tests/data"}
MOST_HEADERS, LONGEST_PAGE = 20, 70  # of a folder; of its README.md, in lines
HOST_ROOMS = ("tools", "robots", "boards", "plants", "figures")  # of host_sim; each may include itself and what stands in front of it
# What users included before its header had a room of its own or stood in another: one line, which includes that header and which no other header includes.
OLD_PATHS = {
    "dynamics/elastic_damping.hpp": "elastic/elastic_damping.hpp",
    "dynamics/rotor_dynamics.hpp": "transmissions/rotor_dynamics.hpp",
    "dynamics/shared_drives.hpp": "transmissions/shared_drives.hpp",
    "dynamics/water.hpp": "base/water.hpp",
    "transmissions/elastic_damping.hpp": "elastic/elastic_damping.hpp",
    "links/driven_model.hpp": "transmissions/driven_model.hpp",
    "scalar/dual.hpp": "scalar/taylor.hpp",
}
PLUG_IN = "fixed"
NUMBERLESS = {"spatial", *KERNELS[KERNELS.index("links"):], "simulation"}
FIXED_WORDS = {"Stored", "Fixed32", "Fixed16"}
DECLARED = re.compile(r"^(?:struct|class) (\w+)|^using (\w+) =|^inline constexpr [\w:<>]+ (\w+)\b", re.MULTILINE)
INTRODUCED = re.compile(r"\b(?:struct|class|using)(?:\.\.\.)? (\w+)")  # template parameters and local names, too
C_HEADER = "axial/axial.h"  # what a C source sees; the C interface alone includes it
OPTIONAL = {"eigen.hpp": {"Eigen/Core"}}  # headers that no other header includes: what else they may include
FREESTANDING = {"cstddef", "cstdint", "limits", "type_traits", "utility"}
LANGUAGE = "axial/scalar/language.hpp"  # says of an older standard what is wrong
THE_END = "nothing more: see the error above"  # no file has that name: it ends the compiler
PAIR = ("axial/options/begin.hpp", "axial/options/end.hpp")  # around every header's own code
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)

TOP_LEVEL = {".clang-format", ".clang-tidy", ".editorconfig", ".gitignore", "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json",
             "CONTRIBUTING.md", "COPYING", "LICENSE", "LICENSE.md", "LICENSE.txt", "README.md", "axial"}
LARGEST = 2_000_000  # bytes of a file

# A line that compiles to something: neither blank, nor a comment, nor a directive or what one goes on with.
CODE = re.compile(r"^(?<!\\\n)(?!\s*(?://|#|$)).+", re.MULTILINE)

FOREIGN_MACROS = "tests/builds/foreign_macros.hpp"
MACRO = re.compile(r"^#define (\w+)(\(?)", re.MULTILINE)
DIRECTIVE = re.compile(r"^\s*#(?:.*\\\n)*.*", re.MULTILINE)

# Folders whose functions answer users; steps of kernels (AXIAL_INLINE) and namespaces of their own are not for users.
ANSWERING = ("", *KERNELS[KERNELS.index("dynamics"):], "batch", "calls", "closed_form", "control", "simulation")
VIEWS = {"transmissions/driven_links.hpp", "transmissions/driven_model.hpp"}  # whose members algorithms ask
USERS_NAMESPACES = (["axial"], ["axial", "closed_form"])
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{|^\}  // namespace", re.MULTILINE)
# A function at the top of a namespace, or a constexpr member: attribute, specifiers and what it returns; its name; the rest.
FUNCTION = re.compile(r"^(?P<before>(?:  (?=\[\[nodiscard\]\]|(?:static )?constexpr ))?[\w\[][\w\[\]:<>,&* .]*[\s&*])(?P<name>\w+)\((?P<rest>[^\n]*)", re.MULTILINE)
SPECIFIERS = {"static", "inline", "constexpr", "explicit"}  # alone before a name they are a constructor's
NOT_ANSWERS = {"AXIAL_INLINE", "void", "friend", "using", "return", "operator", "template", "struct", "class", "static_assert", "[[nodiscard]]"}


def includes(path):
    return INCLUDE.findall(path.read_text())


def check_library_header(path, layer):
    for name in includes(path):
        parts = name.split("/")
        if name == C_HEADER:
            if layer != "c_interface":
                yield f"{path}: only c_interface/ includes {name}"
        elif parts[0] == "axial":
            if "/".join(parts[1:]) in OLD_PATHS:
                yield f"{path}: {name} is an old path"
            if parts[1] in OPTIONAL:
                yield f"{path}: {name} is included where a user asks for it, never by the library"
            if layer is not None and name not in PAIR and parts[1] != layer and parts[1] not in LAYERS[layer]:
                yield f"{path}: {layer}/ must not include {name}"
        elif name not in FREESTANDING and name not in OPTIONAL.get(path.name, ()) and name != THE_END:
            yield f"{path}: the library must not include <{name}>"


def check_library(root):
    for path in sorted((root / LIBRARY).rglob("*.hpp")):
        parts = path.relative_to(root / LIBRARY).parts
        if "/".join(parts) not in OLD_PATHS:
            yield from check_library_header(path, parts[0] if len(parts) > 1 else None)
    yield from check_folder(root, f"{LIBRARY}/fixed/closed_form", r"axial/(fixed/)?(dynamics|limits|control)/", "closed forms never see dynamics")
    for path in sorted((root / LIBRARY).glob("*.hpp")):
        if path.stem != PLUG_IN and any(name.startswith(f"axial/{PLUG_IN}") for name in includes(path)):
            yield f"{path}: only {PLUG_IN}.hpp includes the plug-in"


def rooms(root):
    """{folder of the library: names of its headers}."""
    found = collections.defaultdict(list)
    for path in sorted((root / LIBRARY).rglob("*.hpp")):
        found[path.parent].append(path.name)
    return found


def check_rooms(root):
    """A folder of the library is a page of headers; an old path is one line."""
    for folder, headers in rooms(root).items():
        if len(headers) > MOST_HEADERS:
            yield f"{folder}: has {len(headers)} headers; {MOST_HEADERS} at most"
    for old, new in OLD_PATHS.items():
        path = root / LIBRARY / old
        if path.is_file() and (includes(path) != [f"axial/{new}"] or CODE.search(path.read_text())):
            yield f"{path}: an old path includes axial/{new} and nothing else"


def check_pages(root):
    """A folder's page says what is in it, what it may include and how to add one more."""
    for folder, headers in rooms(root).items():
        path = folder / "README.md"
        page = path.read_text() if path.is_file() else ""
        missing = [f"`{name}`" for name in headers if f"`{name}`" not in page]
        missing += [words for words in ("nclude", "To add ") if words not in page]
        if missing:
            yield f"{path}: says nothing of {', '.join(missing)}"
        if page.count("\n") > LONGEST_PAGE:
            yield f"{path}: has more than {LONGEST_PAGE} lines"


def check_options(root):
    """Whatever a header compiles stands between its one begin.hpp and its one end.hpp, and what it includes before them: nobody
    else's code, neither a standard header's nor a user's, is compiled with the library's options."""
    for path in sorted((root / LIBRARY).rglob("*.hpp")):
        if path.parent.name == "options":
            continue
        pieces = re.split("|".join(rf"^#include <{re.escape(name)}>$" for name in PAIR), path.read_text(), flags=re.MULTILINE)
        if CODE.search(pieces[0]):
            yield f"{path}: code in front of #include <{PAIR[0]}>"
        if len(pieces) == 1:
            continue
        found = tuple(name for name in includes(path) if name in PAIR)
        if found != PAIR:
            yield f"{path}: includes {', '.join(found)}; once {PAIR[0]} behind its other includes, once {PAIR[1]} as its last line"
        elif INCLUDE.search(pieces[1]) or pieces[2].strip():
            yield f"{path}: nothing is included behind {PAIR[0]}, and {PAIR[1]} is the last line"


def check_language(root):
    """What is included first leads to the header that refuses an older standard, before any of the compiler's or any code."""
    folder = root / LIBRARY.rpartition("/")[0]

    def leads_there(path, above=()):
        first = next((name for name in includes(path) if name not in PAIR), None)
        if first is None:
            return not CODE.search(path.read_text())
        if first == LANGUAGE or not first.startswith("axial/"):
            return first == LANGUAGE
        return folder / first in above or not (folder / first).is_file() or leads_there(folder / first, (*above, path))

    for path in sorted((root / LIBRARY).rglob("*.hpp")):
        if path != folder / LANGUAGE and not leads_there(path):
            yield f"{path}: includes <{LANGUAGE}> first, or a header that does"


def code_of(path):
    """A header without comments and without what it says to people."""
    return re.sub(r'//[^\n]*|"(?:[^"\\\n]|\\.)*"', "", path.read_text())


def declared_in(paths):
    return {name for path in paths for names in DECLARED.findall(code_of(path)) for name in names if name}


def check_number_systems(root):
    """Kernels know no number system: no room of theirs has a name that the plug-in alone declares, nor that of its words."""
    headers = list((root / LIBRARY).rglob("*.hpp"))
    folder = {path: path.relative_to(root / LIBRARY).parts[0] for path in headers}
    plugged_in = declared_in(path for path in headers if folder[path] == PLUG_IN)
    own = plugged_in - declared_in(path for path in headers if folder[path] != PLUG_IN) | FIXED_WORDS
    for path in sorted(path for path in headers if folder[path] in NUMBERLESS):
        code = code_of(path)
        for name in sorted(own & set(re.findall(r"\w+", code)) - set(INTRODUCED.findall(code))):
            yield f"{path}: {name} belongs to {PLUG_IN}/; kernels know no number system"


def check_foreign_names(root):
    """No header of C++ has a name that a macro of other people's headers takes away; tests/builds/macros_test.py has a compiler say so, too."""
    macros = (root / FOREIGN_MACROS).read_text()
    taken = {name: re.compile(rf"\b{name}\b" + (r"\s*\(" if arguments else "")) for name, arguments in MACRO.findall(macros)}
    for path in sorted((root / LIBRARY).rglob("*.hpp")):
        code = DIRECTIVE.sub("", code_of(path))
        yield from (f"{path}: {name} is a macro of other people's headers ({FOREIGN_MACROS})" for name, use in taken.items() if use.search(code))


def check_cycles(root):
    """No folder of the library includes, by however many others, itself; a header at the top counts as a folder."""
    above = {}
    for path in (root / LIBRARY).rglob("*.hpp"):
        name = path.relative_to(root / LIBRARY)
        if str(name) in OLD_PATHS:
            continue
        own = str(name.parent) if len(name.parts) > 1 else str(name)
        others = {(i.rpartition("/")[0] if "/" in i else i) for i in (n[6:] for n in includes(path) if n.startswith("axial/"))}
        above.setdefault(own, set()).update(others - {own})
    yield from circles(root / LIBRARY, above)


def circles(root, above):
    """Of {folder: what it includes} those that include themselves, by however many others."""
    for folder in sorted(above):
        seen, rest = set(), [folder]
        while rest:
            found = above.get(rest.pop(), set()) - seen
            seen |= found
            rest += found
        if folder in seen:
            yield f"{root / folder}: includes itself through {sorted(o for o in seen if folder in above.get(o, ()))}"


def namespace_at(text, position):
    inside = []
    for match in NAMESPACE.finditer(text, 0, position):
        if match.group(1):
            inside.append(match.group(1))
        else:
            inside.pop()
    return inside


def check_results(root):
    """What answers a user's question is [[nodiscard]]: a status that nobody looks at protects nobody."""
    for path in sorted((root / LIBRARY).rglob("*.hpp")):
        parts = path.relative_to(root / LIBRARY).parts
        if (parts[0] if len(parts) > 1 else "") not in ANSWERING:
            continue
        if "/".join(parts) in VIEWS:
            continue
        text = path.read_text()
        for function in FUNCTION.finditer(text):
            words = set(function.group("before").split())
            if words & NOT_ANSWERS or words <= SPECIFIERS or function.group("rest").endswith("= delete;"):
                continue
            if namespace_at(text, function.start()) in USERS_NAMESPACES:
                yield f"{path}: {function.group('name')}() answers and is not [[nodiscard]]"


def check_folder(root, folder, pattern, reason):
    forbidden = re.compile(pattern)
    for path in sorted((root / folder).rglob("*.[hc]pp")):
        for name in includes(path):
            if forbidden.match(name):
                yield f"{path}: includes {name}; {reason}"


def tracked(root):
    files = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
    return [pathlib.PurePath(f) for f in files if f]


def check_products(root):
    """What a program wrote where it ran, or more than a reader's share of a clone."""
    for file in tracked(root):
        if len(file.parts) == 1 and file.name not in TOP_LEVEL:
            yield f"{file}: the top level has {', '.join(sorted(TOP_LEVEL))} alone"
        elif (root / file).is_file() and (root / file).stat().st_size > LARGEST:
            yield f"{file}: has more than {LARGEST} bytes"


def check_readmes(root):
    folders = {str(file.parent) for file in tracked(root)}
    for folder in sorted(folders - {".ci", ".github/workflows"}):
        if folder.startswith("cmake/packages/"):  # what a package has, and no more
            continue
        if not (root / folder / "README.md").exists():
            yield f"{folder}: no README.md"


def check_tests(root):
    """A folder of tests is a screen of files; beyond that it has rooms."""
    folders = collections.Counter(str(file.parent) for file in tracked(root) if file.parts[0] == "tests")
    for folder, files in sorted(folders.items()):
        if files > MOST_TESTS and not any(f"{folder}/".startswith(f"{each}/") for each in LISTS):
            yield f"{folder}: has {files} files; {MOST_TESTS} at most, and rooms beyond"


def table_of(page):
    """The folders that a page's tables name in their first column."""
    return set(re.findall(r"`(\w+)/`", "".join(re.findall(r"^\|[^|]*\|", page, re.MULTILINE))))


def check_host_sim(root):
    """The host's side: what its pages say of rooms, of their folders and of who uses the library; what includes what."""
    host = root / "host_sim"
    if not host.is_dir():
        return
    present = {path.parent.parent.name for path in host.glob("*/*/README.md")}
    if table_of((host / "README.md").read_text()) != present or not present <= set(HOST_ROOMS):
        yield f"{host}/README.md: its table has the rooms {', '.join(room for room in HOST_ROOMS if room in present)}, and there is no other"
    for room in sorted(present):
        yield from check_host_room(host / room)
    yield from check_host_includes(host)


def check_host_room(room):
    page = (room / "README.md").read_text() if (room / "README.md").is_file() else ""
    present = {path.parent.name for path in room.glob("*/README.md")}
    if table_of(page) != present:
        yield f"{room}/README.md: its table and its folders differ in {', '.join(sorted(table_of(page) ^ present))}"
    missing = [words for words in ("nclude", "To add ", "Read ") if words not in page]
    if missing or page.count("\n") > LONGEST_PAGE:
        yield f"{room}/README.md: {LONGEST_PAGE} lines at most, and {', '.join(missing) or 'no more'}"
    named = re.search(r"^The library beyond.*? is used by(.*?)(?:alone|\.)", page, re.MULTILINE | re.DOTALL)
    users = {path.relative_to(room).parts[0] for path in room.rglob("*.[hc]pp*") if any(re.match(r"axial/(?!robot/|scalar/)", name) for name in includes(path))}
    if not named or users != set(re.findall(r"`(\w+)/`", named[1])):
        yield f"{room}/README.md: the library is used by {', '.join(sorted(users)) or 'nobody'}"
    for folder in (room, *(path.parent for path in room.glob("*/README.md"))):
        pieces = {path.name.partition(".")[0] for path in folder.iterdir() if path.name not in ("README.md", "CMakeLists.txt", "__pycache__")}
        if len(pieces) > MOST_HEADERS:
            yield f"{folder}: has {len(pieces)} entries; {MOST_HEADERS} at most, a header and its source being one"


def host_uses(host):
    """(file, the (room, folder) that it uses) of includes and of what Python imports from another folder."""
    scripts = collections.defaultdict(set)
    for path in host.glob("*/*/*.py"):
        scripts[path.stem].add(path.relative_to(host).parts[:2])
    for path in sorted(host.rglob("*.[hc]pp*")):
        for name in includes(path):
            if name.startswith("host_sim/"):
                yield path, tuple(name.split("/")[1:3])
    for path in sorted(host.glob("*/*/*.py")):
        for name in re.findall(r"^(?:from|import) (\w+)", path.read_text(), re.MULTILINE):
            if name not in sys.stdlib_module_names and scripts[name] and path.relative_to(host).parts[:2] not in scripts[name]:
                yield path, min(scripts[name], key=lambda place: place[0] != path.relative_to(host).parts[0])


def check_host_includes(host):
    """A room includes itself and what stands in front of it, no folder includes itself through others, a program's parts are its own."""
    above = collections.defaultdict(set)
    allowed = {room: HOST_ROOMS[:i + 1] for i, room in enumerate(HOST_ROOMS)}
    for path, other in host_uses(host):
        own = path.relative_to(host).parts[:2]
        if own == ("main.cpp",):
            continue
        above[own].add(other)
        if other[0] not in allowed.get(own[0], ()):
            yield f"{path}: {own[0]}/ must not include {'/'.join(other)}/"
    for path in sorted(host.rglob("*.[hc]pp*")):
        for name in includes(path):
            part = re.match(r"host_sim/boards/(demo|on_board)/", name)
            if part and path.parent.name not in ("host_sim", "demo", "on_board") and (path.parent.name, name) != ("loop", "host_sim/boards/on_board/provenance.hpp"):
                yield f"{path}: includes {name}; a program's parts are its own"
    yield from circles(host, {"/".join(own): {"/".join(other) for other in others - {own}} for own, others in above.items()})


def violations(root):
    yield from check_library(root)
    yield from check_rooms(root)
    yield from check_pages(root)
    yield from check_options(root)
    yield from check_language(root)
    yield from check_number_systems(root)
    yield from check_foreign_names(root)
    yield from check_cycles(root)
    yield from check_folder(root, "hal", r"axial/|robots/", "hal never sees dynamics")
    yield from check_folder(root, "robots", r"axial/(?!robot/)", "robots see robot only")
    yield from check_folder(root, "tests/oracle", r"axial/(?!robot/chain\.hpp)", "an oracle shares no code with what it checks")
    yield from check_results(root)
    yield from check_host_sim(root)
    yield from check_readmes(root)
    yield from check_tests(root)
    yield from check_products(root)


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    found = list(violations(pathlib.Path(sys.argv[1])))
    for violation in found:
        print(violation, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
