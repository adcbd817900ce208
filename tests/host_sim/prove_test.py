#!/usr/bin/python3
"""Gappa accepts the SCARA's closed form and inverse dynamics, and refuses the first with a mistake in it.

usage: prove_test.py PROVE_SCRIPTS
Exits 77 (skipped) where gappa is not installed: `./axial prove` installs it.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SUBJECT = "scara_closed_form"


def accepts(text, seconds=20):
    """Whether Gappa finds a proof before long; it needs two seconds for the kernel as it is."""
    try:
        done = subprocess.run(["gappa", "-Eno-auto-dichotomy"], input=text, capture_output=True, text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return False
    assert done.returncode == 0 or "some properties were not satisfied" in done.stderr, done.stderr
    return done.returncode == 0


def first_goal(text):
    """The script with its first goal alone."""
    return re.sub(r"(-> *\n[^\n]*?) /\\\n.*? \}", r"\1 }", text, count=1, flags=re.DOTALL)


def scaled_bound(text, factor):
    """The first error's bound times a factor."""
    return re.sub(r"\[-([\d.e-]+),([\d.e-]+)\]", lambda m: f"[-{float(m[1]) * factor},{float(m[2]) * factor}]",
                  text[text.index("->"):], count=1)


def scripts(subject):
    """What is to be proved of a subject's errors, and of its words."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([SCRIPTS, "--output", folder, "--subject", subject], check=True)
        return [pathlib.Path(folder, f"{subject}.{kind}.g").read_text(encoding="utf-8") for kind in ("errors", "words")]


class NewtonEuler(unittest.TestCase):
    def test_errors_of_the_scara_are_accepted(self):
        errors, _ = scripts("scara_inverse_dynamics")
        self.assertTrue(accepts(errors, seconds=90))


class Mistakes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.errors, cls.words = scripts(SUBJECT)
        cls.errors = first_goal(cls.errors)

    def rounding(self, text, which, change):
        """The script with one rounding changed."""
        line = [m for m in re.finditer(r"^(p\d+) = fixed<(-\d+),dn>\((p\d+)\);$", text, re.MULTILINE)][which]
        return text.replace(line[0], change(line), 1)

    def test_the_kernel_is_accepted(self):
        self.assertTrue(accepts(self.errors))
        self.assertTrue(accepts(self.words))

    def test_half_the_bound_is_refused(self):
        begin = self.errors.index("->")
        self.assertFalse(accepts(self.errors[:begin] + scaled_bound(self.errors, 0.5)))

    def test_a_coarser_rounding_is_refused(self):
        self.assertFalse(accepts(self.rounding(self.errors, 0, lambda m: f"{m[1]} = fixed<{int(m[2]) + 3},dn>({m[3]});")))

    def test_a_wrong_shift_is_refused(self):
        """A product taken at twice its unit."""
        product = re.search(r"^(p\d+) = (v\d) \* (p\d+);$", self.errors, re.MULTILINE)
        self.assertFalse(accepts(self.errors.replace(product[0], f"{product[1]} = 1b1 * {product[2]} * {product[3]};", 1)))

    def test_a_word_too_short_is_refused(self):
        self.assertIn("2147483647b", self.words)
        self.assertFalse(accepts(re.sub(r"in \[-2147483648b(-\d+),2147483647b", r"in [-1073741824b\1,1073741823b", self.words)))


if __name__ == "__main__":
    SCRIPTS = sys.argv.pop()
    if shutil.which("gappa") is None:
        print("skipped: gappa is not installed; ./axial prove installs it")
        sys.exit(77)
    unittest.main()
