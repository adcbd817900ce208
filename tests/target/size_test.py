"""Size and cost of the main kernels: inside their budgets, smaller where a scene leaves something out; and that the
instruments behind ./axial size (host_sim/boards/size) see what they should.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import emulator
import harness

sys.path.insert(0, str(emulator.ROOT / "host_sim/boards/size"))
import execution  # noqa: E402
import flag_sets  # noqa: E402
import flags  # noqa: E402
import image  # noqa: E402
import measure  # noqa: E402
import refused  # noqa: E402
import size  # noqa: E402
import stack  # noqa: E402

BUDGETS = json.loads((pathlib.Path(__file__).parent / "budgets.json").read_text(encoding="utf-8"))


def over_budget(row, budget):
    return [f"{name}: {row[name]}, budget {most}" for name, most in budget.items() if row[name] > most]


class Size(harness.BoardTest):
    """Rows of the probes in the set `main`, measured once."""

    @classmethod
    def setUpClass(cls):
        work = [(cls.board, probe) for probe in measure.probes(cls.board) if probe.set == "main"]
        cls.rows = {probe: row for (_, probe), row in zip(work, size.measure_all(work))}

    def row(self, robot, scene):
        return self.rows[measure.Probe("main", robot, scene, "inverse_dynamics", "unrolled", "off")]

    def test_every_main_kernel_has_a_budget(self):
        budgeted = {name for name in BUDGETS if name.startswith(self.board + "/")}
        self.assertEqual(budgeted, {f"{self.board}/{probe.name}" for probe in self.rows if probe.scene == "bare"})

    def test_budgets(self):
        """After a change that is worth its cost, ./axial size --update-budgets writes new ones."""
        for probe, row in self.rows.items():
            budget = BUDGETS.get(f"{self.board}/{probe.name}")
            if budget:
                with self.subTest(probe.name):
                    self.assertEqual(over_budget(row, budget), [])

    def test_a_regression_is_noticed(self):
        """Negative control: one instruction, one byte over."""
        row = self.row("scara", "bare")
        for name in size.BUDGETED:
            budget = {other: row[other] for other in size.BUDGETED}
            self.assertEqual(over_budget(row, budget), [])
            budget[name] -= 1
            self.assertEqual(len(over_budget(row, budget)), 1, name)

    def test_what_a_scene_leaves_out_costs_nothing(self):
        """Gravity, rotors, friction and payload each cost instructions and flash, where the robot has them."""
        for robot in ("puma560", "scara_rrpr", "scara"):
            for less, more in (("without_gravity", "bare"), ("without_rotors", "bare"), ("bare", "friction"),
                               ("bare", "payload")):
                with self.subTest(robot=robot, less=less, more=more):
                    left, right = self.row(robot, less), self.row(robot, more)
                    for name in ("instructions", "flash_bytes"):
                        if robot == "scara" and "payload" not in (less, more) and "without_gravity" not in (less, more):
                            self.assertLessEqual(left[name], right[name], "it declares neither rotors nor friction")
                        else:
                            self.assertLess(left[name], right[name])

    def test_images_of_kernels_count_what_probes_count(self):
        """They are linked of the same objects; in hard float a count does not depend on the state."""
        for robot in ("scara", "puma560"):
            _, text = emulator.run(self.board, "kernels-" + robot)
            rows = [row for row in (line.split(",") for line in text.splitlines()) if row[2:3] == ["float"]]
            counts = {kernel: int(count) for kernel, _, _, _, count, *_ in rows}
            bare = {probe.algorithm: row for probe, row in self.rows.items() if probe[1:3] == (robot, "bare") and probe.contract == "off"}
            self.assertGreaterEqual(len(bare), 2)
            self.assertEqual({name: counts[name] for name in bare}, {name: row["instructions"] for name, row in bare.items()})

    def test_no_static_memory(self):
        for probe, row in self.rows.items():
            self.assertEqual(row["ram_bytes"], 0, probe.name)

    def test_no_instruction_of_data_dependent_length(self):
        """Integer division is the only one that the Cortex-M4 has (doc/guides/constant_time.md). The harness has some, which
        shows that they are seen."""
        divisions = lambda probe, within: [name for address, (name, *_) in probe.image.instructions.items()
                                           if name.startswith(("udiv", "sdiv")) and within(address)]
        for probe in list(self.rows)[:6]:
            figures = measure.Figures(self.board, probe)
            self.assertEqual(divisions(figures, figures.depths.reached.__contains__), [], probe.name)
            self.assertNotEqual(divisions(figures, lambda _: True), [])

    def test_an_unrolled_kernel_executes_what_stands_there(self):
        """What ./axial size --flags relies on."""
        for probe, row in self.rows.items():
            program = image.Image(measure.path_of(self.board, probe.name))
            if probe.scene == "bare":
                self.assertEqual(flags.cost(program, self.board), (row["instructions"], row["cycles_estimated"]), probe.name)

    def test_a_fused_multiply_add_saves_instructions_not_cycles(self):
        for probe, row in self.rows.items():
            if probe.contract == "fast":
                apart = self.rows[probe._replace(contract="off")]
                self.assertLess(row["instructions"], apart["instructions"], probe.name)
                self.assertGreater(row["cycles_estimated"], apart["cycles_estimated"], probe.name)


ARM = ("arm-none-eabi-gcc", "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16")
RISCV = ("riscv64-unknown-elf-gcc", "-march=rv32imac", "-mabi=ilp32")


def compiled(source, compiler=ARM):
    """A small program in C that starts at f."""
    with tempfile.TemporaryDirectory(prefix="axial-") as folder:
        elf = pathlib.Path(folder) / "program.elf"
        subprocess.run([*compiler, "-O1", "-ffreestanding", "-x", "c", "-", "-nostdlib", "-Wl,-e,f", "-o", elf, "-lgcc"], check=True,
                       input="#define APART __attribute__((noinline))\n" + source, text=True, capture_output=True)
        return image.Image(elf)


class FlagSets(unittest.TestCase):
    OWN = ("-mthumb", "-O2", "-fno-tree-ter", "-ffp-contract=off")

    def test_changes(self):
        own, both, name = flag_sets.parse("# a comment\n\nown\nsize, order   !-fno-tree-ter -Os\ncontract fast -ffp-contract=fast\n")
        self.assertEqual((own.name, own.apply(self.OWN)), ("own", list(self.OWN)))
        self.assertEqual((both.name, both.apply(self.OWN)), ("size, order", ["-mthumb", "-O2", "-ffp-contract=off", "-Os"]))
        self.assertEqual(flags.contract(name.apply(self.OWN)), "fast")
        self.assertEqual(flags.contract(self.OWN), "off")

    def test_what_is_wrong_is_named(self):
        for why, text in {
            "line 2: 'ter' is not a flag": "own\nx -fno-tree-ter ter",
            "line 3: a set without a name": "own\n\n-O3",
            "line 2: a second 'own'": "own\nown -O3",
            "the first set must change nothing": "fast -O3",
            "the first set": "# nothing",
        }.items():
            with self.subTest(why), self.assertRaisesRegex(flag_sets.Invalid, why):
                flag_sets.parse(text)
        with self.assertRaisesRegex(flag_sets.Invalid, "'x' takes away -fweb, which is not among -mthumb"):
            flag_sets.parse("own\nx !-fweb")[1].apply(self.OWN)

    def test_own_sets_fit_the_boards(self):
        sets = flag_sets.parse(flags.SETS.read_text(encoding="utf-8"))
        for board in flags.BOARDS:
            own = flags.own_flags(board)
            self.assertIn("-O2", own)
            made = [tuple(each.apply(own)) for each in sets]
            self.assertEqual(len(made), len(set(made)))

    def test_commands_are_taken_apart(self):
        found = flags.split("/usr/bin/ccache /usr/bin/g++ -DA=1 '-DB=\"\"' -I/x -mthumb -O2 -Wall -std=c++17 -MD -MT a.o -o a.o -c /y/kernel.cpp", ())
        self.assertEqual(found, (("/usr/bin/ccache", "/usr/bin/g++"), ("-DA=1", '-DB=""', "-I/x", "-std=c++17", "-DAXIAL_USER_OPTIONS"), ()))


class Boards(unittest.TestCase):
    def test_all_that_an_emulator_runs(self):
        self.assertLessEqual({"nrf51", "rp2040"}, set(measure.boards()))
        for board in measure.boards():
            described = measure.description(board)
            self.assertIn("program", described.get("qemu", described.get("runner")))


class StraightLine(unittest.TestCase):
    """What is executed, without executing it; Size compares it with QEMU."""

    def executed(self, source):
        program = compiled(source)
        return [program.instructions[address].name for address in flags.straight_line(program, program.functions["f"])]

    def test_a_call_counts_as_often_as_it_is_made(self):
        g = "void APART g(void) { asm volatile(\"nop\"); }"
        self.assertEqual(self.executed(g + "void f(void) { g(); g(); asm volatile(\"\"); }"),
                         ["push", "bl", "nop", "bx", "bl", "nop", "bx", "pop"])

    def test_branches_and_loops_are_refused(self):
        for source in ("int f(int n) { int s = 0; do { asm volatile(\"\"); s += n; } while (--n); return s; }",
                       "void f(int n) { if (n) asm volatile(\"wfi\\n wfi\\n wfi\\n wfi\\n wfi\\n wfi\\n wfi\"); }"):
            with self.assertRaises(flags.NotStraight):
                self.executed(source)


class Stack(unittest.TestCase):
    """The stack of small programs whose depth is known by construction."""

    def depth(self, source):
        program = compiled(source)
        return stack.StackDepth(program).of(program.functions["f"])

    def test_known_depths(self):
        leaf = "int APART f(int a) { return a + 1; }"
        self.assertEqual(self.depth(leaf), 0)
        save = 'void APART f(void) { asm volatile("push {r4, r5, lr}\\n sub sp, #20\\n vpush {d8-d9}\\n' \
               ' vpop {d8-d9}\\n add sp, #20\\n pop {r4, r5, pc}"); }'
        self.assertEqual(self.depth(save), 12 + 20 + 16)

    def test_the_deepest_callee_counts(self):
        source = """
            APART void g(void) { volatile char a[64]; a[0] = 1; }
            APART void h(void) { volatile char a[256]; a[0] = 1; }
            void f(void) { g(); h(); g(); }"""
        self.assertEqual(self.depth(source), 8 + 256)

    def test_a_far_jump_of_armv6_m(self):
        """A loop longer than a branch reaches is closed by a call into the middle of the function."""
        source = "void APART f(int n) { volatile int a[8]; do { a[0] = n; " + "asm(\"nop\");" * 1500 + " } while (--n); }"
        program = compiled(source, ("arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb"))
        self.assertIn("bl", {name for name, *_ in program.instructions.values()})
        self.assertEqual(stack.StackDepth(program).of(program.functions["f"]), 4 + 36)

    def test_a_routine_inside_a_routine(self):
        """As libgcc's multiplication of doubles has one; what it returns to is looked at too."""
        inside = """__attribute__((naked)) void APART f(void) { asm volatile("push {r4, lr}\\n cmp r0, #0\\n it eq\\n bleq 1f\\n"
                    "sub sp, #24\\n add sp, #24\\n pop {r4, pc}\\n 1: sub sp, #%d\\n add sp, #%d\\n bx lr"); }"""
        self.assertEqual(self.depth(inside % (16, 16)), 8 + 24)
        self.assertEqual(self.depth(inside % (40, 40)), 8 + 40)
        with self.assertRaisesRegex(stack.Unbounded, "a return with 12 bytes"):
            self.depth(inside % (40, 36))

    def test_what_can_not_be_bounded_is_refused(self):
        for why, source in {
            "recursion: f": "int APART f(int n) { return n < 2 ? n : f(n - 1) * 3 + f(n - 2); }",
            "indirect call": "int APART f(int (*g)(int)) { return g(1) + g(2); }",
            "unknown size": "void g(char* p) { asm volatile(\"\" :: \"r\"(p)); } void f(int n) { char a[n]; g(a); }",
        }.items():
            with self.subTest(why), self.assertRaisesRegex(stack.Unbounded, why):
                self.depth(source)

    def test_a_switch_of_a_library_on_armv6_m(self):
        """libgcc's division of floats jumps by a table: every way is walked, and one without a bound is refused."""
        cpu = ("arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb")
        program = compiled("float APART f(float a, float b) { return a / b; }", cpu)
        depth = stack.StackDepth(program)
        self.assertGreater(depth.of(program.functions["f"]), depth.own[program.functions["f"]])
        switches = [address for address, (name, operands, _) in program.instructions.items() if name == "mov" and operands.startswith("pc, r")]
        self.assertGreater(len(switches), 0)
        self.assertLessEqual(set(switches), depth.reached)
        with self.assertRaises(stack.Unbounded):
            unbounded = compiled('void APART f(void) { asm volatile("mov pc, r3"); }', cpu)
            stack.StackDepth(unbounded).of(unbounded.functions["f"])


class RiscvStack(unittest.TestCase):
    """Likewise for RV32IMAC, whose frames are multiples of 16 bytes."""

    def depth(self, source):
        program = compiled(source, RISCV)
        return measure.stack_depth(program).of(program.functions["f"])

    def test_known_depths(self):
        self.assertEqual(self.depth("int APART f(int a) { return a + 1; }"), 0)
        self.assertEqual(self.depth("""
            APART void g(void) { volatile char a[64]; a[0] = 1; }
            APART void h(void) { volatile char a[256]; a[0] = 1; }
            void f(void) { g(); h(); g(); }"""), 16 + 256)

    def test_a_large_frame(self):
        """Beyond what an instruction holds: the constant comes by a register."""
        for size in (2048, 4096, 10240):
            depth = self.depth(f"void APART f(void) {{ volatile char a[{size}]; a[0] = 1; }}")
            self.assertIn(depth, (size, size + 16), "the array, and a word that is rounded up")

    def test_a_switch_of_the_library_is_followed(self):
        """libgcc's division jumps by a table."""
        source = "float APART f(float a, float b) { return a / b; }"
        program = compiled(source, RISCV)
        self.assertIn("jr", {name for name, *_ in program.instructions.values()})
        self.assertGreater(self.depth(source), 16)

    def test_what_can_not_be_bounded_is_refused(self):
        for why, source in {
            "recursion: f": "int APART f(int n) { return n < 2 ? n : f(n - 1) * 3 + f(n - 2); }",
            "indirect call": "int APART f(int (*g)(int)) { return g(1) + g(2); }",
            "indirect branch": "void f(void) { asm volatile(\"jr a0\"); }",
            "unknown size": "void APART g(char* p) { asm volatile(\"\" :: \"r\"(p)); } void f(int n) { char a[n]; g(a); }",
        }.items():
            with self.subTest(why), self.assertRaisesRegex(stack.Unbounded, why):
                self.depth(source)


class Execution(unittest.TestCase):
    ENTER, LEAVE = b"Trace 0: 0x7f%02x [00000000/%08x/00/00] f\n", b"Stopped execution of TB chain before 0x7f%02x [%08x] f\n"
    TRANSLATE = b"----------------\nIN: f\n"

    def log(self, *entries):
        """Of two blocks: 16, 18 and a loop of 18 alone."""
        first = self.TRANSLATE + b"0x00000010:  b510       push     {r4, lr}\n0x00000012:  3001       adds     r0, #1\n\n"
        second = self.TRANSLATE + b"0x00000012:  3001       adds     r0, #1\n\n"
        return first + self.ENTER % (0, 16) + second + self.ENTER % (64, 18) + b"".join(entries)

    def test_a_block_stands_for_its_instructions(self):
        self.assertEqual(execution.addresses(self.log()), [16, 18, 18])
        self.assertEqual(execution.addresses(self.log(self.ENTER % (64, 18), self.ENTER % (0, 16))), [16, 18, 18, 18, 16, 18])

    def test_a_block_left_before_execution_is_not_counted(self):
        self.assertEqual(execution.addresses(self.log(self.LEAVE % (64, 18))), [16, 18])
        again = self.log(self.ENTER % (0, 16), self.LEAVE % (0, 16), self.ENTER % (0, 16), self.ENTER % (64, 18))
        self.assertEqual(execution.addresses(again), [16, 18, 18, 16, 18, 18])

    def test_a_block_translated_twice_is_as_it_was_entered(self):
        """QEMU translates a block anew, and shorter, where its buffer overflowed."""
        shorter = self.TRANSLATE + b"0x00000020:  bf00       nop\n\n"
        longer = self.TRANSLATE + b"0x00000020:  bf00       nop\n0x00000022:  bf00       nop\n\n"
        self.assertEqual(execution.addresses(self.log(longer, shorter, self.ENTER % (128, 32))), [16, 18, 18, 32])

    def test_a_trace_that_disagrees_with_the_count_is_refused(self):
        executed = [16, 18, 20] * 2
        self.assertEqual(list(execution.calls("x", executed, 16, [2, 2])), [[16, 18, 20]] * 2)
        for counts in ([2], [2, 3], [2, 2, 2]):
            with self.assertRaises(execution.Mismatch):
                list(execution.calls("x", executed, 16, counts))


class Refused(unittest.TestCase):
    """What of a build's log is the library's own refusal."""

    @staticmethod
    def log(source, sentence):
        return f"FAILED: apps/size/{source}.cpp.obj\nx.hpp:1:2: error: static assertion failed: axial: {sentence}\nninja: stopped\n"

    def test_shared_drives_and_too_many_joints_are(self):
        for sentence in ("joints that share drives have no derivatives", "derivatives in fixed point are those of up to 8 joints"):
            self.assertEqual(refused.refused(self.log("own-of-x", sentence)), ({"own-of-x": "axial: " + sentence}, True))

    def test_a_joint_that_moves_no_mass_is_named(self):
        sentence = "forward dynamics needs every joint to move some mass"
        for condition in ("note: 'axial::every_joint_moves_mass_but<2>' evaluates to false", "requirement 'every_joint_moves_mass_but<2>'"):
            said = refused.refused(self.log("own-of-x", f"{sentence}\n{condition}"))
            self.assertEqual(said, ({"own-of-x": f"axial: {sentence} (joint 2, counted from 0 at the base, moves none)"}, True))

    def test_what_else_fails_is_not(self):
        self.assertEqual(refused.refused(self.log("own-of-x", "a link has no mass")), ({}, False))


class Anew(unittest.TestCase):
    """What measuring a part again does to the committed rows and to what is said of them."""

    @staticmethod
    def row(board, scalar, instructions):
        names = {"robot": "scara", "scene": "bare", "algorithm": "bias", "scalar": scalar, "variant": "unrolled", "contract": "off"}
        return {"board": board, **names, "instructions": instructions}

    def test_rows_take_the_place_of_those_of_their_probes_alone(self):
        known = [self.row("a", "float", 1), self.row("a", "double", 2), self.row("c", "float", 3)]
        found = size.merged(known, [self.row("b", "float", 4), self.row("a", "double", 5)])
        self.assertEqual([(row["board"], row["scalar"], row["instructions"]) for row in found],
                         [("a", "float", 1), ("a", "double", 5), ("b", "float", 4), ("c", "float", 3)])

    def test_a_part_has_its_own_commit_until_the_board_has_one(self):
        part = size.anew({"a": "1"}, "a", ["bias", "fixed32"], "2")
        self.assertEqual(part, {"a": "1", "a, bias, fixed32": "2"})
        self.assertEqual(size.anew(part, "a", ["bias", "fixed32"], "3"), {"a": "1", "a, bias, fixed32": "3"})
        self.assertEqual(size.anew(part, "b", [], "3"), {**part, "b": "3"})
        self.assertEqual(size.anew(part, "a", [], "3"), {"a": "3"})


if __name__ == "__main__":
    harness.main()
