#!/usr/bin/python3
"""Writes hal/boards/NAME, a copy of the board that is most like it under the new name, and its preset: it builds at once."""

import argparse
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOARDS, TOOLCHAINS = ROOT / "hal" / "boards", ROOT / "hal" / "toolchains"
PRESETS = ROOT / "CMakePresets.json"
NAME = re.compile(r"^[a-z][a-z0-9]*(_[a-z0-9]+)*$")
SHARED = {"arm_none_eabi", "riscv64_unknown_elf", "bare_metal"}  # toolchain files that are no CPU
REMARK = """/// A SKELETON, copied from {like}: every constant below is that board's until it is changed. Not yet run.
"""
README = """# {name}

A skeleton made from `{like}` for {cpu}; it builds, and has run nowhere. doc/guides/porting.md goes through it. Still {like}'s:

- `memory.ld`, and `flash_bytes`, `ram_bytes` in `board.hpp` and `board.json`: the part's memory
- `board.hpp`: clocks and their wait states, pins, the serial port's address, line and baud rate, the number of interrupt lines
- `board.json`: QEMU's machine, or no `qemu` where there is none; `run`, once it ran
"""


class Refused(Exception):
    pass


def boards():
    return sorted(path.parent.name for path in BOARDS.glob("*/board.json"))


def cpus():
    return {path.stem.replace("_", "-"): path for path in sorted(TOOLCHAINS.glob("*.cmake")) if path.stem not in SHARED}


def family(toolchain):
    return "riscv" if "rv32" in toolchain else "arm"


def type_name(name):
    return "".join(part[:1].upper() + part[1:] for part in name.split("_"))


def check(options):
    if not NAME.match(options.name):
        raise Refused(f"'{options.name}' is no name of a board; take lower-case letters, digits and single underscores, such as my_board")
    if (BOARDS / options.name).exists():
        raise Refused(f"hal/boards/{options.name} is there already; take another name or remove it")
    if options.like not in boards():
        raise Refused(f"no board '{options.like}'; --like takes one of: {', '.join(boards())}")
    if options.cpu is not None and options.cpu not in cpus():
        raise Refused(f"no toolchain for the CPU '{options.cpu}'; --cpu takes one of: {', '.join(cpus())}; "
                      "hal/toolchains/README.md says how to add one")


def toolchain_for(options, description):
    if options.cpu is None:
        return description["cpu"], description["toolchain"]
    toolchain = f"hal/toolchains/{cpus()[options.cpu].name}"
    if family(toolchain) != family(description["toolchain"]):
        raise Refused(f"{options.cpu} and {options.like} ({description['cpu']}) are of different architectures; "
                      "name a board with --like whose core is of the same")
    return options.cpu, toolchain


def header(text, like, name):
    """The board's header under its new name. A namespace that is shared with a folder of hal/ keeps its name."""
    text = text.replace(type_name(like), type_name(name)).replace(f'name = "{like}"', f'name = "{name}"')
    if not (ROOT / "hal" / like).is_dir():
        text = re.sub(rf"\b{like}(?=::|\s*\{{|$)", name, text, flags=re.MULTILINE)
    return text.replace("#pragma once\n", "#pragma once\n" + REMARK.format(like=like), 1)


def description(text, options, cpu, toolchain):
    for key, value in {"board": options.name, "cpu": cpu, "toolchain": toolchain, "run": "compiles only"}.items():
        text = re.sub(rf'"{key}": "[^"]*"', f'"{key}": "{value}"', text, count=1)
    return text


def presets(text, name, like, cpu, toolchain):
    """Both presets in front of the end of their lists; the rest of the file stays as it was written."""
    configure = f''',
    {{
      "name": "{name}",
      "displayName": "{name}, {cpu}; made from {like}",
      "inherits": "base",
      "toolchainFile": "${{sourceDir}}/{toolchain}",
      "cacheVariables": {{"CMAKE_BUILD_TYPE": "Release", "AXIAL_BOARD": "{name}"}}
    }}'''
    build = f',\n    {{"name": "{name}", "configurePreset": "{name}"}}'
    for following, preset in ((',\n  "buildPresets"', configure), (',\n  "testPresets"', build)):
        before, found, after = text.partition("\n  ]" + following)
        if not found:
            raise Refused(f"CMakePresets.json has no list before {following.strip(',').strip()}; add the presets by hand")
        text = before + preset + found + after
    json.loads(text)
    return text


def write(options):
    like = BOARDS / options.like
    described = json.loads((like / "board.json").read_text())
    cpu, toolchain = toolchain_for(options, described)
    if any(preset["name"] == options.name for preset in json.loads(PRESETS.read_text())["configurePresets"]):
        raise Refused(f"CMakePresets.json has a preset '{options.name}' already; take another name")
    files = {
        "board.hpp": header((like / "board.hpp").read_text(), options.like, options.name),
        "board.json": description((like / "board.json").read_text(), options, cpu, toolchain),
        "memory.ld": (like / "memory.ld").read_text(),
        **{source.name: source.read_text() for source in (*like.glob("*.cpp"), *like.glob("*code.ld"))},
        "README.md": README.format(name=options.name, like=options.like, cpu=cpu),
    }
    with_preset = presets(PRESETS.read_text(), options.name, options.like, cpu, toolchain)
    folder = BOARDS / options.name
    folder.mkdir()
    for name, text in files.items():
        (folder / name).write_text(text)
    PRESETS.write_text(with_preset)
    return cpu


def arguments():
    parser = argparse.ArgumentParser(prog="./axial new-board", description=__doc__, allow_abbrev=False)
    parser.add_argument("name", metavar="NAME", help="of the folder, the preset and, in PascalCase, the type")
    parser.add_argument("--like", required=True, metavar="BOARD", help=", ".join(boards()))
    parser.add_argument("--cpu", metavar="CPU", help=f"default that board's; {', '.join(cpus())}")
    return parser.parse_args()


def main():
    options = arguments()
    try:
        check(options)
        cpu = write(options)
    except Refused as error:
        print(f"axial: {error}", file=sys.stderr)
        return 2
    print(f"""axial: wrote hal/boards/{options.name} ({cpu}, like {options.like}) and its preset. It builds as it is:
  cmake --preset {options.name} && cmake --build --preset {options.name} --target selftest
Now make it that board's: hal/boards/{options.name}/README.md lists what, doc/guides/porting.md how. To have it tested with the others:
its name in cmake/driver/build.sh and tests/target/CMakeLists.txt.""")
    return 0


if __name__ == "__main__":
    sys.exit(main())
