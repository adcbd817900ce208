"""What must not be in an image of the main job: nm on the ELF."""

import re
import sys

import emulator
import harness

sys.path.insert(0, str(emulator.ROOT / "host_sim/boards/size"))
import image  # noqa: E402

FORBIDDEN = {
    "heap": r"_?(malloc|calloc|realloc|free|sbrk)(_r)?|_Zn[wa].*|_Zd[la].*",
    "formatted output": r".*printf.*|.*scanf.*|_dtoa_r|_strtod.*|puts|putchar",
    "exceptions and unwinding": r"__cxa_.*|_Unwind_.*|__gxx_personality.*|__aeabi_unwind.*|_ZSt9terminatev|_ZSt.*throw.*|abort",
    "virtual functions and run-time types": r"_ZT[VISC].*|__dynamic_cast|__cxa_pure_virtual",
    "static constructors and destructors": r"_GLOBAL__.*|__cxa_atexit|__aeabi_atexit|__cxa_guard.*",
}
SOFT_DOUBLE = r"__aeabi_(d(?!iv|iv0|ivmod|esc).*|f2d|i2d|ui2d|l2d|ul2d|h2d|cd.*)|__[a-z]*df[a-z0-9]*"
SOFT_FLOAT = r"__aeabi_(f.*|i2f|ui2f|l2f|ul2f|h2f|cf.*)|__[a-z]*sf[a-z0-9]*"


def defined(path):
    return {line.split()[-1] for line in image.run("nm", path).splitlines() if line.strip()}


def offenders(symbols, pattern):
    return sorted(name for name in symbols if re.fullmatch(pattern, name))


class Symbols(harness.BoardTest):
    def images(self):
        for robot in harness.ROBOTS:
            yield robot, defined(emulator.image(self.board, "feedforward-" + robot))

    def test_nothing_forbidden_is_linked(self):
        for robot, symbols in self.images():
            for what, pattern in FORBIDDEN.items():
                with self.subTest(robot=robot, what=what):
                    self.assertEqual(offenders(symbols, pattern), [])

    def test_no_double_arithmetic(self):
        for robot, symbols in self.images():
            with self.subTest(robot):
                self.assertEqual(offenders(symbols, SOFT_DOUBLE), [])

    def test_no_double_in_fixed_point(self):
        """What a step, a limit or a constant is made of, the compiler works out, in arms that boards integrate as well."""
        for name in (*(f"feedforward-fixed-{robot}" for robot in harness.ROBOTS), "tracking-fixed-scara", "plant-fixed-scara", "arm-fixed-scara"):
            with self.subTest(name):
                self.assertEqual(offenders(defined(emulator.image(self.board, name)), SOFT_DOUBLE), [])

    def test_float_arithmetic_is_where_it_belongs(self):
        """The FPU does it on the M4F; the others need libgcc. This also shows that the symbols are read at all."""
        for robot, symbols in self.images():
            with self.subTest(robot):
                self.assertEqual(bool(offenders(symbols, SOFT_FLOAT)), emulator.board(self.board)["cpu"] != "cortex-m4f")

    def test_an_offender_is_found(self):
        """Negative controls: an image with double kernels, and names as compilers write them."""
        kernels = defined(emulator.image("stm32f405", "kernels-scara"))
        self.assertIn("__aeabi_dmul", offenders(kernels, SOFT_DOUBLE))
        for name, what in (("_malloc_r", "heap"), ("_Znwj", "heap"), ("vfprintf", "formatted output"),
                           ("_Unwind_Resume", "exceptions and unwinding"),
                           ("_ZTV4Base", "virtual functions and run-time types")):
            self.assertEqual(offenders({name}, FORBIDDEN[what]), [name])
        for name in ("__adddf3", "__muldf3", "__aeabi_d2f", "__aeabi_f2d", "__aeabi_dcmplt"):
            self.assertEqual(offenders({name}, SOFT_DOUBLE), [name])


if __name__ == "__main__":
    harness.main()
