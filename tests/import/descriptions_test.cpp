// Descriptions written by others: every one is imported, and equals Orocos KDL built from the file itself.
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/importer.hpp>

#include "arms.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using importer::import_file;
using importer::import_text;
using importer::Options;

const std::string folder = AXIAL_ROOT "/tests/data/descriptions/";

nlohmann::json catalogue() { return nlohmann::json::parse(description::read_text(folder + "catalogue.json")); }

Options options_of(const nlohmann::json& entry) {
  Options options;
  options.reading.root = entry.value("root", ""), options.reading.tip = entry.value("tip", "");
  options.as_published = entry.value("as_published", false);
  options.states = 20;
  return options;
}

TEST(Descriptions, OfOthersEqualKdl) {
  int count = 0, with_bodies = 0;
  for (const auto& entry : catalogue()) {
    SCOPED_TRACE(entry["file"].get<std::string>());
    const auto result = import_file(folder + entry["file"].get<std::string>(), options_of(entry));
    EXPECT_LE(result.figures.pose, 1e-12);
    EXPECT_LE(result.figures.torque, 1e-9);
    EXPECT_LE(result.figures.mass_matrix, 1e-9);
    EXPECT_EQ(description::lines_to_accept(result.imported.warnings), "");
    for (const auto& link : result.imported.robot.links)
      if (link.parameters.mass > 0.0) {
        ++with_bodies;
        break;
      }
    ++count;
  }
  EXPECT_GE(count, 51);
  EXPECT_GE(with_bodies, 40);
}

// The comparison sees an error of 1e-9 in any of the numbers.
TEST(Verification, SeesAWrongNumber) {
  const auto table = description::parse_table(arms::table, "arm.json");
  const auto reference = importer::reference_of(arms::table, {}, 0.0);
  const auto figures_with = [&](auto change) {
    importer::Imported imported;
    imported.robot = description::to_mdh(table);
    change(imported.robot);
    imported.frames = {{importer::segment_name(1), 0, {}}, {importer::segment_name(2), 1, {}}};
    return importer::verify(imported, reference, 1, 20);
  };
  EXPECT_TRUE(figures_with([](auto&) {}).good());
  EXPECT_GT(figures_with([](auto& robot) { robot.links[1].parameters.a += 1e-9; }).pose, 1e-10);
  EXPECT_GT(figures_with([](auto& robot) { robot.tool.position[1] += 1e-9; }).pose, 1e-10);
  EXPECT_GT(figures_with([](auto& robot) { robot.links[1].parameters.mass *= 1.0001; }).torque, 1e-9);
  EXPECT_GT(figures_with([](auto& robot) { robot.links[0].parameters.inertia_com[2] *= 1.001; }).mass_matrix, 1e-9);
  EXPECT_GT(figures_with([](auto& robot) { robot.gravity.x = 0.01; }).torque, 1e-5);
}

TEST(Urdf, FixedLinksAreMerged) {
  const auto robot = import_text(arms::urdf, "arm.urdf", {}).imported.robot;
  ASSERT_EQ(robot.size(), 2);
  EXPECT_EQ(robot.links[0].joint, "shoulder");
  EXPECT_EQ(robot.links[1].name, "fore");
  EXPECT_DOUBLE_EQ(robot.links[1].parameters.mass, 2.0);
  EXPECT_EQ(robot.links[0].parameters.viscous, 0.3);
  EXPECT_EQ(robot.links[0].parameters.coulomb_backward, -0.2);
  EXPECT_EQ(robot.links[0].parameters.position_max, 1.25);
  EXPECT_EQ(robot.links[1].parameters.type, axial::JointType::prismatic);
}

// Two bodies of 1.5 and 0.5 kg, 0.1 m apart along x with equal axes: J of the pair about its centre by hand.
TEST(Urdf, MergedInertiaIsTheParallelAxisTheorems) {
  std::string text = arms::urdf;
  const auto replace = [&](const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
  };
  replace("xyz=\"0.15 0 0.01\"", "xyz=\"0 0 0\"");
  replace("xyz=\"0 0 0.05\" rpy=\"0 0 1.5707963267948966\"", "xyz=\"0 0 0\" rpy=\"0 0 0\"");
  replace("rpy=\"0 1.5708 0\"", "rpy=\"0 0 0\"");
  const auto robot = import_text(text, "arm.urdf", {}).imported.robot;
  const double across = 1.5 * 0.025 * 0.025 + 0.5 * 0.075 * 0.075;  // m r^2 about the common centre
  const double* j = robot.links[1].parameters.inertia_com;
  EXPECT_NEAR(j[0] + j[1] + j[2], (0.004 + 0.012 + 0.013) + (0.001 + 0.002 + 0.002) + 2.0 * across, 1e-15);
}

TEST(Urdf, ChainsHoldTheJointsBesideThem) {
  Options options;
  options.reading.tip = "upper";
  const auto imported = import_text(arms::urdf, "arm.urdf", options).imported;
  ASSERT_EQ(imported.robot.size(), 1);
  EXPECT_DOUBLE_EQ(imported.robot.links[0].parameters.mass, 4.5);  // carries fore and tool0 rigidly
  ASSERT_FALSE(imported.robot.notes.empty());
  EXPECT_NE(imported.robot.notes[0].find("elbow"), std::string::npos);
}

// A rod of 1 kg on a slide along z, on a link of 1 kg whose centre is at the origin.
TEST(Urdf, HeldJointsStandAtTheirNearestLimit) {
  const auto com_with = [](const std::string& limits, const std::string& mimic, bool hold_mimic) {
    const std::string body =
        "<inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>";
    const std::string text =
        "<robot name='r'><link name='base'/><link name='arm'>" + body + "</link><link name='rod'>" + body +
        "</link><joint name='turn' type='continuous'><parent link='base'/><child link='arm'/><axis xyz='0 1 0'/>"
        "</joint><joint name='slide' type='prismatic'><parent link='arm'/><child link='rod'/><axis xyz='0 0 1'/>" +
        limits + mimic + "</joint></robot>";
    Options options;
    options.reading.hold_mimic = hold_mimic;
    if (!hold_mimic) options.reading.tip = "arm";
    const auto result = import_text(text, "r.urdf", options);
    EXPECT_TRUE(result.figures.good()) << limits << mimic;
    EXPECT_EQ(result.imported.robot.size(), 1);
    const auto& com = result.imported.robot.links[0].parameters.com;
    return std::hypot(com[0], std::hypot(com[1], com[2]));
  };
  const auto limit = [](const std::string& lower, const std::string& upper) {
    return "<limit lower='" + lower + "' upper='" + upper + "' velocity='1' effort='1'/>";
  };
  EXPECT_NEAR(com_with(limit("0.1", "0.4"), "", false), 0.05, 1e-12);
  EXPECT_NEAR(com_with(limit("-0.4", "-0.2"), "", false), 0.1, 1e-12);
  EXPECT_NEAR(com_with(limit("-0.4", "0.2"), "", false), 0.0, 1e-12);
  const std::string mimic = "<mimic joint='turn' multiplier='2' offset='0.9'/>";
  EXPECT_NEAR(com_with(limit("0.1", "0.4"), mimic, true), 0.2, 1e-12);
  EXPECT_NEAR(com_with(limit("0.1", "1.4"), mimic, true), 0.45, 1e-12);
  EXPECT_NEAR(com_with("<limit velocity='1' effort='1'/>", mimic, true), 0.45, 1e-12) << "without limits";
}

TEST(Urdf, MimicJointsAreHeldWhereAsked) {
  std::string text = arms::urdf;
  const std::string axis = "<axis xyz=\"0 1 1\"/>";
  text.replace(text.find(axis), axis.size(), axis + "<mimic joint=\"shoulder\" multiplier=\"2\" offset=\"0.25\"/>");
  Options options;
  options.reading.hold_mimic = true;
  const auto result = import_text(text, "arm.urdf", options);  // its KDL holds the elbow where the offset says
  EXPECT_TRUE(result.figures.good());
  const auto& robot = result.imported.robot;
  ASSERT_EQ(robot.size(), 1);
  EXPECT_DOUBLE_EQ(robot.links[0].parameters.mass, 4.5);
  ASSERT_FALSE(robot.notes.empty());
  EXPECT_NE(robot.notes[0].find("mimic another one are held where that one is 0"), std::string::npos);
  // The slide of 0.25 m along (0, 1, 1) moves fore and tool0, 2 kg of 4.5.
  std::string unmoved = text;
  unmoved.replace(unmoved.find("offset=\"0.25\""), 13, "offset=\"0\"");
  const auto other = import_text(unmoved, "arm.urdf", options).imported.robot;
  double moved = 0.0;
  for (int k = 0; k < 3; ++k)
    moved = std::hypot(moved, robot.links[0].parameters.com[k] - other.links[0].parameters.com[k]);
  EXPECT_NEAR(moved, 0.25 * 2.0 / 4.5, 1e-12);
}

/// q = G u + q0 as the laws of the file say, by hand: four-bar, differential with a reduction of 2, mimic.
TEST(Urdf, JointsThatShareDrivesEqualKdlUnderTheirLaws) {
  const auto result = import_file(AXIAL_ROOT "/tests/import/coupled_arm.urdf", {});
  EXPECT_TRUE(result.figures.good());
  const auto& robot = result.imported.robot;
  const auto g = description::drive_matrix(robot);
  ASSERT_EQ(robot.size(), 7);
  ASSERT_EQ(g.drives, 6);
  const double rows[7][6] = {{1, 0, 0, 0, 0, 0},     {0, 1, 0, 0, 0, 0},        {0, -1, 1, 0, 0, 0},
                             {0, 0, 0, 0.5, 0.5, 0}, {0, 0, 0, 0.25, -0.25, 0}, {0, 0, 0, 0, 0, 1},
                             {0, 0, 0, 0, 0, 1.25}};
  for (int i = 0; i < 7; ++i)
    for (int k = 0; k < 6; ++k)
      EXPECT_EQ(g.ratio[i][k], rows[i][k]) << i << k;
  EXPECT_EQ(g.offset[6], -0.002);
  const auto& roll = robot.links[4].parameters;
  EXPECT_NEAR(roll.drive_max, 1.7 + 2.0 * 3.0, 1e-12) << "u = q_pitch - 2 q_roll at most";
  EXPECT_NEAR(roll.drive_speed_limit, 6.0 + 2.0 * 6.0, 1e-12);
  EXPECT_DOUBLE_EQ(robot.links[5].parameters.viscous, 4.0 + 1.25 * 1.25 * 4.0) << "of both fingers";
  EXPECT_FALSE(std::isfinite(roll.effort_limit)) << "the file's is the joint's";
}
TEST(Urdf, HeaderTellsTheFileAndNotItsFolder) {
  const auto urdf = import_text(arms::urdf, "/home/somebody/arms/arm.urdf", {}).imported.robot;
  EXPECT_EQ(urdf.source.find("arm.urdf (URDF)"), 0U) << urdf.source;
  std::string table = arms::table;
  const std::string source = "\"source\": \"a test\", ";
  table.erase(table.find(source), source.size());
  EXPECT_EQ(import_text(table, "/home/somebody/arms/arm.json", {}).imported.robot.source, "arm.json");
}

TEST(Urdf, ExpandedXacroMayDeclareItsNamespace) {
  std::string text = arms::urdf;
  text.insert(text.find(" name=\"arm\""), " xmlns:xacro=\"http://www.ros.org/wiki/xacro\"");
  EXPECT_EQ(import_text(text, "arm.urdf", {}).imported.robot.size(), 2);
}

TEST(Urdf, RightAnglesAreReadFromFewDigits) {
  std::string text = arms::urdf;
  const std::string angle = "1.5707963267948966 0 0.4";
  text.replace(text.find(angle), angle.size(), "1.5708 0 0");
  text.replace(text.find("xyz=\"0 1 1\""), 11, "xyz=\"0 1 0\"");
  const auto robot = import_text(text, "arm.urdf", {}).imported.robot;
  EXPECT_EQ(robot.links[1].parameters.alpha.sin, 0.0);  // two axes along the vertical
  Options as_written;
  as_written.reading.right_angles = 0.0;
  EXPECT_NE(import_text(text, "arm.urdf", as_written).imported.robot.links[1].parameters.alpha.sin, 0.0);
}

TEST(Urdf, MissingLimitsAreNamedAsAssumptions) {
  const auto robot = import_text(arms::urdf, "arm.urdf", {}).imported.robot;
  EXPECT_EQ(robot.links[0].parameters.acceleration_limit, 8.0);  // 2 rad/s in 0.25 s
  bool named = false;
  for (const auto& assumption : robot.assumptions)
    named = named || assumption.find("acceleration limits that reach full speed in 0.25 s: shoulder, elbow") == 0;
  EXPECT_TRUE(named);
}

}  // namespace
