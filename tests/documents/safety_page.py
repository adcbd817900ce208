#!/usr/bin/python3
"""doc/guides/safety.md and faults.md say what is so: every test that is named exists, and the times are those of the images and boards.

usage: safety_page.py --check | --write
"""
import json
import math
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, FAULTS = ROOT / "doc/guides/safety.md", ROOT / "doc/guides/faults.md"
SUITES = {"T": ("tests/target/safety_test.py", r"    def {}\(self"), "R": ("tests/target/restarts_test.py", r"    def {}\(self"),
          "H": ("tests/hal/apps/safety_test.cpp", r"^TEST_F\(SafetyApp, {}\)")}
BEGIN, END = "<!-- times: tests/documents/safety_page.py --write -->\n", "<!-- end of times -->"
BOARDS = ("stm32f405", "stm32f100", "nrf51", "rv32_virt")


def constants():
    text = (ROOT / "firmware/apps/feedforward/deadlines.hpp").read_text(encoding="utf-8")
    return {name: int(value) for name, value in re.findall(r"\b(\w+_(?:ms|ticks)) = (\d+)", text)}


def times():
    """The table: milliseconds on every board."""
    c = constants()
    yield "| ms | " + " | ".join(BOARDS) + " |"
    yield "|---|" + "---:|" * len(BOARDS)
    ticks = {board: json.loads((ROOT / f"hal/boards/{board}/board.json").read_text(encoding="utf-8"))["tick_Hz"] for board in BOARDS}

    def whole(ms, Hz):
        return math.ceil(ms * Hz / 1000) * 1000 / Hz

    rows = {"tick": lambda Hz: 1000 / Hz,
            "patience, free-running (20 ticks)".replace("20", str(c["watchdog_ticks"])): lambda Hz: c["watchdog_ticks"] * 1000 / Hz,
            "patience, lock-step": lambda Hz: whole(c["lock_step_patience_ms"], Hz),
            "ramp": lambda Hz: whole(c["ramp_ms"], Hz),
            "hold": lambda Hz: whole(c["hold_ms"], Hz),
            "watchdog, nominal": lambda Hz: c["hardware_watchdog_ms"]}
    for name, of in rows.items():
        yield f"| {name} | " + " | ".join(f"{of(ticks[board]):,.10g}".replace(",", " ") for board in BOARDS) + " |"


def with_times(page):
    begin, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    return page[:begin] + "\n".join(times()) + "\n" + page[end:]


def missing_tests(page):
    named = re.findall(r"(?:\||,) ([THR]) (\w+)(?=,| \|)", page)
    if len(named) < 20:
        yield "the table names no tests"
    for suite, name in named:
        path, pattern = SUITES[suite]
        if not re.search(pattern.format(name), (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE):
            yield f"{path} has no {name}"


def main():
    page = PAGE.read_text(encoding="utf-8")
    if sys.argv[1:] == ["--write"]:
        PAGE.write_text(with_times(page), encoding="utf-8")
        return 0
    if sys.argv[1:] != ["--check"]:
        print(__doc__)
        return 2
    found = list(missing_tests(FAULTS.read_text(encoding="utf-8")))
    if with_times(page) != page:
        found.append("the times of doc/guides/safety.md are not those of the sources: safety_page.py --write")
    for line in found:
        print(line, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
