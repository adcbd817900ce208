"""The SCARA's main job holds nothing that a SCARA does not need: no rotation in space, no articulated body, no sine of a
library. Steps are inlined, so symbols are not enough: every instruction is asked which functions it comes from.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import emulator
import harness

sys.path.insert(0, str(emulator.ROOT / "host_sim/boards/size"))
import image  # noqa: E402

LIBM = r"_*(ieee754_)?(sin|cos|tan|sincos|sqrt|fmod|rem_pio2|kernel_(sin|cos|rem_pio2))f?"
ORIGINS = {
    "articulated bodies": r"axial::(aba::|detail::aba|Articulated)",
    "composite bodies": r"axial::(crba::|mass_matrix)",
    "kinematics": r"axial::(kinematics::|forward_kinematics|jacobian)",
    "a rotation in space": r"AxialScrew<axial::XAxis, [^,]+, (?!axial::Int<0>)",
}


def symbols(path):
    return {line.split()[-1] for line in image.run("nm", path).splitlines()}


def origins(path):
    """Names of the functions from which some instruction of the image comes, inlined ones included."""
    addresses = "\n".join(map(hex, image.Image(path).instructions))
    return set(image.run("addr2line", "-i", "-f", "-C", "-e", path, input=addresses).splitlines()[::2])


def matching(names, pattern):
    return sorted(name for name in names if re.search(pattern, name))


def libm(names):
    return sorted(name for name in names if re.fullmatch(LIBM, name))


EVERY_ALGORITHM = """
#include <axial/axial.hpp>
#include <robots/scara.hpp>
using Robot = robots::Scara;
using T = axial::Joints<Robot, float>;
auto aba(const T& q, const T& qd, const T& tau) { return axial::forward_dynamics<axial::Scene<Robot, axial::ArticulatedBody>>(q, qd, tau); }
auto crba(const T& q) { return axial::mass_matrix<Robot>(q); }
auto tool(const T& q) { return axial::forward_kinematics<Robot>(q).tool; }
extern "C" void g() {}
"""


def linked(folder, source, *options):
    """A program of all that `source` defines."""
    elf = pathlib.Path(folder) / "program.elf"
    subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m3", "-mthumb", "-O2", *options, "-", "-x", "none", "-nostartfiles",
                    "--specs=nano.specs", "-Wl,-e,g", "-o", elf, "-lm"], check=True, input=source, text=True, capture_output=True)
    return elf


class Lean(harness.BoardTest):
    def path(self, name):
        return emulator.image(self.board, name)

    def test_the_scara_job_holds_what_a_scara_needs(self):
        found = origins(self.path("feedforward-scara"))
        self.assertTrue(matching(found, r"axial::rnea::"), "the origins are read at all")
        for what, pattern in ORIGINS.items():
            with self.subTest(what):
                self.assertEqual(matching(found, pattern), [])

    def test_no_image_of_the_main_job_takes_a_sine_from_a_library(self):
        for robot in harness.ROBOTS:
            self.assertEqual(libm(symbols(self.path("feedforward-" + robot))), [])

    def test_what_others_need_is_found_in_theirs(self):
        """Negative controls: a Puma turns in space; a program that calls the algorithms has them."""
        puma = origins(self.path("feedforward-puma560"))
        self.assertTrue(matching(puma, ORIGINS["a rotation in space"]))
        self.assertEqual(matching(puma, ORIGINS["articulated bodies"]), [])
        with tempfile.TemporaryDirectory(prefix="axial-") as folder:
            found = origins(linked(folder, EVERY_ALGORITHM, "-x", "c++", "-std=c++17", "-g1", "-I", emulator.ROOT / "firmware/include",
                                   "-I", emulator.ROOT))
        for what in ("articulated bodies", "composite bodies", "kinematics"):
            self.assertTrue(matching(found, ORIGINS[what]), what)

    def test_a_sine_of_the_library_is_found(self):
        """Negative control: a program that calls sinf."""
        source = "float f(float);\nfloat sinf(float);\nfloat g(float x) { return sinf(x); }\n"
        with tempfile.TemporaryDirectory(prefix="axial-") as folder:
            elf = linked(folder, source, "-x", "c")
            self.assertIn("sinf", libm(symbols(elf)))
            self.assertTrue(any("rem_pio2" in name for name in libm(symbols(elf))))


if __name__ == "__main__":
    harness.main()
