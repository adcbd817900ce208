#!/usr/bin/python3
"""robots/gallery's pages, pictures and list are what gallery.py writes from the headers that stand there; the pictures' chains are the machines'.

usage: gallery_pages.py ROOT
"""
import math
import pathlib
import sys
import unittest

ROOT = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(ROOT / "host_sim/robots/import/measured"))
import chains  # noqa: E402
import gallery  # noqa: E402

MACHINES = {entry["name"]: entry for entry in gallery.entries()}


def chain(name):
    return chains.Chain(gallery.text_of(MACHINES[name]))


class Pages(unittest.TestCase):
    def test_are_as_the_headers(self):
        for path, text in gallery.pages(list(MACHINES.values())):
            self.assertEqual(path.read_text(encoding="utf-8"), text, f"{path}: run host_sim/robots/import/measured/gallery.py --pages")

    def test_every_header_is_a_machine(self):
        headers = {str(path.relative_to(ROOT)) for path in gallery.GALLERY.glob("*/*.hpp")}
        self.assertEqual(headers, {entry["header"] for entry in MACHINES.values()})
        self.assertGreaterEqual(len(headers), 40)

    def test_every_machine_says_whose_numbers_it_has(self):
        for name, entry in MACHINES.items():
            text = gallery.text_of(entry)
            for said in (entry["repository"], entry["commit"][:12], entry["licence"], "// assumed:  ", "// verified: "):
                self.assertIn(said, text, name)

    def test_every_room_shows_its_sheet(self):
        for page in gallery.GALLERY.glob("*/README.md"):
            self.assertIn("](chains.svg)", page.read_text(encoding="utf-8"), page)


class Chains(unittest.TestCase):
    def test_have_every_joint(self):
        for name, entry in MACHINES.items():
            self.assertEqual(len(chain(name).links), gallery.text_of(entry).count(" moves "), name)

    def test_reach_as_far_as_the_maker_of_the_ur5e_says(self):
        """His Denavit-Hartenberg table, to its centimetres: at 0 the arm is straight, the tool below the shoulder and beside the plane."""
        position = chain("ur5e").poses([0.0] * 6)[1][1]
        self.assertAlmostEqual(max(map(abs, position[:2])), 0.425 + 0.392, 2)
        self.assertAlmostEqual(min(map(abs, position[:2])), 0.133 + 0.100, 2)
        self.assertAlmostEqual(position[2], 0.1625 - 0.0997, 2)

    def test_of_a_scara_turn_in_its_plane(self):
        """The law of cosines between the axes of joints 2 and 4, 0.2 m each from the elbow's."""
        poses, _ = chain("m1_pro").poses([0.1, 0.3, math.pi / 2, 0.0])
        shoulder, wrist = poses[1][1], poses[3][1]
        self.assertAlmostEqual(math.dist(shoulder[:2], wrist[:2]), 0.2 * math.sqrt(2 + 2 * math.cos(math.pi / 2 - 0.0342)), 4)

    def test_of_the_gripper_mirror_each_other_and_keep_their_tips_parallel(self):
        gripper = chain("robotiq_2f85")
        poses, _ = gripper.poses()
        left, right = poses[1], poses[3]
        self.assertEqual(gripper.position(0), 0.5)
        for i, sign in enumerate((-1, 1, 1)):
            self.assertAlmostEqual(left[1][i], sign * right[1][i], 6)
        closed = gripper.poses([0.0] * 6)[0]
        for now, before in zip(left[0], closed[1][0]):
            for a, b in zip(now, before):
                self.assertAlmostEqual(a, b, 9)

    def test_are_on_scale(self):
        self.assertEqual([chains.scale_bar(reach) for reach in (0.3, 0.59, 0.61, 1.49, 1.51)], [0.1, 0.1, 0.2, 0.2, 0.5])
        drawn = chains.sheet({"m1_pro": chain("m1_pro")})
        self.assertEqual((drawn.count('class="prismatic"'), drawn.count('class="revolute"')), (1, 3))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
