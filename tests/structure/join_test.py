"""Test sources that are compiled as one (cmake/testing/join.py): names stay apart, lines stay where they were, what can not be joined is said."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
JOIN = ROOT / "cmake/testing/join.py"
OWN = '#include <cmath>\n\nnamespace {{\nconstexpr int own = {};\n}}  // namespace\n\nstatic_assert(own == {});\n'
LIBRARY = '#include <cmath>\n\nnamespace axial::hal {{\nnamespace {{\nconstexpr int own = {};\n}}  // namespace\nstatic_assert(own == {});\n}}  // namespace axial::hal\n'


class Joined(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def join(self, *texts):
        sources = [self.folder / f"{name}_test.cpp" for name, _ in zip("abcd", texts)]
        for source, text in zip(sources, texts):
            source.write_text(text, encoding="utf-8")
        made = self.folder / "joined.cpp"
        done = subprocess.run([sys.executable, "-E", "-B", str(JOIN), str(made), *map(str, sources)], capture_output=True, text=True, check=False)
        return made, done

    def compiler(self, made):
        return subprocess.run(["g++", "-std=c++17", "-fsyntax-only", str(made)], capture_output=True, text=True, check=False)

    def test_names_of_a_source_are_its_own_in_a_namespace_of_the_library_too(self):
        made, done = self.join(OWN.format(1, 1), OWN.format(2, 2), LIBRARY.format(3, 3), LIBRARY.format(4, 4))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.compiler(made).stderr, "")
        self.assertEqual(made.read_text(encoding="utf-8").count("#include <cmath>"), 1)

    def test_a_line_that_fails_is_told_by_its_own_file_and_number(self):
        made, _ = self.join(OWN.format(1, 1), OWN.format(2, 3), LIBRARY.format(3, 4))
        said = self.compiler(made).stderr
        self.assertIn("b_test.cpp:7:", said)
        self.assertIn("c_test.cpp:7:", said)

    def test_what_can_not_be_joined_says_why(self):
        for text, why in (("#define TWO 2\nint two = TWO;\n", "directives besides #include"), ("int one = 1;\n#include <cmath>\n", "behind its first line of code")):
            _, done = self.join(OWN.format(1, 1), text)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("b_test.cpp: can not be joined", done.stderr)
            self.assertIn(why, done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
