"""Compilers, and every public header in front of a source."""

import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
INCLUDE = ROOT / "firmware" / "include"
# integer_calls.hpp names registers of a Cortex-M0, eigen.hpp needs Eigen, and the pair of options/ is no header of its own.
LEFT_OUT = {"axial/fixed/words/integer_calls.hpp", "axial/eigen.hpp", "axial/options/begin.hpp", "axial/options/end.hpp"}


def public_headers():
    names = {str(path.relative_to(INCLUDE)) for path in INCLUDE.rglob("*.hpp")}
    return "".join(f"#include <{name}>\n" for name in sorted(names - LEFT_OUT))


def compile(command, *arguments, text=None):
    """What a compiler says; the text, where there is one, is its source."""
    return subprocess.run([*command, f"-I{INCLUDE}", f"-I{ROOT}", *map(str, arguments)], input=text, capture_output=True, text=True)
