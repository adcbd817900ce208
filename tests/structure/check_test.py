#!/usr/bin/python3
"""check.py must find one violation of each kind in a small tree made for it, and none in its mended twin."""
import pathlib
import re
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).with_name("check.py")
BEGIN, END = ("#include <axial/options/%s.hpp>\n" % name for name in ("begin", "end"))


def own(code, includes=""):
    """A header of that code."""
    return f"#pragma once\n\n{includes}\n{BEGIN}\n{code}\n{END}"


BROKEN = {
    "firmware/include/axial/scalar/a.hpp": "#include <axial/robot/b.hpp>\n",
    "firmware/include/axial/robot/b.hpp": "#include <vector>\n",
    "firmware/include/axial/closed_form/c.hpp": "#include <axial/dynamics/d.hpp>\n",
    "hal/e.hpp": "#include <axial/axial.hpp>\n",
    "robots/f.hpp": "#include <axial/dynamics/d.hpp>\n",
    "tests/oracle/g.hpp": "#include <axial/dynamics/d.hpp>\n",
    "firmware/include/axial/dynamics/i.hpp": "#include <axial/axial.h>\n",
    "firmware/include/axial/k.hpp": "#include <axial/eigen.hpp>\n",
    "firmware/include/axial/dynamics/l.hpp": own("namespace axial {\nconstexpr int free(int) { return 0; }\n}  // namespace axial\n"),
    "firmware/include/axial/control/m.hpp": own("namespace axial {\nstruct S {\n  static constexpr int member();\n};\n}  // namespace axial\n"),
    "firmware/include/axial/n.hpp": own("namespace axial {\nauto typeless(int) { return 0; }\n}  // namespace axial\n"),
    "firmware/include/axial/closed_form/o.hpp": own(
        "namespace axial {\nnamespace closed_form {\nconstexpr Long\nbroken(int) { return {}; }\n}  // namespace closed_form\n}  // namespace axial\n"),
    "firmware/include/axial/fixed/p.hpp": own("struct Word {};\n"),
    "firmware/include/axial/dynamics/q.hpp": own("constexpr int width(Word) { return 0; }  // Word is the plug-in's\n"),
    "firmware/include/axial/scene/r.hpp": "#include <axial/links/s.hpp>\n",
    "firmware/include/axial/fixed/one/t.hpp": "#include <axial/fixed/two/u.hpp>\n",
    "firmware/include/axial/fixed/two/u.hpp": "#include <axial/fixed/three/v.hpp>\n",
    "firmware/include/axial/fixed/three/v.hpp": "#include <axial/fixed/one/t.hpp>\n",
    "firmware/include/axial/x.hpp": "#include <axial/fixed/p.hpp>\n",
    "firmware/include/axial/fixed/closed_form/y.hpp": "#include <axial/dynamics/d.hpp>\n",
    "firmware/include/axial/simulation/old_path.hpp": "#include <axial/dynamics/water.hpp>\n",
    "firmware/include/axial/dynamics/water.hpp": "#include <axial/base/water.hpp>\n#include <axial/base/more.hpp>\n",
    "firmware/include/axial/recursion/dynamics.hpp": "#include <axial/dynamics/d.hpp>\n",
    **{f"firmware/include/axial/fixed/crowded/header_{i}.hpp": "\n" for i in range(21)},
    "firmware/include/axial/fixed/page/not_named.hpp": "\n",
    "firmware/include/axial/scalar/taken_call.hpp": own("namespace axial {\nconstexpr void word(int) {}\n}  // namespace axial\n"),
    "firmware/include/axial/scalar/taken_name.hpp": own("namespace axial {\nconstexpr int near = 1;\n}  // namespace axial\n"),
    "orphan/h.hpp": "\n",
    ".json": "[]\n",
    "robots/large.csv": "0\n" * 1_000_001,
    "host_sim/README.md": "| `gone/` | a room that is not there |\n",
    "host_sim/tools/README.md": "| `gone/` | a folder that is not there |\n\nThe library beyond is used by `gone/` alone.\n",
    "host_sim/tools/output/robot.cpp": "#include <host_sim/robots/robots/robot.hpp>\n",
    "host_sim/plants/loop/kernels.cpp": "#include <axial/axial.hpp>\n#include <host_sim/boards/demo/demo.hpp>\n",
    "host_sim/boards/size/picture.py": "from drawn import draw\n",
    "host_sim/figures/plot/drawn.py": "import json\n",
    "host_sim/figures/first/a.hpp": "#include <host_sim/figures/second/b.hpp>\n",
    "host_sim/figures/second/b.hpp": "#include <host_sim/figures/first/a.hpp>\n",
    **{f"host_sim/figures/many/piece_{i}.cpp": "\n" for i in range(21)},
    **{f"tests/screen/piece_{i}_test.cpp": "\n" for i in range(50)},
    **{f"tests/data/lists/row_{i}.csv": "\n" for i in range(60)},
    "firmware/include/axial/scene/standard_first.hpp": own("struct S {};\n", "#include <cstdint>\n#include <axial/scalar/language.hpp>\n"),
    "firmware/include/axial/scene/no_language.hpp": own("struct S {};\n"),
    "firmware/include/axial/scene/without_options.hpp": "#pragma once\nstruct S {};\n",
    "firmware/include/axial/scene/code_before.hpp": f"struct S {{}};\n{BEGIN}{END}",
    "firmware/include/axial/scene/never_ended.hpp": f"{BEGIN}struct S {{}};\n",
    "firmware/include/axial/scene/never_begun.hpp": f"struct S {{}};\n{END}",
    "firmware/include/axial/scene/begun_twice.hpp": f"{BEGIN}{BEGIN}struct S {{}};\n{END}",
    "firmware/include/axial/scene/ended_twice.hpp": f"{BEGIN}struct S {{}};\n{END}{END}",
    "firmware/include/axial/scene/ended_first.hpp": f"{END}struct S {{}};\n{BEGIN}",
    "firmware/include/axial/scene/includes_within.hpp": f"{BEGIN}#include <cstdint>\nstruct S {{}};\n{END}",
    "firmware/include/axial/scene/code_behind.hpp": f"{BEGIN}struct S {{}};\n{END}struct T {{}};\n",
}

# What is said of folders and of old paths.
SENTENCES = ("fixed/crowded: has 21 headers", "fixed/page/README.md: says nothing of `not_named.hpp`, nclude, To add ", "dynamics/water.hpp is an old path",
             "water.hpp: an old path includes axial/base/water.hpp and nothing else", "tools/ must not include robots/robots/",
             "host_sim/boards/demo/demo.hpp; a program's parts are its own", "boards/ must not include figures/plot/", "figures/first: includes itself",
             "taken_call.hpp: word is a macro", "taken_name.hpp: near is a macro", "figures/many: has 21 entries", "tests/screen: has 51 files", "tools/README.md: its table and its folders differ in gone, output", "plants/README.md: the library is used by loop",
             "plants/README.md: 70 lines at most, and nclude, To add , Read ", "host_sim/README.md: its table has the rooms tools, boards, plants, figures, and")
# What others' macros are; a name without arguments is none of word's.
FOREIGN = {"tests/builds/foreign_macros.hpp": "#define near\n#define word(...) makeWord(__VA_ARGS__)\n", "tests/builds/README.md": "\n"}
GONE = {".json", "firmware/include/axial/fixed/crowded/header_20.hpp", "host_sim/figures/many/piece_20.cpp", "tests/screen/piece_49_test.cpp"}
NO_VIOLATIONS = ("fixed/p.hpp", "plot/drawn.py", ".csv")  # but what others use of them

# Nothing of this is a violation: marked, void, a step, a step's namespace, deleted.
SOUND = own("""namespace axial {
namespace detail {
constexpr int hidden(int) { return 0; }
}  // namespace detail
[[nodiscard]] constexpr int marked(int) { return hidden(0); }
constexpr void silent(int) {}
AXIAL_INLINE constexpr int step(int) { return 0; }
auto gone(int) = delete;
struct S {
  [[nodiscard]] static constexpr int member();
  constexpr explicit S(int) {}
  int word = 0;
};
}  // namespace axial
""", "#include <axial/scalar/language.hpp>\n\n#include <cstdint>\n// A macro is nobody's code.\n#define AXIAL_SUM(a, b) \\\n  ((a) + (b))\n")


def run_on(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in (files | FOREIGN).items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        subprocess.run(["git", "init", "-q", folder], check=True)
        subprocess.run(["git", "-C", folder, "add", "."], check=True)
        return subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)


def page(folder, files):
    """Of a folder, with all that it has and what a page says."""
    names = [f"`{path.name}`" for path in map(pathlib.PurePath, files) if path.parent == folder]
    return "\n".join(["Includes nothing. To add one: write it.", *names]) + "\n"


def host_pages(files):
    """The tables of the host's rooms, and of each room's folders."""
    places = {path.parts[1:3] for path in map(pathlib.PurePath, files) if path.parts[0] == "host_sim" and len(path.parts) == 4}
    pages = {"host_sim/README.md": "".join(f"| `{room}/` | a room |\n" for room in sorted({room for room, _ in places}))}
    for room in {room for room, _ in places}:
        table = "".join(f"| `{folder}/` | a folder |\n" for own, folder in sorted(places) if own == room)
        pages[f"host_sim/{room}/README.md"] = table + "\nRead them. Includes nothing. To add one: write it.\nThe library beyond is used by nobody.\n"
    return pages


def mended():
    """The same tree without a violation."""
    files = {name: SOUND if name.startswith("firmware") else "\n" for name in BROKEN if name not in GONE} | {
        "firmware/include/axial/base/water.hpp": SOUND, "firmware/include/axial/dynamics/water.hpp": "#include <axial/base/water.hpp>\n"}
    folders = {pathlib.PurePath(name).parent for name in files} | {pathlib.PurePath(".")}
    return files | {str(folder / "README.md"): page(folder, files) for folder in folders} | host_pages(files)


def main():
    folders = {pathlib.PurePath(name).parent for name in BROKEN} | {pathlib.PurePath(".")}
    broken = run_on({**BROKEN, **{str(folder / "README.md"): "\n" for folder in folders if str(folder) != "orphan" and str(folder / "README.md") not in BROKEN}})
    sound = run_on(mended())
    # Of an orphan and of a folder the folder is named.
    by_folder = re.compile("orphan|/fixed/(?:one|two|three|crowded|page)/|figures/(?:first|second|many)/|tests/screen/")
    shown = {name: str(pathlib.PurePath(name).parent) if by_folder.search(name) else name for name in BROKEN}
    missed = [name for name in BROKEN if shown[name] not in broken.stderr and not name.endswith(NO_VIOLATIONS)]
    missed += [sentence for sentence in SENTENCES if sentence not in broken.stderr]
    if broken.returncode != 1 or missed:
        print("not found:", missed, file=sys.stderr)
        return 1
    if sound.returncode != 0:
        print("found in a sound tree:", sound.stderr, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
