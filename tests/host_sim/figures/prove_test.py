#!/usr/bin/python3
"""Gappa accepts the SCARA's closed form and inverse dynamics and a stretch of the reciprocal, and refuses mistakes in them; where Coq
refuses a certificate another one is asked for.

usage: prove_test.py PROVE_SCRIPTS
Exits 77 (skipped) where gappa is not installed: `./axial prove` installs it.
"""
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

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


def scripts(subject, part=None):
    """What is to be proved of a subject's errors, and of its words."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([SCRIPTS, "--output", folder, "--subject", subject], check=True)
        return [pathlib.Path(folder, f"{part or subject}.{kind}.g").read_text(encoding="utf-8") for kind in ("errors", "words")]


def runner():
    """prove.py, which runs Gappa and Coq."""
    path = pathlib.Path(__file__).resolve().parents[3] / "host_sim/figures/prove/prove.py"
    spec = importlib.util.spec_from_file_location("prove", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Certificates(unittest.TestCase):
    """What Coq is asked, with a Coq that refuses whatever Gappa split as it liked."""

    def asked(self, script):
        """Whether a certificate is accepted, and the texts that were tried."""
        prove, texts = runner(), []

        def accepts_equal_splits(_, text, __):
            texts.append(text)
            return " in 32;" in text

        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(prove, "accepted_by_coq", accepts_equal_splits):
            path = pathlib.Path(folder, "script.g")
            path.write_text(script, encoding="utf-8")
            return prove.certificate(path, 1), texts

    def test_equal_splits_are_tried_where_gappas_are_refused(self):
        script = "{ x in [0,1] -> x * x in [0,1] }\nx * x $ x;\n"
        self.assertEqual(self.asked(script), (True, [script, script.replace("$ x;", "$ x in 32;")]))

    def test_without_a_split_there_is_no_other(self):
        script = "{ x in [0,1] -> x * x in [0,1] }\n"
        self.assertEqual(self.asked(script), (False, [script]))


class Expected(unittest.TestCase):
    """What the page calls unproved excuses nothing beside it."""

    def unexpected(self, result):
        return runner().unexpected({"subject": "puma560_joint3_step", "result": result, "accepted": False, "words": 1, "words_accepted": 1, "coq": None})

    def test_a_result_without_a_proof_is_excused_alone(self):
        self.assertEqual(self.unexpected("moment across"), [])
        self.assertEqual(self.unexpected("velocity across"), ["errors"])


class Step(unittest.TestCase):
    """The angular acceleration of the Puma's third link across its axis."""

    def test_the_bound_is_accepted_and_half_of_it_refused(self):
        errors, _ = scripts("puma560_joint3_step", "puma560_joint3_step-3")
        self.assertTrue(accepts(errors))
        begin = errors.index("->")
        self.assertFalse(accepts(errors[:begin] + scaled_bound(errors, 0.5)))


class Reciprocal(unittest.TestCase):
    """A 64th of a binade, so that it takes seconds."""

    @classmethod
    def setUpClass(cls):
        whole, _ = scripts("reciprocal", "reciprocal-1073741825")
        cls.errors = re.sub(r"d in \[\d+b-31,\d+b-31\]", "d in [1610612737b-31,1627389951b-31]", whole, count=1)
        assert cls.errors != whole

    def test_one_unit_is_accepted(self):
        self.assertTrue(accepts(self.errors))

    def test_a_third_of_a_unit_less_is_refused(self):
        begin = self.errors.index("->")
        self.assertFalse(accepts(self.errors[:begin] + scaled_bound(self.errors, 0.67)))

    def test_a_step_that_is_not_centred_is_refused(self):
        centred = str(2**46 + 28000)
        self.assertIn(centred, self.errors)
        self.assertFalse(accepts(self.errors.replace(centred, str(2**46))))


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
