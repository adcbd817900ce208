// What a header's robot is called, and what it took for granted, by the comments of the header.
#include <gtest/gtest.h>

#include <host_sim/robots/description/own_comments.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

description::Description of_header(const std::string& text) {
  auto path = (std::filesystem::temp_directory_path() / "axial-XXXXXX").string();  // tests run side by side
  EXPECT_NE(mkdtemp(path.data()), nullptr);
  const std::filesystem::path folder = path;
  const auto header = folder / "my_arm.hpp";
  std::ofstream(header) << text;
  description::Description robot;
  robot.links.resize(2);
  description::take_comments(robot, header.string());
  std::filesystem::remove_all(folder);
  return robot;
}

using Lines = std::vector<std::string>;

TEST(OwnComments, NameJointsAndLinksAndNoFolder) {
  const auto robot = of_header(
      "#pragma once\n      // 0: shoulder moves upper arm\n// 1: elbow moves forearm\n// 2: wrist moves hand\n");
  EXPECT_EQ(robot.source, "my_arm.hpp");
  EXPECT_EQ(robot.links[0].joint, "shoulder");
  EXPECT_EQ(robot.links[0].name, "upper arm");
  EXPECT_EQ(robot.links[1].joint, "elbow");
  EXPECT_EQ(robot.links[1].name, "forearm");
}

TEST(OwnComments, GiveNotesAndAssumptionsLineByLine) {
  const auto robot = of_header(
      "// arm: 2 joints, MDH frames.\n//\n// source:   arm.urdf\n// read:     gripper fixed: welded\n"
      "//           to the hand\n// read:     tip: tool0\n// assumed:  gravity of 9.81 m/s^2\n"
      "// assumed:  no rotor inertias: a URDF has none\n// fitted:   friction\n//           of both\n"
      "#pragma once\n// assumed:  of another comment\n");
  EXPECT_EQ(robot.notes, (Lines{"gripper fixed: welded to the hand", "tip: tool0"}));
  EXPECT_EQ(robot.assumptions, (Lines{"gravity of 9.81 m/s^2", "no rotor inertias: a URDF has none"}));
}

TEST(OwnComments, OfAHandGoOnWithoutAnIndentUntilTheirSentenceEnds) {
  const auto robot = of_header(
      "// assumed: every length; the values are\n// those of a drawing.\n// Rows are rewritten here.\n//\n"
      "//   not of them\n#pragma once\n");
  EXPECT_EQ(robot.assumptions, (Lines{"every length; the values are those of a drawing."}));
}

}  // namespace
