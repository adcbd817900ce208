"""Writes the generated tables of documents from the raw data beside them.

usage: tables.py DATA_FOLDER DOCUMENT.md...

DATA_FOLDER holds on_board.json, provenance.json, demo-<robot>-<board>.json, size.json, size_provenance.json, flags.csv,
flags_provenance.json, fixed_overflows.json, prove.json and derivatives.json. In each document whatever stands between <!-- table NAME --> and <!-- end --> is replaced by the
table of that name (a key of TABLES).
"""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/output"))
from document import command, fill, grouped, load, markdown, span, unique  # noqa: E402, F401  (some for the other pages)

KERNELS = ["inverse_dynamics", "separation", "closed_form", "gravity", "bias", "mass_matrix", "forward_dynamics",
           "forward_kinematics", "jacobian", "inverse_dynamics_derivatives", "forward_dynamics_derivatives"]


class Data:
    def __init__(self, folder):
        self.on_board = load(folder / "on_board.json")
        self.provenance = load(folder / "provenance.json")
        self.size, self.size_provenance = load(folder / "size.json"), load(folder / "size_provenance.json")
        self.flags, self.flags_provenance = load_csv(folder / "flags.csv"), load(folder / "flags_provenance.json")
        self.overflows = load(folder / "fixed_overflows.json")
        self.proved = load(folder / "prove.json")
        self.proved_at = load(folder / "prove_provenance.json")["commit"]
        self.derivatives = load(folder / "derivatives.json")
        self.demos = [load(file) for file in sorted(folder.glob("demo-*.json"))]


def load_csv(file):
    with open(file, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def provenance(data):
    lines = [f"- `{board}`: {entry['compiler']}; `{entry['flags']}`\n"
             for board, entry in data.provenance["boards"].items()]
    return f"Measured in QEMU at commit `{data.provenance['commit']}`:\n\n" + "".join(lines)


def demo(data):
    """The main job: one row per robot and board."""
    header = ["robot, board", "set-points", "largest error", "bound", "instructions per torque", "flash, bytes",
              "RAM, bytes", "stack, bytes"]
    rows = []
    for joints in sorted(data.demos, key=lambda joints: joints[0]["board"], reverse=True):
        first, worst = joints[0], max(joint["error_max_relative"] for joint in joints)
        rows.append([f"{first['robot']}, {first['board']}", grouped(first["set_points"]), f"{worst:.2g}",
                     f"{first['error_bound_relative']:g}", span(first["instructions_min"], first["instructions_max"]),
                     grouped(first["flash_bytes"]), grouped(first["ram_bytes"]), grouped(first["stack_bytes"])])
    return markdown(header, rows)


def headline(data):
    """The README's figures, each of the whole data."""
    joints = next(joints for joints in data.demos if (joints[0]["robot"], joints[0]["board"]) == ("puma560", "stm32f405"))
    image, worst = joints[0], max(joint["error_max_relative"] for joint in joints)
    kernel = lambda scalar, **wanted: size_rows(data, scalar, scene="bare", contract="off", variant="unrolled", **wanted)[0]
    count = lambda *args, **wanted: f"{grouped(kernel(*args, **wanted)['instructions'])} instructions"
    timed = lambda *args, **wanted: f"{count(*args, **wanted)} ({kernel(*args, **wanted)['microseconds']:.0f} us)"
    puma = {"robot": "puma560", "algorithm": "inverse_dynamics"}
    on_board = kernel("float", board="stm32f405", **puma)
    rows = [["feed-forward of a Puma 560 at 1 kHz, float, STM32F405: a request over the serial port to a checked torque",
             f"{span(image['instructions_min'], image['instructions_max'])} instructions, error at most {worst:.2g} of the joint's largest torque"],
            ["the same: the whole image", f"{grouped(image['flash_bytes'])} bytes of flash, {grouped(image['ram_bytes'])} of RAM, "
                                          f"{grouped(image['stack_bytes'])} of stack"],
            ["inverse dynamics of the Puma 560, float, STM32F405",
             f"{grouped(on_board['instructions'])} instructions, {grouped(on_board['flash_bytes'])} bytes of flash, {grouped(on_board['stack_bytes'])} of stack"],
            ["the same on a Cortex-M0 at 16 MHz (nRF51): 32-bit integers, and float",
             f"{timed('fixed32', board='nrf51', **puma)}, {timed('float', board='nrf51', **puma)}"],
            ["forward dynamics of a SCARA and of a Panda, float, STM32F405",
             ", ".join(count("float", board="stm32f405", robot=robot, algorithm="forward_dynamics") for robot in ("scara", "panda"))]]
    return markdown(["what", "cost"], rows, words=2) + f"\nMeasured at commit `{data.provenance['commit']}`, kernels at commit `{data.size_provenance['commit']}`.\n"


def instructions(data):
    """Robots against kernels, float, on the board with a floating-point unit."""
    return robots_by_kernels(data, lambda row: grouped(row["work"]))


def errors(data):
    return robots_by_kernels(data, lambda row: f"{row['error']:.1g}")


def robots_by_kernels(data, cell):
    chosen = {(row["robot"], row["subject"]): row for row in data.on_board
              if row["board"] == "stm32f405" and row["scalar"] == "float"}
    robots = unique(robot for robot, _ in chosen)
    rows = [[robot] + [cell(chosen[robot, kernel]) if (robot, kernel) in chosen else "" for kernel in KERNELS]
            for robot in robots]
    return markdown(["float, stm32f405"] + [kernel.replace("_", " ") for kernel in KERNELS], rows)


def everything(data):
    header = ["kernel, robot, scalar, board", "largest error", "RMS error", "instructions"]
    order = sorted(data.on_board, key=lambda row: (KERNELS.index(row["subject"]), row["robot"], row["board"], row["scalar"]))
    rows = [[f"{row['subject']}, {row['robot']}, {row['scalar']}, {row['board']}", f"{row['error']:.2g}",
             f"{row['error_rms']:.2g}", span(row["work_min"], row["work"])]
            for row in order]
    return markdown(header, rows)


def size_rows(data, scalar="float", **wanted):
    return [row for row in data.size if row["scalar"] == scalar and all(row[name] == value for name, value in wanted.items())]


def size_of(data, board, contract="off"):
    """A row per kernel: unrolled beside compact."""
    figures = {"instructions": "instructions", "cycles": "cycles", "flash": "flash_bytes", "stack": "stack_bytes"}
    header = [f"{board}, unrolled and compact"] + [f"{name}, {form}" for name in figures for form in ("u", "c")]
    rows = []
    for row in sorted(size_rows(data, board=board, scene="bare", contract=contract, variant="unrolled"),
                      key=lambda row: row["robot"]):
        same = {name: row[name] for name in ("board", "robot", "scene", "algorithm", "contract")}
        compact = size_rows(data, variant="compact", **same)
        cells = [grouped(each[name]) if each else "" for name in figures.values()
                 for each in (row, compact[0] if compact else None)]
        rows.append([f"{row['robot']}, {row['algorithm'].replace('_', ' ')}"] + cells)
    return markdown(header, rows)


def size_fixed(data):
    """Everything in fixed point; boards beside each other."""
    return size_of_kernels([row for row in data.size if row["scalar"].startswith("fixed")])


def size_elastic(data):
    """Motors behind springs; boards beside each other."""
    return size_of_kernels([row for row in data.size if row["scene"] == "elastic"])


def size_of_kernels(rows):
    header = ["robot, algorithm, numbers", "board", "instructions", "cycles", "us", "flash", "RAM", "stack"]
    figures = ("instructions", "cycles", "microseconds", "flash_bytes", "ram_bytes", "stack_bytes")
    form = lambda row: "" if row["variant"] == "unrolled" else ", " + row["variant"]
    name = lambda row: f"{row['robot']}, {row['algorithm'].replace('_', ' ')}, {row['scalar'].replace('_', ' ')}{form(row)}"
    return markdown(header, [[name(row), row["board"]] + [grouped(row[figure]) for figure in figures]
                             for row in sorted(rows, key=lambda row: (name(row), row["board"]))])


def proved(data):
    def cells(row):
        theirs = "-" if row["theirs"] is None else f"{row['theirs']:.3g}"
        coq = {None: "not asked", True: "accepts", False: "refuses"}[row["coq"]]
        return [f"{row['subject']}, {row['result']}", f"{row['ours']:.3g}", theirs, f"{row['words_accepted']} of {row['words']}", coq,
                f"{row['seconds']:.0f}"]
    return markdown(["subject", "ours", "Gappa's", "words that fit", "Coq", "s"], [cells(row) for row in data.proved])


def fixed_overflows(data):
    """A row per robot, a column per kernel and arithmetic: states, and results that did not fit."""
    robots = unique(row["robot"] for row in data.overflows)
    kernels = unique((row["kernel"], row["arithmetic"]) for row in data.overflows)
    cells = {(row["robot"], row["kernel"], row["arithmetic"]): f"{row['overflows']} in {grouped(row['states'])}" for row in data.overflows}
    header = ["overflows"] + [f"{kernel.replace('_', ' ')}, {arithmetic}" for kernel, arithmetic in kernels]
    made = data.overflows[0]
    return (markdown(header, [[robot] + [cells.get((robot, *kernel), "") for kernel in kernels] for robot in robots]) +
            f"\nCounted at commit `{made['commit']}` with {made['compiler']}, `{made['flags']}`.\n")


def derivatives(data):
    """Every block of derivatives, and of motors behind springs, in each number system: of its largest entry over the states, and of the state's own."""
    unrolled = [row for row in data.derivatives if row["variant"] == "unrolled"]
    scalars = unique(row["scalar"] for row in unrolled)
    header = ["robot, derivatives or motors of, block"] + [f"{scalar}{of}" for scalar in scalars for of in ("", ", of the state's own")]
    rows = []
    for robot, algorithm, block in unique((row["robot"], row["algorithm"], row["block"]) for row in unrolled):
        found = {row["scalar"]: row for row in unrolled if (row["robot"], row["algorithm"], row["block"]) == (robot, algorithm, block)}
        cells = [f"{found[scalar][name]:.1e}" if scalar in found else "" for scalar in scalars for name in ("error", "error_in_state")]
        rows.append([f"{robot}, {algorithm.removesuffix('_derivatives').replace('_', ' ')}, `{block}`"] + cells)
    return markdown(header, rows)


def size_scenes(data):
    """What a feature adds to the bare scene."""
    header = ["board, robot, algorithm", "figure"]
    bare = [row for row in size_rows(data, scene="bare", contract="off", variant="unrolled")
            if row["board"] in ("stm32f405", "stm32f100") and row["algorithm"] in ("inverse_dynamics", "forward_dynamics")]
    scenes = [scene for scene in unique(row["scene"] for row in data.size) if scene not in ("bare", "elastic")]
    rows = []
    for row in sorted(bare, key=lambda row: (row["robot"], row["board"], row["algorithm"])):
        same = {name: row[name] for name in ("board", "robot", "algorithm", "contract", "variant")}
        others = {other["scene"]: other for other in size_rows(data, **same)}
        if len(others) < 2:
            continue
        for name in ("instructions", "flash_bytes"):
            rows.append([f"{row['board']}, {row['robot']}, {row['algorithm'].replace('_', ' ')}", name.replace("_", " ")] +
                        [grouped(row[name])] + [f"{others[scene][name] - row[name]:+d}" if scene in others else "" for scene in scenes])
    return markdown(header + ["bare"] + [scene.replace("_", " ") for scene in scenes], rows)


def size_contract(data):
    """Fused multiply-adds against separate ones."""
    header = ["unrolled, bare", "instructions, off", "fast", "cycles, off", "fast", "flash, off", "fast"]
    rows = []
    for fast in sorted(size_rows(data, contract="fast", variant="unrolled", scene="bare"),
                       key=lambda row: (row["board"], row["robot"])):
        off = size_rows(data, **{name: fast[name] for name in ("board", "robot", "scene", "algorithm", "variant")}, contract="off")
        rows.append([f"{fast['board']}, {fast['robot']}, {fast['algorithm'].replace('_', ' ')}"] +
                    [grouped(row[name]) for name in ("instructions", "cycles", "flash_bytes")
                     for row in (off[0], fast)])
    return markdown(header, rows)


def size_provenance(data):
    lines = [f"- `{board}`: `{flags}`\n" for board, flags in data.size_provenance["flags"].items()]
    anew = "".join(f", {board} at `{commit}`" for board, commit in data.size_provenance.get("anew", {}).items())
    return (f"Measured in QEMU at commit `{data.size_provenance['commit']}`{anew} with {data.size_provenance['compiler']}:\n\n" +
            "".join(lines))


def size_flags(data):
    """Sets of compiler flags: sums over the kernels, board by board."""
    boards = unique(row["board"] for row in data.flags)
    kernels = unique((row["robot"], row["algorithm"]) for row in data.flags)
    header = [f"sums over {len(kernels)} kernels"]
    for board in boards:
        header += [f"{board}: instructions", "cycles", "against the first", "flash", "stack"]
    rows = []
    for name, changes in unique((row["flags"], row["changes"]) for row in data.flags):
        line = [name + (f": `{changes}`" if changes else "")]
        for board in boards:
            first, own = (flag_totals(data, each, board) for each in (data.flags[0]["flags"], name))
            cycles = own["cycles_estimated"]
            line += [flag_cell(own["instructions"]), flag_cell(cycles),
                     "" if cycles is None else f"{cycles / first['cycles_estimated'] - 1:+.1%}",
                     flag_cell(own["flash_bytes"]), flag_cell(own["stack_bytes"])]
        rows.append(line)
    made = data.flags_provenance
    own_flags = "".join(f"- `{board}`: `{flags}`\n" for board, flags in made["flags"].items())
    return (markdown(header, rows) + f"\nCompiled at commit `{made['commit']}` with {made['compiler']}; the toolchain file's flags:\n\n" +
            own_flags)


def flag_totals(data, name, board):
    """Of one set on one board: sums, of the stack the largest; None where a kernel has no count."""
    rows = [row for row in data.flags if (row["flags"], row["board"]) == (name, board)]
    return {figure: of(int(row[figure]) for row in rows) if all(row[figure] for row in rows) else None
            for figure, of in (("instructions", sum), ("cycles_estimated", sum), ("flash_bytes", sum), ("stack_bytes", max))}


def flag_cell(number):
    return "loops" if number is None else grouped(number)


TABLES = {"prove_provenance": lambda data: f"Proved at commit `{data.proved_at}`.\n", "size_flags": size_flags, "fixed_overflows": fixed_overflows, "proved": proved,
          "size_provenance": size_provenance, "size_scenes": size_scenes, "size_fixed": size_fixed, "size_elastic": size_elastic, "size_contract": size_contract,
          "size_stm32f405": lambda data: size_of(data, "stm32f405"),
          "size_mps2_an500": lambda data: size_of(data, "mps2_an500", "fast"),
          "size_stm32f100": lambda data: size_of(data, "stm32f100"),
          "headline": headline, "provenance": provenance, "demo": demo, "instructions": instructions, "errors": errors,
          "everything": everything, "derivatives": derivatives}


def main(folder, documents):
    data = Data(pathlib.Path(folder))
    for document in documents:
        fill(document, lambda name: TABLES[name](data))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
