#!/usr/bin/python3
"""./axial release: parts are measured once a commit, bounded in time, and a failure is told. usage: release_test.py"""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "cmake/release"))
import release  # noqa: E402


class Measure(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        kept = {name: getattr(release, name) for name in ("STATE", "ROOT", "parts", "commit_now", "LINE_EVERY")}
        self.addCleanup(lambda: [setattr(release, name, value) for name, value in kept.items()])
        release.STATE, release.ROOT, release.LINE_EVERY = self.folder / "state.json", self.folder, 0.1
        self.commit = "0123abcd"
        release.commit_now = lambda: self.commit

    def measure(self, *parts, only=""):
        release.parts = lambda: [(command, seconds, ["page.md"]) for command, seconds in parts]
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            return release.measure_all(only), out.getvalue()

    def test_what_is_measured_is_not_measured_again_at_that_commit(self):
        part = ("bash -c 'echo ran >>ran'", 10)
        self.assertEqual([self.measure(part)[0], self.measure(part)[0]], [0, 0])
        self.assertEqual((self.folder / "ran").read_text(), "ran\n")
        self.commit = "4567abcd"
        self.measure(part)
        self.assertEqual((self.folder / "ran").read_text(), "ran\nran\n")

    def test_a_failure_is_told_and_does_not_stop_the_others(self):
        status, said = self.measure(("bash -c 'echo why; exit 3'", 10), ("touch after", 10))
        self.assertEqual((status, (self.folder / "after").exists()), (1, True))
        self.assertIn("exit status 3", said)
        self.assertEqual((self.folder / "01.log").read_text(), "why\n")
        self.assertIn("1 of 2 parts", said)

    def test_a_part_is_bounded_and_shows_that_it_is_there(self):
        status, said = self.measure(("sleep 30", 1))
        self.assertEqual(status, 1)
        self.assertIn("not ready in", said)
        self.assertIn("sleep 30 ... ", said)

    def test_sources_that_differ_are_not_measured(self):
        self.commit = "0123abcd-dirty"
        self.assertEqual(self.measure(("touch ran", 10))[0], 2)
        self.assertFalse((self.folder / "ran").exists())


class Pages(unittest.TestCase):
    def test_every_part_names_pages_that_are_there(self):
        for command, seconds, pages in release.parts():
            self.assertTrue(pages and 0 < seconds <= 6 * 3600, command)
            for page in pages:
                self.assertTrue((release.ROOT / page).is_file(), page)


if __name__ == "__main__":
    unittest.main()
