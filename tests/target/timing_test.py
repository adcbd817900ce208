"""Cycles of the timing models (host_sim/boards/timing): Hazard3's against its RTL, the Cortex-M0's against Arm's tables, intervals, flash."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import emulator

sys.path[:0] = [str(emulator.ROOT / "host_sim/boards" / folder) for folder in ("size", "timing")]
import cortex_m  # noqa: E402
import cortex_m0  # noqa: E402
import execution  # noqa: E402
import flash  # noqa: E402
import hazard3  # noqa: E402
import image  # noqa: E402
import operands  # noqa: E402
import timing  # noqa: E402

SEQUENCES = json.loads((emulator.ROOT / "tests/data/timing/hazard3_sequences.json").read_text(encoding="utf-8"))
BEFORE = "_start: la sp, stack_top\n"
AFTER = """.option rvc
.balign 4
li t0, 0x100000
li t1, 0x5555
sw t1, 0(t0)
1: j 1b
.balign 4
.option norvc
sub_ret: ret
.bss
.balign 64
buf: .space 5120
stack_top:
"""
STATE = re.compile(r"^ pc +([0-9a-f]{8})", re.MULTILINE)
REGISTERS = re.compile(r"x\d+/(\w+) +([0-9a-f]{8})")
NOP = image.Instruction("nop", "", 2)  # alignment that objdump does not name


class Run:
    """All sequences in one image, executed instruction by instruction with the registers before each."""

    def __init__(self, folder):
        parts = [f".option rvc\n.balign 4\n.option norvc\nsequence{i}:\n{each['assembly']}" for i, each in enumerate(SEQUENCES)]
        source, path = folder / "sequences.s", folder / "sequences.elf"
        source.write_text(".globl _start\n" + BEFORE + "\n".join(parts) + AFTER, encoding="utf-8")
        subprocess.run(["riscv64-unknown-elf-gcc", "-march=rv32imac_zicsr_zifencei", "-mabi=ilp32", "-nostdlib", "-static", "-mno-relax",
                        "-Wl,-Ttext=0x80000000", source, "-o", path], check=True)
        log = folder / "log"
        subprocess.run(["qemu-system-riscv32", "-M", "virt", "-cpu", "rv32", "-bios", "none", "-display", "none", "-serial", "null", "-monitor",
                        "none", "-singlestep", "-d", "exec,cpu,nochain", "-D", log, "-kernel", path], check=True, timeout=120)
        states = log.read_text(encoding="utf-8").split("Trace ")[1:]
        self.executed = [int(STATE.search(state)[1], 16) for state in states]
        self._states = states
        self.image = image.Image(path)
        self.instructions = {address: self.image.instructions.get(address, NOP) for address in self.executed}
        self.starts = {address: int(name.removeprefix("sequence")) for name, address in self.image.functions.items()
                       if name.startswith("sequence")}

    def register(self, at, name):
        values = dict(REGISTERS.findall(self._states[at]))
        return int(values["s0" if name == "fp" else name], 16)

    def sequences(self):
        """(sequence, instructions, cycles) of the model, each between its readings of mcycle, the empty bracket taken away."""
        starts = [i for i, address in enumerate(self.executed) if address in self.starts]
        for start, end in zip(starts, starts[1:] + [len(self.executed)]):
            part = self.executed[start:end]
            read = [i for i, address in enumerate(part) if re.match(r"(s11|s9),mcycle", self.instructions[address].operands)]
            first, last = read[0], read[-1]
            negative = lambda index: self.register(start + index, hazard3.Step(self.instructions[part[index]]).dividend) >> 31
            until = lambda index: hazard3.cycles(part[:index + 1], self.instructions, negative)
            yield SEQUENCES[self.starts[part[0]]], last - first - 1, until(last) - until(first) - 1


class Hazard3(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.run_of_all = Run(pathlib.Path(folder))

    def wrong(self):
        return [each["name"] for each, _, found in self.run_of_all.sequences() if found != each["cycles"]]

    def test_sequences_take_what_the_rtl_takes(self):
        self.assertEqual(len(self.run_of_all.starts), 230)
        for each, instructions, found in self.run_of_all.sequences():
            with self.subTest(each["name"]):
                self.assertEqual((instructions, found), (each["instructions"], each["cycles"]))

    def test_a_control_register_is_read_without_a_wait(self):
        """Rule 7 of the sequences, where the word on its way is that of a register that is only written."""
        for name, registers, needed in (("csrr", ["a1"], []), ("csrrwi", ["a1"], []), ("csrw", ["a1"], ["a1"]), ("csrrs", ["a1", "a2"], ["a2"])):
            self.assertEqual(list(hazard3.needs(name, registers)), needed)

    def test_each_rule_is_needed(self):
        """Negative control: without it sequences come out wrong."""
        nothing = property(lambda _: None, lambda *_: None)
        for what, change in {
            "room of the buffer": mock.patch.object(hazard3, "ROOM", 4),
            "division": mock.patch.object(hazard3, "DIVISION", 18),
            "atomic": mock.patch.object(hazard3, "ATOMIC", 3),
            "fence": mock.patch.object(hazard3, "FENCE", 1),
            "a loaded word comes later": mock.patch.object(hazard3, "LOAD", re.compile("^lr")),
            "the predictor": mock.patch.object(hazard3.Fetch, "held", nothing, create=True),
        }.items():
            with self.subTest(what), change:
                self.assertNotEqual(self.wrong(), [])


# Arm DDI 0432C and DDI 0484C, table 3-1: assembly, cycles of the M0, cycles of the M0+.
MANUAL = """
movs r0, #1|1|1
movs r0, r1|1|1
mov r8, r1|1|1
adds r0, r1, #3|1|1
adds r0, r1, r2|1|1
add r0, r8|1|1
adds r0, #200|1|1
adcs r0, r1|1|1
add sp, #16|1|1
add r0, sp, #16|1|1
adr r0, there|1|1
subs r0, r1, r2|1|1
subs r0, r1, #3|1|1
subs r0, #200|1|1
sbcs r0, r1|1|1
sub sp, #16|1|1
rsbs r0, r1, #0|1|1
muls r0, r1, r0|1|1
cmp r0, r1|1|1
cmn r0, r1|1|1
cmp r0, #7|1|1
ands r0, r1|1|1
eors r0, r1|1|1
orrs r0, r1|1|1
bics r0, r1|1|1
mvns r0, r1|1|1
tst r0, r1|1|1
lsls r0, r1, #3|1|1
lsls r0, r1|1|1
lsrs r0, r1, #3|1|1
lsrs r0, r1|1|1
asrs r0, r1, #3|1|1
asrs r0, r1|1|1
rors r0, r1|1|1
ldr r0, [r1, #4]|2|2
ldrh r0, [r1, #4]|2|2
ldrb r0, [r1, #4]|2|2
ldr r0, [r1, r2]|2|2
ldrh r0, [r1, r2]|2|2
ldrsh r0, [r1, r2]|2|2
ldrb r0, [r1, r2]|2|2
ldrsb r0, [r1, r2]|2|2
ldr r0, there|2|2
ldr r0, [sp, #4]|2|2
ldm r1!, {r2, r3, r4}|4|4
ldm r1, {r0, r1}|3|3
str r0, [r1, #4]|2|2
strh r0, [r1, #4]|2|2
strb r0, [r1, #4]|2|2
str r0, [r1, r2]|2|2
str r0, [sp, #4]|2|2
stm r1!, {r2, r3}|3|3
push {r4, r5}|3|3
push {r4, lr}|3|3
push {r4-r7, lr}|6|6
pop {r4, r5}|3|3
sxth r0, r1|1|1
sxtb r0, r1|1|1
uxth r0, r1|1|1
uxtb r0, r1|1|1
rev r0, r1|1|1
rev16 r0, r1|1|1
revsh r0, r1|1|1
nop|1|1
mrs r0, primask|4|3
msr primask, r0|4|3
dmb|4|3
dsb|4|3
isb|4|3
""".strip().splitlines()
JUMPS = """
b there|3|2
beq there|3|2
bhi there|3|2
bl there|4|3
bx r0|3|2
blx r0|3|2
mov pc, r0|3|2
add pc, r0|3|2
pop {pc}|5|4
pop {r4, r5, pc}|7|6
""".strip().splitlines()


def assembled(lines, cpu):
    """Instructions as objdump tells them, by address."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = pathlib.Path(folder, "lines.s"), pathlib.Path(folder, "lines.o")
        source.write_text(".syntax unified\n.thumb\n" + lines + "\n.balign 4\nthere: nop\n", encoding="utf-8")
        floats = ["-mfloat-abi=hard", "-mfpu=fpv5-sp-d16"] if cpu == "cortex-m7" else []
        subprocess.run(["arm-none-eabi-gcc", "-mcpu=" + cpu, "-mthumb", *floats, "-c", source, "-o", out], check=True)
        return image.Image(out).instructions


class CortexM0(unittest.TestCase):
    def cases(self, lines):
        """Each line's address, instruction and cycles: one object of them all."""
        rows = [line.split("|") for line in lines]
        code = assembled("\n".join(row[0] for row in rows), "cortex-m0")
        for (address, instruction), (text, m0, plus) in zip(code.items(), rows):
            yield text, address, instruction, {"cortex-m0": int(m0), "cortex-m0plus": int(plus)}

    def test_straight_instructions_are_as_the_manual_says(self):
        self.assertGreaterEqual(len(MANUAL), 60)
        for text, address, instruction, wanted in self.cases(MANUAL):
            for core, cycles in wanted.items():
                with self.subTest(text, core=core):
                    self.assertEqual(cortex_m0.cycles(core, [address, address + instruction.size], {address: instruction}), cycles)

    def test_jumps_are_as_the_manual_says(self):
        for text, address, instruction, wanted in self.cases(JUMPS):
            for core, cycles in wanted.items():
                with self.subTest(text, core=core):
                    self.assertEqual(cortex_m0.cycles(core, [address, address + 100], {address: instruction}), cycles)

    def test_a_branch_that_is_not_taken_takes_one(self):
        for core in cortex_m0.TABLES:
            self.assertEqual(cortex_m0.cycles(core, [0, 2], {0: image.Instruction("bne.n", "40 <f>", 2)}), 1)


class CortexM(unittest.TestCase):
    def interval(self, core, *lines):
        code = assembled("\n".join(lines), "cortex-m7")
        addresses = sorted(code)[:len(lines) + 1]
        return tuple(cortex_m.cycles(core, addresses, code))

    def test_loads_overlap_unless_one_gives_the_other_its_address(self):
        self.assertEqual(self.interval("cortex-m4f", "ldr r0, [r4]", "ldr r1, [r5]", "ldr r2, [r6]"), (4, 4, 6))
        self.assertEqual(self.interval("cortex-m4f", "ldr r0, [r4]", "ldr r1, [r0]"), (4, 4, 4))

    def test_long_products_of_the_m3_end_early_or_not(self):
        self.assertEqual(self.interval("cortex-m3", "smull r0, r1, r2, r3"), (3, 4, 5))
        self.assertEqual(self.interval("cortex-m3", "smlal r0, r1, r2, r3"), (4, 6, 7))
        self.assertEqual(self.interval("cortex-m3", "mla r0, r1, r2, r3"), (2, 2, 2))
        self.assertEqual(self.interval("cortex-m4f", "mla r0, r1, r2, r3"), (1, 1, 1))
        self.assertEqual(self.interval("cortex-m4f", "smlal r0, r1, r2, r3"), (1, 1, 1))

    def test_divisions_depend_on_data(self):
        for core in ("cortex-m3", "cortex-m4f"):
            self.assertEqual(self.interval(core, "udiv r0, r1, r2"), (2, 7, 12))

    def test_a_float_is_late_for_the_next_instruction(self):
        self.assertEqual(self.interval("cortex-m4f", "vadd.f32 s0, s1, s2", "vmul.f32 s3, s0, s4"), (2, 3, 3))
        self.assertEqual(self.interval("cortex-m4f", "vadd.f32 s0, s1, s2", "vmul.f32 s3, s5, s4"), (2, 2, 2))
        self.assertEqual(self.interval("cortex-m4f", "vmul.f32 s0, s1, s2", "vfma.f32 s0, s5, s4"), (4, 4, 4), "the addend comes later")

    def test_scoreboards_pair_what_is_independent(self):
        low, likely, high = self.interval("cortex-m7", "adds r0, r1, r2", "adds r3, r4, r5", "adds r6, r1, r2", "adds r7, r4, r5")
        self.assertEqual((low, likely, high), (2, 2, 4))
        chain = self.interval("cortex-m7", "vadd.f32 s0, s0, s1", "vadd.f32 s0, s0, s1", "vadd.f32 s0, s0, s1")
        self.assertLess(chain[0], chain[1])

    def test_registers_of_an_instruction(self):
        for line, reads, writes in (("vfma.f32|s0, s1, s2", "s0 s1 s2", "s0"), ("str|r0, [r1, #4]", "r0 r1", ""),
                                    ("umull|r0, r1, r2, r3", "r2 r3", "r0 r1"), ("vldr|d1, [r2]", "r2", "s2 s3"),
                                    ("ldmia.w|r0!, {r4-r6}", "r0", "r4 r5 r6"), ("adds|r0, #1", "r0", "r0"), ("subs|r0, #1", "r0", "r0"),
                                    ("mla|r0, r1, r2, r3", "r1 r2 r3", "r0"), ("smlal|r0, r1, r2, r3", "r0 r1 r2 r3", "r0 r1"), ("uxtb|r0, r1", "r1", "r0"), ("vmov|r0, r1, d3", "s6 s7", "r0 r1"),
                                    ("push|{r4, lr}", "sp r4 lr", ""), ("cmp|r0, ip", "r0 r12", "")):
            with self.subTest(line):
                found = operands.access(image.Instruction(*line.split("|"), 4))
                self.assertEqual((found.reads, found.writes), (set(reads.split()), set(writes.split())))


def waits(described, addresses):
    return flash.waits(described, execution.Run(len(addresses), addresses, addresses))


class Memory(unittest.TestCase):
    FLASH = {"wait_states": 5, "line_bytes": 16, "lines": 2}
    SERIAL = {"range": ["100", "200"], "line_bytes": 8, "sets": 2, "ways": 2, "miss_cycles": 10}

    def test_each_line_waits_once_while_it_stays(self):
        self.assertEqual(waits(self.FLASH, [0, 4, 8, 16, 0, 16]), 10)

    def test_a_line_that_was_pushed_out_waits_again(self):
        self.assertEqual(waits(self.FLASH, [0, 16, 32, 0]), 20)

    def test_each_line_of_a_serial_flash_is_read_once_while_its_set_has_room(self):
        self.assertEqual(waits(self.SERIAL, [0x100, 0x104, 0x108, 0x110, 0x100, 0x108]), 30)

    def test_in_a_full_set_only_the_last_line_is_certain(self):
        """Which one a cache throws out is not told: lines 0, 2, 4 of set 0."""
        self.assertEqual(waits(self.SERIAL, [0x100, 0x110, 0x100, 0x110]), 20)
        self.assertEqual(waits(self.SERIAL, [0x100, 0x110, 0x120, 0x120, 0x110, 0x100]), 50)

    def test_ram_does_not_wait_for_serial_flash(self):
        self.assertEqual(waits(self.SERIAL, [0x200, 0x300, 0]), 0)


class Boards(unittest.TestCase):
    def test_every_board_names_a_core_and_its_clock(self):
        for file in sorted((emulator.ROOT / "hal/boards").glob("*/board.json")):
            described = json.loads(file.read_text(encoding="utf-8"))
            with self.subTest(file.parent.name):
                model = timing.Model(described)
                self.assertGreater(model.clock_Hz, 1_000_000)
                if "no such part" not in described["run"]:
                    self.assertEqual(described["cpu"], model.core.name)
                    self.assertIn(f"{model.clock_Hz / 1e6:g} MHz", file.with_name("board.hpp").read_text(encoding="utf-8"))

    def test_an_estimate_is_an_interval_and_an_exact_figure_is_not(self):
        code = {0: image.Instruction("str", "r0, [r1, #4]", 2), 2: image.Instruction("bx", "lr", 2)}
        fields = lambda core: timing.Model({"timing": {"core": core, "clock_Hz": 2_000_000}}).of(execution.Run(1, [0, 2]), code).fields()
        self.assertEqual(fields("cortex-m0"), {"core": "cortex-m0", "cycles": 2, "cycles_kind": "exact", "microseconds": 1.0})
        estimate = fields("cortex-m4f")
        self.assertLess(estimate["cycles_low"], estimate["cycles_high"])
        self.assertEqual(fields("cortex-m33")["cycles_kind"], "estimate")

    def test_the_worst_state_is_told_with_the_best(self):
        code = {0: image.Instruction("beq.n", "8 <f>", 2), 2: image.Instruction("nop", "", 2), 8: image.Instruction("bx", "lr", 2)}
        model = timing.Model({"timing": {"core": "cortex-m0", "clock_Hz": 1_000_000}})
        found = model.worst([execution.Run(2, [0, 2, 8]), execution.Run(1, [0, 8])], code)
        self.assertEqual((found.low, found.cycles), (2, 3))


if __name__ == "__main__":
    unittest.main()
