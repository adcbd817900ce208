"""The robots of ./axial gallery, and the cells of its table: a robot in a number system on a board."""

import functools
import hashlib
import json
import os
import pathlib
import re
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[3]
BOARDS = ("stm32f405", "stm32f100", "nrf51", "rp2040", "rp2350_riscv")
NUMBERS = ("float", "fixed32")
HOST = "host"  # instead of a board: where errors are computed
PLACES = (HOST, *BOARDS)
INCLUDED = re.compile(r'#include [<"](robots/[\w/]+\.hpp)[>"]')
NAME = re.compile(r'const char\* name = "(\w+)"')
# What a cell's figures depend on, besides the robot's header and the board's own folder.
SHARED = ("firmware/include", "firmware/apps/size", "firmware/apps/elastic", "hal/cortex_m", "hal/riscv", "hal/toolchains", "host_sim/boards/size",
          "host_sim/boards/timing", "host_sim/boards/cost", "host_sim/boards/rp2040", "CMakePresets.json")
OF_ERRORS = ("firmware/include", "firmware/apps/size", "firmware/apps/elastic", "host_sim/figures/errors", "host_sim/tools/analysis",
             "host_sim/robots/robots", "tests/oracle")


class Robot(NamedTuple):
    name: str
    header: str  # in the project's folder, or anywhere
    machine: str  # what it is, in words

    @property
    def key(self):
        """Somebody's own robot is none of the project's, whatever its name."""
        return ("own-" if os.path.isabs(self.header) else "") + self.name


class Cell(NamedTuple):
    robot: Robot
    number: str
    place: str  # a board, or HOST


def located(path):
    """A header as the catalogue names it: one of the project's from its root, any other whole."""
    whole = (ROOT / path).resolve()
    return str(whole.relative_to(ROOT) if whole.is_relative_to(ROOT / "robots") else whole)


def of_header(path):
    """A robot by its header, whose first line says what it is."""
    path = located(path)
    text = (ROOT / path).read_text(encoding="utf-8")
    named = NAME.search(text)
    first = text.splitlines()[0].lstrip("/ ").rstrip(".")
    return Robot(named[1] if named else pathlib.Path(path).stem, path, re.split(r"[:(]|, MDH", first)[0].strip())


def robots():
    """Real machines first."""
    described = json.loads((ROOT / "robots/gallery/gallery.json").read_text(encoding="utf-8"))
    machines = [Robot(each["name"], each.get("header", f"robots/gallery/{each['name']}.hpp"), each["robot"]) for each in described]
    return machines + [of_header(header) for header in INCLUDED.findall((ROOT / "robots/robots.hpp").read_text(encoding="utf-8"))]


def chosen(names):
    """Robots by name or by header (from where one stands), all where there are no names."""
    known = {robot.name: robot for robot in robots()}
    return [known[name] if name in known else of_header(os.path.abspath(name)) for name in names] if names else list(known.values())


def cells(which, numbers, boards):
    """Float first; of each robot its errors before what it costs."""
    return [Cell(robot, number, place) for number in numbers for robot in which for place in (HOST, *boards)]


def sources(cell):
    """A digest of what the cell's figures are made from: they are measured once for each."""
    return digest_of(cell.place, cell.robot.header)


@functools.lru_cache(maxsize=None)
def digest_of(place, header):
    digest = hashlib.sha256()
    for file in [*files(OF_ERRORS if place == HOST else (*SHARED, f"hal/boards/{place}")), *headers(header)]:
        digest.update(file.read_bytes())
    return digest.hexdigest()[:12]


def files(names):
    """All but the pages."""
    for name in names:
        found = [ROOT / name] if (ROOT / name).is_file() else sorted((ROOT / name).rglob("*"))
        yield from (file for file in found if file.is_file() and file.suffix != ".md" and "__pycache__" not in file.parts)


def headers(header):
    """A robot's header and those of other robots that it includes."""
    path = ROOT / header
    yield path
    for included in INCLUDED.findall(path.read_text(encoding="utf-8")):
        yield from headers(included)
