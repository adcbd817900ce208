"""Robots integrated on emulated boards: the second of a pick-and-place cycle and, of a Puma 560, a minute's free swing, against double.

usage: on_board.py run PROGRAM BOARD ROBOT [--name NAME] [--number N,N] [--method M,M] [--steps-per-tick N,N] [--swing] [--json FILE] [--picture STEM]
       on_board.py targets ROBOT [--number N,N]
       on_board.py documents PROGRAM FILE FOLDER     all rows of doc/measurements/plant.md; PROGRAM without -<robot>; the picture goes to FOLDER
       on_board.py has KEPT COMMIT ROBOT BOARD       exits with 0 where KEPT has that robot's rows from that commit
       on_board.py keep KEPT COMMIT ROBOT BOARD ROWS    the rows that run --json wrote into KEPT; without ROWS, that there are none
PROGRAM is the host's plant_board-<robot>. Prints a table, of which --json has the rows; the picture shows where each motion goes and what it is off.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/boards/size"))
import execution  # noqa: E402
import image  # noqa: E402
import measure  # noqa: E402

TICK = 1e-3  # s
CHOICES = (1, 2, 5, 10)  # steps per tick, of firmware/apps/plant/input.hpp
GATES = {"float": 1e-5, "fixed32": 1e-4}  # error over travel, of the driven second by Runge-Kutta
GATED = ("scara", "puma560")  # a Panda, whose published inertias no body has, drifts from its own course a thousand times as fast
DRIFT = 1e-4
HEAD = 5  # words of the input before the start


def image_name(robot, number):
    return f"plant-{'fixed-' if number == 'fixed32' else ''}{robot}"


def asked(program, request):
    """The host's answer."""
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        files = [pathlib.Path(folder, name) for name in ("request", "answer")]
        files[0].write_text(json.dumps(request), encoding="utf-8")
        subprocess.run([str(program), "--request", str(files[0]), "--answer", str(files[1])], check=True)
        return json.loads(files[1].read_text(encoding="utf-8"))


def written(path, words, to):
    """The image with words in the place of its input."""
    data = bytearray(pathlib.Path(path).read_bytes())
    [line] = [line for line in image.run("nm", "-S", "--target=" + image.FORMATS[image.machine_of(path)], path).splitlines()
              if line.endswith(" axial_plant_input")]
    address, size = (int(word, 16) for word in line.split()[:2])
    [section] = [each for each in image.sections(path) if "ALLOC" in each.attributes and each.address <= address < each.address + each.size]
    packed = b"".join(word.to_bytes(4, "little") for word in words)
    if len(packed) > size:
        raise ValueError(f"{path}: the input has room for {size} bytes, {len(packed)} were asked for")
    at = section.offset + address - section.address
    data[at:at + size] = packed.ljust(size, b"\0")
    pathlib.Path(to).write_bytes(data)


class Ran:
    """What an image printed: states and counts by steps, and how many steps were made."""

    def __init__(self, output):
        self.states, self.counts = [], []
        for head, *cells in (line.split(",") for line in output.splitlines()):
            if head == "count":
                self.counts.append(int(cells[0]))
            elif head == "state":
                self.states.append([int(cells[0]), [int(cell, 16) for cell in cells[1:]]])
            elif head == "steps":
                self.made, self.least, self.most = map(int, cells)


def ran(board, path, timeout=1200):
    described = measure.description(board)
    if "runner" in described:
        runner = described["runner"]
        command = [runner["program"], str(ROOT / runner["script"]), *runner["arguments"], "-fast", "-kernel", str(path), "-serial", "null"]
    else:
        qemu = described["qemu"]
        command = [qemu["program"], *qemu["arguments"], "-serial", "null", *(part.format(path) for part in qemu.get("image", execution.KERNEL))]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=timeout, check=False)
    if done.returncode != 0 or not done.stdout.endswith("end\n"):
        raise execution.Mismatch(f"{path}: ended with {done.returncode}: {done.stdout[-300:]}")
    return Ran(done.stdout)


class Plant:
    """A robot's image of a number system on a board, by a method and a step."""

    def __init__(self, program, board, robot, number, method="runge_kutta_4", steps_per_tick=1, name=None):
        self.program, self.board, self.robot, self.name = program, board, robot, name or robot
        self.number, self.method, self.per_tick = number, method, steps_per_tick
        self.path = measure.IMAGES / board / "images" / (image_name(robot, number) + ".elf")
        if not self.path.exists():
            raise FileNotFoundError(f"{self.path}: not built, or it does not fit the board")

    def request(self, motion, steps, report_every):
        return {"number": self.number, "motion": motion, "method": self.method, "choice": CHOICES.index(self.per_tick), "steps": steps,
                "report_every": report_every}

    def moved(self, motion, steps, report_every):
        """(the words that it got, what it said, the host's verdict)"""
        request = self.request(motion, steps, report_every)
        words = asked(self.program, request)["words"]
        said = self.run(words)
        return words, said, asked(self.program, {**request, "states": said.states})

    def run(self, words, to=ran):
        with tempfile.TemporaryDirectory(prefix="axial-") as folder:
            path = pathlib.Path(folder, self.path.name)
            written(self.path, words, path)
            return to(self.board, path)

    def timing(self, words, said):
        """(instructions, timing) of the dearest step that the board made, alone."""
        dearest = said.counts.index(said.most)
        state = len(said.states[0][1])
        start = said.states[dearest - 1][1] if dearest else words[HEAD:HEAD + state]
        at = HEAD + state + dearest // self.per_tick * (state // 4)
        once = [words[0], words[1], 1, 1, 1, *start, *words[at:at + state // 4]]  # method, step, one step, one report, efforts of one tick
        listed = image.Image(self.path)
        entry = listed.functions["axial_plant_" + self.method]
        described = measure.description(self.board)
        runs = self.run(once, lambda _, path: execution.run(described, path, entry, listed.instructions))
        if not self.counts_cycles() and [run.count for run in runs] != [said.most]:
            raise execution.Mismatch(f"{self.path}: the dearest step took {said.most}, alone {[run.count for run in runs]}")
        return runs[0].count, measure.timing.Model(described).worst(runs, listed.instructions)

    def counts_cycles(self):
        return measure.description(self.board).get("runner", {}).get("counts") == "cycles"

    def known(self, motion, made, verdict):
        """What a row has of any motion."""
        return {"board": self.board, "robot": self.name, "scalar": self.number, "method": self.method, "motion": motion, "step_s": TICK / self.per_tick,
                "error": verdict.get("error"), "growth": verdict.get("growth"), "energy_drift": verdict.get("energy_drift"), "same_bits": verdict["same_bits"],
                "difference": verdict["difference"], "made": made}

    def second(self):
        """(row of the driven second, positions and errors over time)"""
        steps = 1000 * self.per_tick
        words, said, verdict = self.moved("driven", steps, 1)
        instructions, timing = self.timing(words, said)
        row = self.known("driven, 1 s", said.made == steps, verdict)
        fields = timing.fields()
        real_time = 1e6 * row["step_s"] / fields["microseconds"]
        lowest = row["step_s"] * timing.clock_Hz / timing.high
        row.update(instructions=instructions, **fields, kind=timing.core.kind, steps_per_s=round(1e6 / fields["microseconds"], 1),
                   real_time_factor=round(real_time, 3), real_time_factor_low=round(lowest, 3))
        if said.least != said.most:
            row["cycles_min" if self.counts_cycles() else "instructions_min"] = said.least
        return judged(row, GATES[self.number] if self.has_gate() else None), verdict["way"]

    def has_gate(self):
        return self.robot in GATED and self.method == "runge_kutta_4"

    def minute(self):
        """Row of a minute's free swing."""
        steps = 60_000 * self.per_tick
        _, said, verdict = self.moved("swing", steps, 100 * self.per_tick)
        return judged(self.known("free swing, 60 s", said.made == steps, verdict), DRIFT if self.has_gate() else None)


def judged(row, gate):
    """With its gate and whether it holds: words are the host's bits besides."""
    off = row["error"] if row["energy_drift"] is None else row["energy_drift"]
    holds = row["made"] and (row["same_bits"] or row["scalar"] == "float") and (gate is None or off <= gate)
    return {**row, "gate": gate, "pass": holds}


def number(value, digits=2):
    return "" if value is None else f"{value:.{digits}g}"


def span(row):
    if "microseconds" not in row:
        return ["", "", ""]
    interval = f" to {row['cycles_high'] / row['cycles'] * row['microseconds']:.1f}" if "cycles_high" in row else ""
    worst = f", at worst {row['real_time_factor_low']:.3g}" if "cycles_high" in row else ""
    return [f"{row['instructions']}", f"{row['microseconds']:.1f}{interval} ({row['kind']})", f"{row['real_time_factor']:.3g}{worst}"]


def bits(row):
    return "the same" if row["same_bits"] else f"off by {row['difference']:.1e} of travel"


BOARDS = ("stm32f405", "stm32f100", "nrf51", "rv32_virt", "rp2040_ram")
DOCUMENTED = [(board, robot, scalar, method) for board in BOARDS for robot in ("scara", "puma560", "panda") for scalar in ("float", "fixed32")
              for method in ("runge_kutta_4", "semi_implicit")] + [("rp2040", "puma560", "fixed32", "runge_kutta_4")]
SWINGS = {("stm32f405", "float"), ("stm32f405", "fixed32")}  # minutes of an emulator on cores without a floating-point unit, whose words are the same


def documented(options, work):
    """Rows of one robot on a board, and its way."""
    board, robot, scalar, method = work
    try:
        plant = Plant(f"{options.program}-{robot}", board, robot, scalar, method)
    except FileNotFoundError:
        return [{"board": board, "robot": robot, "scalar": scalar, "method": method, "fits": False, "pass": True}], None
    row, way = plant.second()
    rows = [row]
    if (board, scalar) in SWINGS and (robot, method) == ("puma560", "runge_kutta_4"):
        rows.append(plant.minute())
    print(f"{' '.join(work)}: {row.get('microseconds')} us, {number(row['error'])}", file=sys.stderr, flush=True)
    return rows, {"row": row, "way": way}


def documents(options):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda work: documented(options, work), DOCUMENTED))
    rows = [row for some, _ in found for row in some]
    write(options.file, rows)
    drawn = [way for _, way in found if way and (way["row"]["board"], way["row"]["robot"]) == ("stm32f405", "puma560")]
    draw(drawn, options.folder + "/puma560-stm32f405")
    sys.exit(0 if all(row["pass"] for row in rows if row.get("gate")) and all(row.get("same_bits", True) for row in rows) else 1)


def kept_rows(path):
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else []


def is_of(row, options):
    return (row["machine"], row["board"]) == (options.robot, options.board)


def has(options):
    rows = [row for row in kept_rows(options.kept) if is_of(row, options)]
    sys.exit(0 if rows and all(row["commit"] == options.commit for row in rows) else 1)


def keep(options):
    made = kept_rows(options.rows) or [{"board": options.board, "fits": False, "pass": False}]
    others = [row for row in kept_rows(options.kept) if not is_of(row, options)]
    write(options.kept, others + [{"machine": options.robot, "commit": options.commit, **row} for row in made])


def write(path, rows):
    pathlib.Path(path).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


def draw(ways, stem):
    pathlib.Path(stem).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(stem + ".json").write_text(json.dumps(ways) + "\n", encoding="utf-8")
    subprocess.run(["/usr/bin/python3", "-E", "-B", str(ROOT / "host_sim/figures/plot/plant.py"), stem + ".json"], check=True)
    print(f"\npicture  {stem}.png")


def print_table(rows):
    lines = [["number", "method", "step, ms", "motion", "error", "growth", "energy drift", "instructions", "us per step", "times real time", "host's bits", "verdict"]]
    lines += [[row["scalar"], row["method"].replace("_", " "), f"{1e3 * row['step_s']:g}", row["motion"], number(row["error"]), number(row["growth"]), number(row["energy_drift"]),
               *span(row), bits(row), "ok" if row["pass"] else "MISSED"] for row in rows]
    widths = [max(map(len, column)) for column in zip(*lines)]
    for line in lines:
        print("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip())


def listed(text):
    return text.split(",")


def run(options):
    rows, ways = [], []
    for scalar in options.number:
        for method in options.method:
            for per_tick in map(int, options.steps_per_tick):
                plant = Plant(options.program, options.board, options.robot, scalar, method, per_tick, options.name)
                row, way = plant.second()
                rows.append(row)
                ways.append({"row": row, "way": way})
                if options.swing:
                    rows.append(plant.minute())
    board = measure.description(options.board)
    model = measure.timing.Model(board)
    print(f"{rows[0]['robot']} integrated on {options.board} ({board['cpu']}, {model.clock_Hz / 1e6:g} MHz), in {measure.emulator(options.board)}:\n")
    print_table(rows)
    print(f"\nError: after the second, from 0.1 ms Runge-Kutta steps in double on the host, over each joint's travel. Growth: what the\nmotion makes of any small error at its start. Time: of the dearest step; {model.core.kind}\n"
          f"({model.core.says}). Never measured on silicon.")
    if options.json:
        write(options.json, rows)
    if options.picture:
        draw(ways, options.picture)
    sys.exit(0 if all(row["pass"] for row in rows) else 1)


def parse():
    parser = argparse.ArgumentParser(usage=__doc__)
    subs = parser.add_subparsers(dest="action", required=True)
    sub = subs.add_parser("documents")
    for name in ("program", "file", "folder"):
        sub.add_argument(name)
    for name in ("has", "keep"):
        sub = subs.add_parser(name)
        sub.add_argument("kept", type=pathlib.Path)
        for each in ("commit", "robot", "board"):
            sub.add_argument(each)
        if name == "keep":
            sub.add_argument("rows", type=pathlib.Path)
    for name in ("targets", "run"):
        sub = subs.add_parser(name)
        if name == "run":
            sub.add_argument("program")
            sub.add_argument("board")
        sub.add_argument("robot")
        sub.add_argument("--number", type=listed, default=["float", "fixed32"])
    sub.add_argument("--name")
    sub.add_argument("--method", type=listed, default=["runge_kutta_4"])
    sub.add_argument("--steps-per-tick", type=listed, default=["1"])
    sub.add_argument("--swing", action="store_true")
    sub.add_argument("--json")
    sub.add_argument("--picture")
    return parser.parse_args()


if __name__ == "__main__":
    chosen = parse()
    if chosen.action == "targets":
        print(*(image_name(chosen.robot, each) for each in chosen.number))
    else:
        {"run": run, "documents": documents, "has": has, "keep": keep}[chosen.action](chosen)
