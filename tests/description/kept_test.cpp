// Lines that somebody wrote into a header by hand.
#include <host_sim/robots/description/header.hpp>
#include <host_sim/tools/system/temporary_folder.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

using description::Description;

Description two_joints() {
  Description robot;
  robot.name = "arm", robot.source = "here";
  for (const char* name : {"shoulder", "elbow"}) {
    axial::LinkParameters p;
    p.mass = 1.5, p.inertia_com[0] = p.inertia_com[1] = p.inertia_com[2] = 0.01;
    p.effort_limit = 20.0, p.speed_limit = 2.0, p.acceleration_limit = 8.0;
    robot.links.push_back({std::string(name) + "_link", name, p});
  }
  return robot;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A file that is removed again, in a folder that no test beside this one writes into.
struct File {
  host_sim::TemporaryFolder folder;
  std::string path = folder.file("arm.hpp");
  void write(const std::string& text) const { std::ofstream(path) << text; }
  static std::string read(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(name).rdbuf();
    return text.str();
  }
};

std::string inserted(std::string text, const std::string& before, const std::string& line) {
  const auto at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.insert(at == std::string::npos ? 0 : at, line);
}

constexpr const char* payload = "axial::payload_limit(2.0, 0.1, 0.05),  // kept\n      ";
constexpr const char* effort = ".effort_limit(33.5)  // kept\n          ";

std::string edited() {
  const std::string header = description::header(two_joints(), {});
  return inserted(inserted(header, "axial::gravity", payload), ".speed_limit", effort);
}

TEST(Header, SaysWhereARotorTurns) {
  Description robot = two_joints();
  auto& p = robot.links[1].parameters;
  p.rotor_inertia = 0.25, p.gear = 50.0;
  EXPECT_FALSE(says(description::header(robot, {}), "rotor_axis")) << "on its parent, about the joint's axis";
  p.rotor_axis[0] = 0.5, p.rotor_axis[2] = -1.0;
  EXPECT_TRUE(says(description::header(robot, {}), ".rotor_inertia(0.25, 50.0).rotor_axis(0.5, 0.0, -1.0)"));
  p.rotor_carrier = 0;
  EXPECT_TRUE(says(description::header(robot, {}), ".rotor_axis(0.5, 0.0, -1.0, 0)"));
  p.rotor_carrier = axial::LinkParameters::base;
  EXPECT_TRUE(says(description::header(robot, {}), ".rotor_axis(0.5, 0.0, -1.0, axial::LinkParameters::base)"));
}

TEST(Kept, LinesAreFoundByTheirJoint) {
  const auto kept = description::kept_lines(edited());
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept.at(""), std::vector<std::string>{"axial::payload_limit(2.0, 0.1, 0.05)"});
  EXPECT_EQ(kept.at("shoulder"), std::vector<std::string>{".effort_limit(33.5)"});
  EXPECT_TRUE(description::kept_lines(description::header(two_joints(), {})).empty());
}

TEST(Kept, LineReplacesWhatTheSourceGives) {
  const std::string text = description::header(two_joints(), {}, description::kept_lines(edited()));
  EXPECT_TRUE(says(text, "      axial::payload_limit(2.0, 0.1, 0.05),  // kept\n"));
  EXPECT_TRUE(says(text, "          .effort_limit(33.5),  // kept\n"));  // the link's last row
  const auto first = text.find(".effort_limit(20.0)");                   // the elbow's alone is left
  EXPECT_GT(first, text.find("elbow moves"));
  EXPECT_EQ(text.find(".effort_limit(20.0)", first + 1), std::string::npos);
  EXPECT_TRUE(says(text, "kept:     2 written by hand"));
}

TEST(Kept, SameTextComesOutAgainAndAgain) {
  const File file;
  file.write(edited());
  description::write_header(file.path, two_joints(), {});
  const std::string once = File::read(file.path);
  const auto again = description::write_header(file.path, two_joints(), {});
  EXPECT_EQ(File::read(file.path), once);
  EXPECT_TRUE(again.lost.empty());
  EXPECT_EQ(description::said_of(file.path, again),
            "kept:     axial::payload_limit(2.0, 0.1, 0.05)\nkept:     .effort_limit(33.5) at shoulder\n");
  EXPECT_TRUE(says(once, "payload_limit(2.0, 0.1, 0.05)") && says(once, "effort_limit(33.5)"));
}

TEST(Kept, OtherChangesAreSavedAndSaid) {
  const File file;
  file.write(inserted(description::header(two_joints(), {}), ".speed_limit", ".viscous(0.75)\n          "));
  const auto rewritten = description::write_header(file.path, two_joints(), {});
  EXPECT_EQ(rewritten.lost, std::vector<std::string>{".viscous(0.75)"});
  EXPECT_EQ(rewritten.before, file.path + ".before");
  EXPECT_TRUE(says(description::said_of(file.path, rewritten), "1 line of the old"));
  EXPECT_TRUE(says(description::said_of(file.path, rewritten), "  .viscous(0.75)\n"));
  EXPECT_TRUE(says(File::read(rewritten.before), ".viscous(0.75)"));
  EXPECT_FALSE(says(File::read(file.path), ".viscous(0.75)"));
}

TEST(Kept, LineOfAnotherRobotsJointIsRefused) {
  auto robot = two_joints();
  robot.links[0].joint = "waist";
  try {
    description::header(robot, {}, description::kept_lines(edited()));
    FAIL() << "not refused";
  } catch (const description::Refused& refused) {
    EXPECT_TRUE(
        says(refused.what(), "kept line '.effort_limit(33.5)' stands at joint 'shoulder', which this robot has not"));
  }
}

TEST(Kept, CallsAreTakenOutWhole) {
  const std::string row = ".mass(2.0).inertia_com(0.1, f(2), 0.3).com(1, 0, 0)";
  EXPECT_EQ(description::without(row, {"inertia_com"}), ".mass(2.0).com(1, 0, 0)");
  EXPECT_EQ(description::without(row, {"mass", "com"}), ".inertia_com(0.1, f(2), 0.3)");
  EXPECT_EQ(description::without(row, {"f"}), row);
}

}  // namespace
