"""What each robot costs: cells are measured once, rows say what they must, tables and the page hold the rows, and the page does what it says.

usage: gallery_test.py CLASS...      classes of tests; Browser ends with 77 where chromium is not installed
"""

import argparse
import contextlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(os.environ.get("AXIAL_MUTATED", pathlib.Path(__file__).resolve().parents[3]))  # a copy, where a mutant is tried
sys.path += [str(ROOT / f"host_sim/{folder}") for folder in ("figures/gallery", "figures/pages", "figures/report", "boards/size")]
import catalogue  # noqa: E402
import gallery  # noqa: E402
import gallery_tables  # noqa: E402
import page  # noqa: E402
import refused  # noqa: E402
import store  # noqa: E402
import verify  # noqa: E402

SKIPPED = 77
ARM, LEG = (robot.header for robot in catalogue.chosen(["ur5e", "go2_leg"]))


def cell(header=ARM, number="float", place="nrf51"):
    return catalogue.Cell(catalogue.of_header(header), number, place)


def row(robot="ur5e", board="nrf51", number="float", algorithm="inverse_dynamics", us=100.0, **others):
    return {"robot": robot, "board": board, "number": number, "algorithm": algorithm, "type": "robots::Ur5e", "header": f"robots/gallery/{robot}.hpp",
            "instructions": 1234, "cycles": 2000, "cycles_kind": "exact", "microseconds": us, "flash_bytes": 5000, "ram_bytes": 0, "stack_bytes": 64,
            "commit": "c0ffee1", "sources": "digest", "joints": 6, "error": 1.25e-7, **others}


def refusal(why, **others):
    return {name: value for name, value in row(**others, why=why).items() if name in ("robot", "board", "number", "algorithm", "header", "why")}


class Catalogue(unittest.TestCase):
    def test_every_robot_of_both_lists_is_in_it_once(self):
        names = [robot.name for robot in catalogue.robots()]
        self.assertEqual(len(names), len(set(names)))
        headers = {path.stem for path in (ROOT / "robots").rglob("*.hpp") if path.parent.name != "models"} - {"robots", "gallery"}
        self.assertEqual(set(names), headers)

    def test_real_machines_come_first_and_say_what_they_are(self):
        described = json.loads((ROOT / "robots/gallery/gallery.json").read_text(encoding="utf-8"))
        self.assertEqual([(robot.name, robot.machine) for robot in catalogue.robots()][:len(described)], [(each["name"], each["robot"]) for each in described])

    def test_a_header_of_ones_own_is_found_from_where_one_stands_and_mixed_up_with_none(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
            pathlib.Path("my arm.hpp").write_text('// Mine.\nstatic constexpr const char* name = "ur5e";', encoding="utf-8")
            own, = catalogue.chosen(["my arm.hpp"])
            self.assertEqual((own.name, own.machine), ("ur5e", "Mine"))
            self.assertEqual(own.header, os.path.realpath("my arm.hpp"))
            self.assertNotEqual(own.key, catalogue.chosen(["ur5e"])[0].key)
            same, = catalogue.chosen([str(ROOT / ARM)])
        self.assertEqual((same.key, same.header), ("ur5e", ARM))

    def test_float_comes_first_and_errors_before_costs(self):
        found = [(each.robot.name, each.number, each.place) for each in catalogue.cells(catalogue.chosen(["ur5e", str(ROOT / LEG)]), ("float", "fixed32"), ("nrf51",))]
        self.assertEqual(found[:3], [("ur5e", "float", "host"), ("ur5e", "float", "nrf51"), ("go2_leg", "float", "host")])
        self.assertEqual(len(found), 8)


class Sources(unittest.TestCase):
    """Which cells a change of a file makes old, in a copy of some of the sources."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ("firmware/include/axial/a.hpp", "hal/boards/nrf51/b.hpp", "hal/boards/rp2040/c.hpp", "host_sim/figures/errors/d.hpp", "host_sim/boards/size/e.py"):
            self.write(name, "one")
        self.write("robots/first.hpp", '#include <robots/second.hpp>\nconst char* name = "first";')
        self.write("robots/second.hpp", 'const char* name = "second";')
        self.enterContext(unittest.mock.patch.object(catalogue, "ROOT", self.root))

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def digests(self):
        catalogue.digest_of.cache_clear()
        return {(header, place): catalogue.digest_of(place, f"robots/{header}.hpp") for header in ("first", "second") for place in ("nrf51", "rp2040", "host")}

    def made_old(self, name):
        before = self.digests()
        self.write(name, (self.root / name).read_text(encoding="utf-8") + "\n// changed" if (self.root / name).exists() else "new")
        return {key for key, digest in self.digests().items() if digest != before[key]}

    def test_a_change_makes_old_what_is_made_from_it(self):
        all_of = lambda *places: {(header, place) for header in ("first", "second") for place in places}
        self.assertEqual(self.made_old("firmware/include/axial/a.hpp"), all_of("nrf51", "rp2040", "host"))
        self.assertEqual(self.made_old("hal/boards/nrf51/b.hpp"), all_of("nrf51"))
        self.assertEqual(self.made_old("host_sim/boards/size/e.py"), all_of("nrf51", "rp2040"))
        self.assertEqual(self.made_old("host_sim/figures/errors/d.hpp"), all_of("host"))

    def test_a_robots_header_and_those_that_it_includes(self):
        self.assertEqual(self.made_old("robots/first.hpp"), {("first", place) for place in ("nrf51", "rp2040", "host")})
        self.assertEqual(len(self.made_old("robots/second.hpp")), 6)

    def test_pages_make_nothing_old(self):
        self.assertEqual(self.made_old("firmware/include/axial/README.md"), set())


class Kept(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.enterContext(unittest.mock.patch.object(store, "FOLDER", self.folder / "cells"))
        self.enterContext(unittest.mock.patch.object(store, "commit", lambda: "c0ffee1"))
        self.sources = self.enterContext(unittest.mock.patch.object(store, "sources", side_effect=lambda cell: "now"))
        self.committed = self.folder / "gallery.json"

    def known(self):
        return store.Store(self.committed)

    def test_a_cell_is_measured_once(self):
        self.assertFalse(self.known().is_current(cell()))
        store.keep(cell(), [row()])
        self.assertTrue(self.known().is_current(cell()))
        for other in (cell(LEG), cell(number="fixed32"), cell(place="rp2040"), cell(place="host")):
            self.assertFalse(self.known().is_current(other))

    def test_and_again_when_its_sources_changed_but_shown_meanwhile(self):
        store.keep(cell(), [row()])
        self.sources.side_effect = lambda cell: "later"
        self.assertFalse(self.known().is_current(cell()))
        self.assertEqual(self.known().joined(cell())[0]["microseconds"], 100.0)

    def test_what_is_committed_counts(self):
        self.committed.write_text(json.dumps([row(sources="now", error_sources="now"), row(board="rp2040", sources="then", error_sources="now")]), encoding="utf-8")
        self.assertTrue(self.known().is_current(cell()))
        self.assertTrue(self.known().is_current(cell(place="host")))
        self.assertFalse(self.known().is_current(cell(place="rp2040")))

    def test_a_cell_that_cannot_be_is_kept_too(self):
        store.keep(cell(), [refusal("there is no room")])
        self.assertTrue(self.known().is_current(cell()))

    def test_errors_stand_beside_costs(self):
        store.keep(cell(), [row(algorithm=name, error=None, header="moved.hpp") for name in ("inverse_dynamics", "feedforward", "gravity")] + [refusal("no room", algorithm="forward_dynamics")])
        store.keep(cell(place="host"), [{"algorithm": "inverse_dynamics", "joints": 6, "error": 2e-7, "error_certified": 3e-7},
                                        {"algorithm": "forward_dynamics", "joints": 6, "error": 4e-7}])
        found = {each["algorithm"]: each for each in self.known().joined(cell())}
        self.assertEqual([found[name]["error"] for name in ("inverse_dynamics", "feedforward", "gravity")], [2e-7, 2e-7, None])
        self.assertEqual(found["inverse_dynamics"]["error_certified"], 3e-7)
        self.assertNotIn("error", found["forward_dynamics"])
        self.assertEqual(found["forward_dynamics"]["joints"], 6)
        self.assertEqual(found["gravity"]["commit"], "c0ffee1")
        self.assertEqual({each["header"] for each in found.values()}, {ARM}, "wherever it was when it was measured")

    def test_what_was_not_measured_says_so(self):
        asked = argparse.Namespace(robot="ur5e", board="nrf51,rp2040", number="float")
        store.keep(cell(), [row()])
        rows = gallery.shown_rows(asked, self.known())
        self.assertEqual([(each["board"], each.get("why")) for each in rows], [("nrf51", None)] + [("rp2040", gallery.NOT_YET)] * 4)
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            gallery.print_table(rows)
        self.assertIn("ur5e, float, rp2040: inverse_dynamics, gravity, forward_dynamics, feedforward: not measured yet", said.getvalue())

    def test_only_what_is_missing_is_to_be_measured(self):
        store.keep(cell(), [row()])
        self.assertEqual(self.to_be_measured(board="nrf51,rp2040", number="float"), [f"host float {ROOT / ARM}", f"rp2040 float {ROOT / ARM}"])

    def test_lanes_share_all_cells_out_and_no_place_is_in_two(self):
        everything = self.to_be_measured(board=None, number=None)
        lanes = [self.to_be_measured(board=None, number=None, lane=f"{lane}/4") for lane in range(4)]
        self.assertEqual(sorted(sum(lanes, [])), sorted(everything))
        places = [{line.split()[0] for line in lane} for lane in lanes]
        self.assertEqual(sum(map(len, places)), len(set.union(*places)))
        self.assertTrue(all(lanes))

    def to_be_measured(self, lane="0/1", **choice):
        said = io.StringIO()
        with contextlib.redirect_stdout(said), unittest.mock.patch.object(gallery, "Store", self.known):
            gallery.run_cells(argparse.Namespace(robot="ur5e", lane=lane, **choice))
        return said.getvalue().splitlines()


LOG = """[1/9] Building
FAILED: a/size-kernels-own-x-of-bare-gravity.dir/own-x-of-bare-gravity.cpp.obj
error: static assertion failed: axial: give every link a speed_limit()
[2/9] Linking
FAILED: probes/own-bare-bias-unrolled-off.elf
ld: region `FLASH' overflowed by 288 bytes
[3/9] Linking
FAILED: probes/empty-own.elf
ld: region `RAM' overflowed by 16 bytes
ninja: build stopped
"""


class Reasons(unittest.TestCase):
    def why(self, image, source, empty="empty-own-fixed32"):
        return refused.reason(LOG, (image, empty), source)

    def test_the_librarys_sentence(self):
        self.assertEqual(self.why("own-bare-gravity-unrolled-off", "own-x-of-bare-gravity"), "axial: give every link a speed_limit()")

    def test_which_memory_is_too_small(self):
        self.assertIn("FLASH overflows by 288 bytes", self.why("own-bare-bias-unrolled-off", "own-x-of-bare-bias"))
        self.assertIn("RAM overflows by 16 bytes", self.why("own-bare-mass-unrolled-off", "own-x-of-bare-mass", "empty-own"))

    def test_nothing_is_said_of_another_kernel(self):
        self.assertIsNone(self.why("own-bare-mass-unrolled-off", "own-x-of-bare-mass"))
        self.assertIsNone(self.why("own-bare-bias-unrolled", "own-x-of-bare"))


class Tables(unittest.TestCase):
    ROWS = [row(), row(algorithm="gravity", us=20.0), row(algorithm="forward_dynamics", us=1234.0, error=3e-7),
            row(algorithm="feedforward", us=110.0, flash_bytes=6000, stack_bytes=72, ram_bytes=24),
            *(refusal("there is no room", robot=robot, algorithm=name) for robot in ("sawyer", "gen3") for name in gallery.ALGORITHMS),
            refusal("springs", robot="z1", algorithm="forward_dynamics"), *(row(robot="z1", algorithm=name) for name in ("inverse_dynamics", "gravity", "feedforward")),
            *(refusal(gallery.NOT_YET, robot="iiwa14", algorithm=name) for name in gallery.ALGORITHMS)]

    def made(self, table):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "gallery.json").write_text(json.dumps(self.ROWS), encoding="utf-8")
            return table(pathlib.Path(folder))

    def test_a_robot_is_a_line(self):
        text = self.made(gallery_tables.board("nrf51"))
        self.assertIn("| ur5e | 6 | float | 100.0 | 20.0 | 1 234 | 110.0 | 1 234 | 6 000 | 24 | 72 | 1.2e-07 | 3.0e-07 |", text)
        self.assertIn("| z1 | 6 | float | 100.0 | 100.0 | - | 100.0 |", text)

    def test_what_cannot_be_says_why(self):
        text = self.made(gallery_tables.board("nrf51"))
        self.assertIn("- sawyer, gen3 in float, all: there is no room\n", text)
        self.assertIn("- z1 in float, forward dynamics: springs\n", text)
        self.assertIn("Not measured yet: 1 of 5 cells.", text)
        self.assertNotIn("| sawyer", text)

    def test_cells_are_counted(self):
        self.assertIn("| nrf51 | float | 5 | 1 | 3 | 1 |", self.made(gallery_tables.coverage))

    def test_the_committed_page_is_of_the_committed_data(self):
        data = ROOT / "doc/data"
        text = (ROOT / "doc/measurements/gallery.md").read_text(encoding="utf-8")
        for name, table in gallery_tables.TABLES.items():
            self.assertIn(f"<!-- table {name} -->\n{table(data)}<!-- end -->", text)


class Page(unittest.TestCase):
    MADE = {"commits": {"c0ffee1": 4}, "compiler": "a <compiler>", "flags": {"nrf51": "-O2"}, "models": {"nrf51": "Cycles: exact."}, "emulators": {"nrf51": "QEMU"}}

    def text(self, rows):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "page.html")
            page.write(file, rows, catalogue.robots(), self.MADE)
            return file.read_text(encoding="utf-8")

    def data(self, rows):
        return json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', self.text(rows), re.DOTALL)[1])

    def test_every_row_is_in_it(self):
        rows = Tables.ROWS
        data = self.data(rows)
        self.assertEqual(len(data["rows"]), len(rows))
        for values, given in zip(data["rows"], rows):
            self.assertEqual(dict(zip(data["fields"], values)), {name: given.get(name) for name in data["fields"]})

    def test_robots_say_what_they_are_and_how_they_are_included(self):
        data = self.data([row(), row(robot="arm", header="/home/me/arm.hpp", type="mine::Arm", joints=3)])
        self.assertEqual(data["robots"], [{"name": "ur5e", "machine": "Universal Robots UR5e", "joints": 6, "type": "robots::Ur5e", "include": "<robots/gallery/ur5e.hpp>"},
                                          {"name": "arm", "machine": "arm", "joints": 3, "type": "mine::Arm", "include": '"/home/me/arm.hpp"'}])

    def test_a_word_cannot_end_the_script(self):
        why = "</script><b>&amp;"
        self.assertEqual(self.data([refusal(why)])["rows"][0][-1], why)

    def test_it_asks_for_no_other_file(self):
        text = self.text(Tables.ROWS)
        self.assertIn("default-src 'none'", text)
        self.assertNotRegex(text, r"(src|href)\s*=|https?://|@import|url\(|fetch\(")

    def test_it_says_with_what_it_was_measured(self):
        text = self.text(Tables.ROWS)
        for part in ("c0ffee1", "a &lt;compiler&gt;", "-O2", "Cycles: exact.", "nothing was run on silicon"):
            self.assertIn(part, text)


class Code(unittest.TestCase):
    """The lines that the page shows compile, to the scene that was measured; another scene's do not pass."""

    def compile(self, number, algorithms, change=lambda text: text):
        bodies = "".join(f"void shown_{name}() {{\n" + "\n".join(page.code(number, name)).replace(page.ROBOT, "robots::Ur5e") +
                         "\nstatic_assert(std::is_same_v<Scene, axial::apps::number_systems::as_" + number +
                         f"::scene<axial::apps::size::scenes::bare, robots::Ur5e>>);\nstatic_cast<void>({'safe' if name == 'feedforward' else 'qdd' if name == 'forward_dynamics' else 'tau'});\n}}\n"
                         for name in algorithms)
        text = "".join(f"#include <{name}>\n" for name in (page.HEADERS[number], "firmware/apps/number_systems.hpp", "firmware/apps/size/algorithms.hpp", ARM))
        command = ["g++", "-std=c++17", "-fsyntax-only", "-w", f"-I{ROOT}/firmware/include", f"-I{ROOT}", "-x", "c++", "-"]
        return subprocess.run(command, input=text + change(bodies), capture_output=True, text=True, check=False)

    def test_lines_compile(self):
        for number in catalogue.NUMBERS:
            done = self.compile(number, page.TITLES)
            self.assertEqual(done.returncode, 0, done.stderr[:2000])

    def test_lines_of_another_scene_do_not(self):
        self.assertNotEqual(self.compile("float", ["gravity"], lambda text: text.replace("axial::RotorInertia", "axial::Friction", 1)).returncode, 0)

    def test_the_safe_loop_is_a_kernel_whose_lines_are_checked(self):
        verify.compile_lines([{"robot": "scara", "scene": "bare", "algorithm": "feedforward", "form": "unrolled", "scalar": number} for number in catalogue.NUMBERS])


STEPS = """
<script>
const said = {}, problems = [];
const choose = (name, value) => { const control = document.getElementById("choose-" + name);
  if (control.type === "checkbox") control.checked = value; else control.value = value;
  control.dispatchEvent(new Event("input")); };
const key = name => (document.activeElement || document.body).dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
const column = number => [...document.querySelectorAll("#rows tbody tr")].map(line => line.cells[Math.min(number, line.cells.length - 1)].textContent);
const count = () => document.getElementById("count").textContent;
const heading = () => document.querySelector("#detail h2")?.textContent ?? "";
const sort = name => document.querySelector(`th[data-name=${name}] button`).click();
try {
  said.address = [count(), document.getElementById("choose-number").value];
  key("Escape");
  said.all = count();
  sort("error"), sort("microseconds"), said.ascending = column(5);
  sort("microseconds"), said.descending = column(5);
  said.sorted_by = [...document.querySelectorAll("th")].filter(head => head.ariaSort !== "none").map(head => [head.dataset.name, head.ariaSort]);
  choose("robot", "ur5e"), said.robot = [count(), location.hash];
  choose("algorithm", "gravity"), said.gravity = [count(), heading(), document.querySelector("pre").textContent];
  key("Escape"), choose("within", "50"), said.within = column(5);
  key("Escape"), choose("there", true), said.there = count();
  key("Escape"), choose("search", "SAWYER"), said.search = [count(), document.querySelector("#detail p").textContent];
  choose("search", "nothing at all"), said.nothing = [count(), document.querySelector("#detail p").textContent];
  key("Escape"), document.activeElement.blur(), key("/"), said.slash = document.activeElement.id;
  key("ArrowDown"), said.typing = heading();
  document.activeElement.blur(), said.first = heading();
  key("ArrowDown"), said.down = [heading(), document.activeElement.tagName];
  key("End"), said.end = heading(), key("ArrowDown"), said.beyond = heading();
  key("Home"), said.home = heading(), key("ArrowUp"), said.above = heading();
  document.querySelectorAll("#rows tbody tr")[2].click(), said.click = heading();
} catch (problem) { problems.push(String(problem)); }
said.problems = problems;
document.body.append(Object.assign(document.createElement("pre"), { id: "said", textContent: JSON.stringify(said) }));
</script>
"""


class Browser(unittest.TestCase):
    """The page in headless Chromium: a copy with steps behind it that choose, sort and press keys, and write down what they see."""

    ROWS = [row(us=30.0), row(algorithm="gravity", us=10.0), row(algorithm="inverse_dynamics", number="fixed32", us=20.0, error=1e-9),
            row(robot="z1", board="rp2040", us=200.0), refusal("there is no room", robot="sawyer")]

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "page.html")
            page.write(file, cls.ROWS, catalogue.robots(), Page.MADE)
            file.write_text(file.read_text(encoding="utf-8").replace("</html>", STEPS + "</html>"), encoding="utf-8")
            command = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile", "--virtual-time-budget=5000", "--dump-dom",
                       f"file://{file}#number=fixed32&search=ur5e"]
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=True)
        cls.said = json.loads(re.search(r'<pre id="said">(.*?)</pre>', done.stdout, re.DOTALL)[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))

    def test_nothing_went_wrong(self):
        self.assertEqual(self.said["problems"], [])

    def test_the_address_chooses_and_remembers(self):
        self.assertEqual(self.said["address"], ["1 of 5 rows", "fixed32"])
        self.assertIn("robot=ur5e", self.said["robot"][1])

    def test_filters(self):
        self.assertEqual([self.said["all"], self.said["robot"][0], self.said["there"]], ["5 of 5 rows", "3 of 5 rows", "4 of 5 rows"])
        self.assertEqual(self.said["within"], ["30.0", "20.0", "10.0"])
        self.assertEqual(self.said["search"], ["1 of 5 rows", "No figures: there is no room."])
        self.assertEqual(self.said["nothing"], ["0 of 5 rows", "No row is inside these filters."])

    def test_sorting_leaves_what_is_missing_last(self):
        self.assertEqual(self.said["ascending"], ["10.0", "20.0", "30.0", "200.0", "there is no room"])
        self.assertEqual(self.said["descending"], ["200.0", "30.0", "20.0", "10.0", "there is no room"])
        self.assertEqual(self.said["sorted_by"], [["microseconds", "descending"]])

    def test_the_row_says_its_cost_and_its_code(self):
        shown, heading, text = self.said["gravity"]
        self.assertEqual([shown, heading], ["1 of 5 rows", "Universal Robots UR5e: gravity on nrf51 in float"])
        self.assertEqual(text, "\n".join(["#include <axial/axial.hpp>", "#include <robots/gallery/ur5e.hpp>", "", *page.code("float", "gravity")]).replace(page.ROBOT, "robots::Ur5e"))

    def test_keys(self):
        headings = ["Unitree Z1: torque on rp2040 in float", "Universal Robots UR5e: torque on nrf51 in float", "Universal Robots UR5e: torque on nrf51 in fixed32"]
        last = "Rethink Robotics Sawyer: torque on nrf51 in float"
        self.assertEqual(self.said["slash"], "choose-search")
        self.assertEqual([self.said[name] for name in ("typing", "first", "home", "above")], [headings[0]] * 4, "arrows in a field move no row")
        self.assertEqual(self.said["down"], [headings[1], "TR"])
        self.assertEqual([self.said["end"], self.said["beyond"], self.said["click"]], [last, last, headings[2]])


class Mutants(unittest.TestCase):
    """Single changes in a copy of the sources, each with the tests that must notice it."""

    TABLE = [
        ("figures/gallery/catalogue.py", "return machines + [", "return machines[1:] + [", "Catalogue"),
        ("figures/gallery/catalogue.py", "for number in numbers for robot in which", "for robot in which for number in numbers", "Catalogue"),
        ("figures/gallery/catalogue.py", '("own-" if os.path.isabs(self.header) else "")', '""', "Catalogue"),
        ("figures/gallery/catalogue.py", "of_header(os.path.abspath(name))", "of_header(name)", "Catalogue"),
        ("figures/gallery/catalogue.py", "yield from headers(included)", "pass", "Sources"),
        ("figures/gallery/catalogue.py", 'file.suffix != ".md"', "True", "Sources"),
        ("figures/gallery/catalogue.py", 'f"hal/boards/{place}")', '"hal/boards")', "Sources"),
        ("figures/gallery/catalogue.py", "OF_ERRORS if place == HOST", "SHARED if place == HOST", "Sources"),
        ("figures/gallery/store.py", "return bool(rows) and all(", "return all(", "Kept"),
        ("figures/gallery/store.py", "row.get(key) == sources(cell)", "key in row", "Kept"),
        ("figures/gallery/store.py", 'SAME_TORQUE = {"feedforward": "inverse_dynamics"}', "SAME_TORQUE = {}", "Kept"),
        ("figures/gallery/store.py", 'OF_HOST if "why" in row else (*OF_HOST, *ERRORS)', "(*OF_HOST, *ERRORS)", "Kept"),
        ("figures/gallery/store.py", 'if path.is_file():\n            return', 'if False:\n            return', "Kept"),
        ("figures/gallery/store.py", ', "header": cell.robot.header', "", "Kept"),
        ("figures/gallery/gallery.py", " and not store.is_current(cell):", ":", "Kept"),
        ("figures/gallery/gallery.py", "store.joined(cell) or [", "store.joined(cell) + [", "Kept"),
        ("boards/size/refused.py", "overflows by {full[2]} bytes", "overflows by {full[1]} bytes", "Reasons"),
        ("boards/size/refused.py", r'(re.escape(image) + r"\.elf" for', "(re.escape(image) for", "Reasons"),
        ("figures/pages/gallery_tables.py", "for algorithm in TIMED)", "for algorithm in TIMED[::-1])", "Tables"),
        ("figures/pages/gallery_tables.py", 'count(safe, field) for field', 'count(torque, field) for field', "Tables"),
        ("figures/pages/gallery_tables.py", 'row.get("why", NOT_YET) != NOT_YET', 'row.get("why", NOT_YET) == NOT_YET', "Tables"),
        ("figures/pages/gallery_tables.py", 'there = sum(all("why" not in row', 'there = sum(any("why" not in row', "Tables"),
        ("figures/gallery/page.py", '.replace("</", "<\\\\/")', "", "Page"),
        ("figures/gallery/page.py", 'f"{value:.4g}"', 'f"{value:.1g}"', "Page"),
        ("figures/gallery/page.py", 'for name in ("joints", "type")', 'for name in ("joints",)', "Page"),
        ("figures/gallery/gallery.html", "default-src 'none'; ", "", "Page"),
        ("figures/gallery/gallery.html", "if (x === null || y === null) return", "if (false) return", "Browser"),
        ("figures/gallery/gallery.html", "(state.down ? -1 : 1)", "1", "Browser"),
        ("figures/gallery/gallery.html", "!state[name] || row[name] === state[name]", "true", "Browser"),
        ("figures/gallery/gallery.html", "row.microseconds <= Number(state.within)", "true", "Browser"),
        ("figures/gallery/gallery.html", "(!state.there || row.why === null)", "true", "Browser"),
        ("figures/gallery/gallery.html", "event.key in moves && !typing", "event.key in moves", "Browser"),
        ("figures/gallery/gallery.html", "Math.max(0, Math.min(shown.length - 1, index))", "index", "Browser"),
        ("figures/gallery/gallery.html", "readAddress();\nshowState", "showState", "Browser"),
        ("figures/gallery/gallery.html", '.replaceAll("ROBOT_TYPE", robot.type)', "", "Browser"),
    ]

    def test_each_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for name in ("host_sim", "robots", "doc/data", "doc/measurements", "hal/boards"):
                shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("__pycache__"))
            for file, old, new, tests in self.TABLE:
                if tests == "Browser" and not shutil.which("chromium"):
                    print(f"skipped: chromium is not installed: {file}: {old}")
                    continue
                with self.subTest(file=file, old=old):
                    self.assertFalse(self.passes(copy, copy / "host_sim" / file, old, new, tests))

    def passes(self, copy, file, old, new, tests):
        text = file.read_text(encoding="utf-8")
        self.assertEqual(text.count(old), 1)
        file.write_text(text.replace(old, new), encoding="utf-8")
        command = [sys.executable, "-E", "-B", __file__, tests]
        done = subprocess.run(command, env={**os.environ, "AXIAL_MUTATED": str(copy)}, capture_output=True, text=True, check=False)
        file.write_text(text, encoding="utf-8")
        return done.returncode == 0


if __name__ == "__main__":
    if "Browser" in sys.argv and not shutil.which("chromium"):
        print("skipped: chromium is not installed; ./axial test --deep installs it")
        sys.exit(SKIPPED)
    unittest.main()
