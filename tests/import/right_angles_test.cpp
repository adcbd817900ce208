// Angles that are nearly right: named, and made exact where that is asked for. Numbers that no robot should have: kept
// only where asked.
#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/import/importer.hpp>
#include <host_sim/robots/import/right_angles.hpp>

#include "arms.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using importer::Options;
using importer::Result;

std::string changed(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}
Result imported(const std::string& text, bool snap = false) {
  Options options;
  options.reading.snap = snap;
  const auto result = importer::import_text(text, "arm", options);
  EXPECT_TRUE(result.figures.good());
  return result;
}
std::string warnings(const Result& result) { return description::lines(result.imported.warnings, false); }
std::string notes(const Result& result) {
  std::string text;
  for (const auto& note : result.imported.robot.notes)
    text += note + "\n";
  return text;
}
const axial::LinkParameters& fore(const Result& result) { return result.imported.robot.links[1].parameters; }
bool says(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

/// The sound arm with its elbow's axis along y of a frame that is turned by this about x: a vertical slide where it is
/// 90 degrees.
std::string urdf_with(const std::string& roll) {
  const auto text = changed(arms::urdf, "rpy=\"1.5707963267948966 0 0.4\"", "rpy=\"" + roll + " 0 0\"");
  return changed(text, "xyz=\"0 1 1\"", "xyz=\"0 1 0\"");
}
std::string table_with(const std::string& row) {
  return changed(arms::table, "\"alpha_deg\": -90, \"theta\": 0.4", row);
}

TEST(LengthDigit, IsTheLongestLengthsByAsManyDigitsAsAnyHas) {
  const auto value = [](const std::vector<std::pair<std::string, double>>& lengths) {
    importer::LengthDigit digit;
    for (const auto& [written, length] : lengths)
      digit.see(written, length);
    return digit.value();
  };
  EXPECT_EQ(value({}), 0.0);
  EXPECT_EQ(value({{"0.4318", 0.4318}}), 1e-6) << "at most";
  EXPECT_DOUBLE_EQ(value({{"-0.43182954", -0.43182954}}), 0.43182954e-8);
  for (const bool turned : {false, true}) {
    std::vector<std::pair<std::string, double>> both{{"0.043182954e1", 0.43182954}, {"2.5", 2.5}};
    if (turned) std::swap(both[0], both[1]);
    EXPECT_DOUBLE_EQ(value(both), 2.5e-8);
  }
}
TEST(NearlyRight, UrdfNamesJointAndRemedy) {
  const auto written = imported(urdf_with("1.57"));
  EXPECT_TRUE(says(warnings(written), "joint 'elbow': roll of 1.57 rad is 0.0008 rad off a multiple of 90 degrees"));
  EXPECT_TRUE(says(warnings(written), "--snap"));
  EXPECT_NE(fore(written).alpha.sin, 0.0);
}

TEST(NearlyRight, UrdfSnapsExactly) {
  const auto snapped = imported(urdf_with("1.57"), true);
  EXPECT_FALSE(says(warnings(snapped), "elbow"));
  EXPECT_TRUE(says(notes(snapped), "the farthest by 0.0008"));
  EXPECT_EQ(fore(snapped).alpha.sin, 0.0);
  EXPECT_TRUE(says(description::header(snapped.imported.robot, {}), "prismatic().a(0.25)"));
}

/// An arm whose elbow's frame is turned by so much about x.
std::string mjcf_with(const std::string& roll) {
  const std::string body = "<inertial pos='0.1 0 0' mass='1' diaginertia='0.01 0.01 0.01'/>";
  return "<mujoco><compiler angle='radian'/><worldbody><body name='upper'>" + body +
         "<joint name='shoulder' axis='0 0 1'/><body name='fore' pos='0.3 0 0' euler='" + roll + " 0 0'>" + body +
         "<joint name='elbow' axis='0 0 1'/></body></body></worldbody></mujoco>";
}

// What is made exact is further from what is written than angles that are read as right without being asked.
TEST(NearlyRight, MjcfSnapsExactly) {
  const auto read = [](const std::string& roll, bool snap) {
    Options options;
    options.reading.snap = snap;
    const auto result = importer::import_text(mjcf_with(roll), "arm.xml", options);
    EXPECT_TRUE(result.figures.good()) << roll;
    EXPECT_LE(result.figures.changed_angle, result.figures.changed_angle_bound);
    return result;
  };
  const auto written = read("1.5738", false), snapped = read("1.5738", true), beyond = read("1.5763", true);
  EXPECT_TRUE(says(warnings(written), "joint 'elbow': its axis or frame is 0.003 rad off a multiple of 90 degrees"));
  EXPECT_TRUE(says(warnings(written), "--snap"));
  EXPECT_FALSE(says(warnings(snapped) + warnings(beyond), "off a multiple"));
  EXPECT_NE(fore(written).alpha.cos, 0.0);
  EXPECT_NEAR(written.figures.changed_angle, 0.0, 1e-15);
  EXPECT_EQ(fore(snapped).alpha.cos, 0.0);
  EXPECT_NEAR(snapped.figures.changed_angle, -std::cos(1.5738), 1e-9);
  EXPECT_NE(fore(beyond).alpha.cos, 0.0) << "meant so";
  EXPECT_NEAR(beyond.figures.changed_angle, 0.0, 1e-15);
}

TEST(NearlyRight, IsWithinFiveThousandths) {
  EXPECT_TRUE(says(warnings(imported(urdf_with("1.5756963"))), "elbow")) << "0.0049 beyond";
  EXPECT_TRUE(says(warnings(imported(urdf_with("1.5658963"))), "elbow")) << "0.0049 before";
  EXPECT_FALSE(says(warnings(imported(urdf_with("1.5758963"))), "elbow")) << "0.0051 beyond";
  EXPECT_NE(fore(imported(urdf_with("1.5758963"), true)).alpha.sin, 0.0) << "meant so";
  EXPECT_FALSE(says(warnings(imported(urdf_with("1.5708"))), "elbow")) << "read as right without being asked";
  EXPECT_FALSE(says(warnings(imported(urdf_with("1.5707963267948966"))), "elbow"));
  EXPECT_TRUE(says(warnings(imported(urdf_with("0.001"))), "elbow")) << "0 is a multiple too";
}

TEST(NearlyRight, AxesOfUrdfs) {
  const auto text = changed(urdf_with("1.5707963267948966"), "xyz=\"0 1 0\"", "xyz=\"0 2 0.002\"");
  EXPECT_TRUE(
      says(warnings(imported(text)), "joint 'elbow': the axis' angle to an axis of its frame is 0.001 rad off"));
  const auto snapped = imported(text, true);
  EXPECT_FALSE(says(warnings(snapped), "elbow"));
  EXPECT_EQ(fore(snapped).alpha.sin, 0.0);
  EXPECT_FALSE(says(warnings(imported(changed(arms::urdf, "xyz=\"0 1 1\"", "xyz=\"0 1 0.01\""))), "axis"));
}

TEST(NearlyRight, RowsOfModifiedTables) {
  const auto text = table_with(R"("alpha_deg": -89.9, "theta": 1.57, "gamma": 3.1406)");
  const auto written = warnings(imported(text));
  EXPECT_TRUE(says(written, "link 'fore': joint 'joint2': alpha of -1.56905 rad is 0.0017 rad off"));
  EXPECT_TRUE(says(written, "theta of 1.57 rad is 0.0008 rad off"));
  EXPECT_TRUE(says(written, "gamma of 3.1406 rad is 0.00099 rad off"));
  const auto snapped = imported(text, true);
  EXPECT_FALSE(says(warnings(snapped), "off a multiple"));
  EXPECT_TRUE(
      says(notes(snapped), "3 angles were read as the multiples of 90 degrees that they are within 0.005 rad of"));
  EXPECT_EQ(description::exact_degrees(fore(snapped).alpha).value(), -90.0);
  EXPECT_EQ(fore(snapped).alpha.cos, 0.0);
  EXPECT_EQ(fore(snapped).theta.cos, 0.0);
  EXPECT_EQ(fore(snapped).gamma.sin, 0.0);
  EXPECT_TRUE(says(description::header(snapped.imported.robot, {}), ".alpha_deg(-90)"));
  EXPECT_FALSE(says(warnings(imported(table_with(R"("alpha_deg": -89.7)"))), "off a multiple")) << "0.0052 rad";
  EXPECT_FALSE(says(warnings(imported(arms::table)), "off a multiple"));
}

TEST(NearlyRight, ClassicalTablesAndTools) {
  auto text = changed(arms::table, "\"modified\"", "\"classical\"");
  text = changed(changed(text, "\"parent\": \"upper\", ", ""), "\"alpha_deg\": -90", "\"alpha\": -1.5720");
  text = changed(text, "\"rpy_deg\": [0, 90, 0]", "\"rpy\": [0, 1.57, 0]");
  const auto written = warnings(imported(text));
  EXPECT_TRUE(says(written, "joint 'joint2': alpha of -1.572 rad"));
  EXPECT_TRUE(says(written, "the rotation of tool is 0.0008 rad off"));
  const auto snapped = imported(text, true);
  EXPECT_FALSE(says(warnings(snapped), "off a multiple"));
  EXPECT_TRUE(says(notes(snapped), "angles were read as the multiples of 90 degrees"));
  for (const double entry : snapped.imported.robot.tool.rotation)
    EXPECT_TRUE(entry == 0.0 || entry == 1.0 || entry == -1.0) << entry;
}

TEST(AsPublished, IsAskedForAndSaidInTheHeader) {
  const auto text = changed(arms::table, "[0.01, 0.02, 0.02]", "[0.01, 0.02, 0.0316]");  // 5.3 % too much
  const auto doubtful = imported(text).imported;
  EXPECT_TRUE(says(description::lines_to_accept(doubtful.warnings),
                   "link 'upper': inertia violates the triangle inequality by 5.33 %"));
  EXPECT_THROW(description::header(doubtful.robot, {}), description::Refused);
  Options options;
  options.as_published = true;
  const auto kept = importer::import_text(text, "arm", options).imported;
  EXPECT_EQ(description::lines_to_accept(kept.warnings), "");
  const auto header = description::header(kept.robot, {});
  EXPECT_TRUE(says(header, ".inertia_com(0.01, 0.02, 0.0316).accept(axial::as_published)"));
  EXPECT_TRUE(says(header, "5.33 %"));
  const auto little = imported(changed(arms::table, "[0.01, 0.02, 0.02]", "[0.01, 0.02, 0.0314]")).imported;
  EXPECT_EQ(description::lines_to_accept(little.warnings), "");
  EXPECT_FALSE(says(description::header(little.robot, {}), "accept"));
}

// The frame of the second joint is the first one's; its axis is nearly that frame's z.
TEST(NearlyRight, AnAxisIsSettledInAFrameThatIsRightToo) {
  const Result arm = imported(
      "<mujoco><worldbody><body><joint/><geom size='0.1'/><body pos='0.3 0 0'><joint axis='0.000004 0 1'/>"
      "<geom size='0.1' pos='0.2 0 0'/></body></body></worldbody></mujoco>");
  const auto& elbow = fore(arm);
  EXPECT_EQ(elbow.alpha.sin, 0.0);
  EXPECT_EQ(elbow.a, 0.3);
}

TEST(AsPublished, IsForEverythingThatAxialCompilesOnlyThen) {
  const auto to_accept = [](const char* what, const char* by) {
    return description::lines_to_accept(imported(changed(arms::table, what, by)).imported.warnings);
  };
  EXPECT_TRUE(says(to_accept("\"mass\": 2.5, ", ""), "has an inertia and a mass of 0 kg"));
  EXPECT_TRUE(says(to_accept("\"d\": 0.3", "\"d\": 300"), "d is 300 m"));
  EXPECT_TRUE(says(to_accept("\"com\": [0.1, 0, 0]", "\"com\": [100.1, 0, 0]"), "centre of mass is beyond 100 m"));
  EXPECT_TRUE(says(to_accept("\"position_limits\": [0, 0.3]", "\"position_limits\": [0, 300]"), "beyond 100 m"));
  EXPECT_TRUE(
      says(to_accept("\"position_limits_deg\": [-90, 80]", "\"position_limits\": [-90, 80]"), "look like degrees"));
  EXPECT_TRUE(
      says(to_accept("\"xyz\": [0, 0, 0.1]", "\"xyz\": [0, 0, 101]"), "the base or the tool is more than 100 m away"));
}

}  // namespace
