// Broken descriptions: each is refused with a message that names what is wrong; none crashes.
#include <host_sim/robots/import/importer.hpp>

#include "arms.hpp"
#include "broken.hpp"

#include <gtest/gtest.h>

namespace {

using importer::Options;

using broken::Broken;
using broken::changed;
using broken::expect_says;

std::string message_of(const std::string& text, const Options& options = {}) {
  try {
    importer::import_text(text, "arm", options);
  } catch (const description::Refused& refused) {
    return refused.what();
  }
  return "";
}

constexpr Broken urdfs[] = {
    {"<robot name", "<robots name", "malformed XML"},
    {"<robot name=\"arm\">", "<robot>", "No name given for the robot"},
    {"<robot name=\"arm\">", "<robot name=\"arm\" version=\"x\">", "version"},
    {"</robot>", "", "malformed XML"},
    {"<robot name=\"arm\">", "<robot name=\"arm\"><xacro:arm prefix=\"left\"/>",
     "this is xacro, not a URDF yet: <xacro:arm>"},
    {"<mass value=\"1.5\"/>", "<mass value=\"${mass}\"/>", "this is xacro, not a URDF yet: value='${mass}'"},
    {"<robot name=\"arm\">", "<robot name=\"$(arg name)\">", "this is xacro, not a URDF yet: name='$(arg name)'"},
    {"<link name=\"fore\">", "<link name=\"upper\">", "the link name 'upper' stands twice"},
    {"<link name=\"base\"/>", "<link/>", "has no name"},
    {"<joint name=\"elbow\"", "<joint name=\"shoulder\"", "the joint name 'shoulder' stands twice"},
    {"<joint name=\"elbow\"", "<joint", "has no name"},
    {"type=\"prismatic\"", "type=\"hinge\"", "joint 'elbow': type 'hinge' is not known"},
    {" type=\"prismatic\"", "", "joint 'elbow': type '' is not known"},
    {"type=\"prismatic\"", "type=\"floating\"", "joint 'elbow' is floating"},
    {"type=\"prismatic\"", "type=\"planar\"", "joint 'elbow' is planar"},
    {"<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 1 1\"/><mimic joint=\"knee\"/>",
     "'elbow' mimics 'knee', which does not move here"},
    {"<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 1 1\"/><mimic joint=\"flange\"/>", "'flange', which does not move here"},
    {"<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 1 1\"/><mimic joint=\"elbow\"/>", "'elbow' mimics itself"},
    {"<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 1 1\"/><mimic joint=\"shoulder\" multiplier=\"0\"/>",
     "'elbow': mimics with multiplier 0"},
    {"</robot>",
     "<transmission name=\"t\"><type>x/DeltaTransmission</type><joint name=\"shoulder\"/><joint "
     "name=\"elbow\"><mechanicalReduction>"
     "1</mechanicalReduction></joint></transmission></robot>",
     "transmission 't': type 'x/DeltaTransmission' moves several joints by a law that is not known"},
    {"</robot>",
     "<transmission name=\"t\"><type>x/DifferentialTransmission</type><joint name=\"elbow\"/><joint "
     "name=\"elbow\"><mechanicalReduction>"
     "1</mechanicalReduction></joint></transmission></robot>",
     "both joints are 'elbow'"},
    {"</robot>",
     "<transmission name=\"t\"><type>x/DifferentialTransmission</type><joint name=\"shoulder\"/><joint "
     "name=\"elbow\"><mechanicalReduction>"
     "0</mechanicalReduction></joint></transmission></robot>",
     "reduction of 'elbow' is 0"},
    {"</robot>",
     "<transmission name=\"t\"><type>x/FourBarLinkageTransmission</type><joint name=\"shoulder\"/><joint "
     "name=\"elbow\"><mechanicalReduction>"
     "two</mechanicalReduction></joint></transmission></robot>",
     "mechanicalReduction is 'two'"},
    {"<child link=\"fore\"/>", "<child link=\"foot\"/>", "child link 'foot' is missing"},
    {"<parent link=\"upper\"/>", "<parent link=\"up\"/>", "parent link 'up' is missing"},
    {"<parent link=\"upper\"/>", "", "joint 'elbow': has no parent"},
    {"<child link=\"fore\"/>", "", "joint 'elbow': has no child"},
    {"<parent link=\"upper\"/>", "<parent link=\"fore\"/>", "link 'fore' is its own parent"},
    {"<parent link=\"fore\"/><child link=\"tool0\"/>", "<parent link=\"tool0\"/><child link=\"fore\"/>",
     "carried by two joints, 'elbow' and 'flange': a loop"},
    {"<parent link=\"base\"/>", "<parent link=\"tool0\"/>", "a loop"},
    {"<link name=\"base\"/>", "<link name=\"base\"/><link name=\"spare\"/>", "there are 2 roots: base, spare"},
    {"rpy=\"1.5707963267948966 0 0.4\"", "rpy=\"90 0 0.4\"", "joint 'elbow': rpy is '90 0 0.4' rad, more than a turn"},
    {"rpy=\"1.5707963267948966 0 0.4\"", "rpy=\"0 -6.2832 0.4\"", "joint 'elbow': rpy is '0 -6.2832 0.4' rad, more"},
    {"rpy=\"1.5707963267948966 0 0.4\"", "rpy=\"0 6.283 0.4\"", ""},
    {"<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 0 0\"/>", "joint 'elbow': axis is (0, 0, 0)"},
    {"<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 nan 1\"/>", "nan"},
    {"<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 1\"/>", "elbow"},
    {"xyz=\"0.25 0 0.1\"", "xyz=\"0,25 0 0,1\"", "0,25"},
    {"xyz=\"0.25 0 0.1\"", "xyz=\"1e300 0 0.1\"", "origin is beyond 1e9 m"},
    {"xyz=\"0.25 0 0.1\"", "xyz=\"1e999 0 0.1\"", "1e999"},
    {"<mass value=\"1.5\"/>", "<mass value=\"-1.5\"/>", "link 'fore': mass is negative: -1.5 kg"},
    {"<mass value=\"1.5\"/>", "<mass value=\"heavy\"/>", "inertial element for Link [fore]"},
    {"<mass value=\"1.5\"/>", "<mass value=\"1e12\"/>", "link 'fore': mass is 1e+12 kg"},
    {"<mass value=\"1.5\"/>", "", "inertial element for Link [fore]"},
    {"ixx=\"0.004\"", "", "inertial element for Link [fore]"},
    {"ixx=\"0.004\"", "ixx=\"nan\"", "inertial element for Link [fore]"},
    {"ixx=\"0.004\"", "ixx=\"1e10\"", "link 'fore': inertia is (1e+10"},
    {"lower=\"-1.5\" upper=\"1.25\"", "lower=\"1.5\" upper=\"-1.25\"",
     "limits are upside down: lower 1.5, upper -1.25"},
    {"lower=\"-1.5\" upper=\"1.25\"", "lower=\"0.5\" upper=\"0.5\"", "limits are upside down: lower 0.5, upper 0.5"},
    {"velocity=\"2\"", "velocity=\"-2\"", "joint 'shoulder': velocity limit is -2"},
    {"effort=\"10\"", "effort=\"-10\"", "joint 'shoulder': effort limit is -10"},
    {"damping=\"0.3\"", "damping=\"-0.3\"", "joint 'shoulder': viscous friction is -0.3"},
    {"friction=\"0.2\"", "friction=\"-0.2\"", "joint 'shoulder': Coulomb friction is -0.2"},
};

constexpr Broken tables[] = {
    {"\"convention\": \"modified\", ", "", "convention is ''"},
    {"\"name\": \"arm\", ", "", "name is missing"},
    {"\"d\": 0.3", "\"D\": 0.3", "the key \"D\" is not known"},
    {"\"d\": 0.3", "\"d\": 0.3, \"d\": 0.4", "the key \"d\" stands twice"},
    {"\"d\": 0.3", "\"d\": NaN", "not JSON"},
    {"\"d\": 0.3", "\"d\": 0,3", "not JSON"},
    {"\"d\": 0.3", "\"d\": \"0.3\"", "link 'upper': d is \"0.3\""},
    {"\"d\": 0.3", "\"d\": 1e999", "not JSON"},
    {"\"d\": 0.3", "\"d\": 1e300", "d is 1e+300 m"},
    {"\"type\": \"revolute\"", "\"type\": \"R\"", "type is 'R'"},
    {"\"parent\": \"upper\"", "\"parent\": \"lower\"", "no link before it is called 'lower'"},
    {"\"modified\"", "\"classical\"", "a classical table has no parent"},
    {"\"mass\": 2.5", "\"mass\": -2.5", "link 'upper': mass is negative: -2.5 kg"},
    {"[0.01, 0.02, 0.02]", "[0.01, 0.02]", "inertia_com is [0.01,0.02]"},
    {"\"theta\": 0.4", "\"theta\": 90", "theta is 90 rad, more than a turn; give radians, or degrees as theta_deg"},
    {"\"mass\": 2.5", "\"mass\": 2.5, \"inertia_origin\": [1, 1, 1]", "both inertia_com and inertia_origin are given"},
    {"\"speed_limit\": 2", "\"position_limits\": [-1, 1]", "both position_limits and position_limits_deg are given"},
    {"\"rpy_deg\": [0, 90, 0]", "\"rpy_deg\": [0, 90, 0], \"rpy\": [0, 0, 0]", "more than one of rpy, rpy_deg"},
    {"\"alpha_deg\": -90", "\"alpha_deg\": -360.001", "alpha_deg is -360.001; give -360 to 360 degrees"},
    {"\"alpha_deg\": -90", "\"alpha_deg\": 360.001", "alpha_deg is 360.001; give -360 to 360 degrees"},
    {"\"alpha_deg\": -90", "\"alpha_deg\": 360", ""},
    {"\"a test\"", "3", "source is 3; give a text in quotation marks"},
    {"\"a test\"", "\"a test\", \"notes\": 3", "notes is 3; give a list of texts"},
    {"\"a test\"", "\"a test\", \"notes\": [3]", "notes has 3; give a list of texts"},
    {"\"mass\": 1.5", "\"mass\": [1.5]", "mass is [1.5]; give a number"},
    {"\"tool\": {", "\"tool\": [], \"base\": {", "tool: is []; give an object"},
    {"\"d\": 0.3", "\"d\": [[[[[[[0.3]]]]]]]", "nested too deeply"},
    {"\"theta\": 0.4", "\"theta\": -6.2832", "theta is -6.2832 rad, more than a turn"},
    {"\"theta\": 0.4", "\"theta\": 6.283", ""},
    {"\"theta\": 0.4", "\"theta\": 0.4, \"theta_deg\": 1", "both theta and theta_deg are given"},
    {"\"viscous\": 0.3", "\"viscous\": -0.3", "viscous friction is -0.3"},
    {"[0.2, -0.1]", "[-0.2, -0.1]", "Coulomb friction is -0.2"},
    {"[-90, 80]", "[90, -80]", "limits are upside down"},
    {"\"position_limits\": [0, 0.3]", "\"position_limits_deg\": [0, 3]", "give position_limits in metres"},
    {"\"speed_limit\": 2", "\"speed_limit\": 0", "speed limit is 0"},
    {"\"rpy_deg\": [0, 90, 0]", "\"rotation\": [1, 0, 0, 0, 1, 0, 0, 0, 2]", "rotation is not orthonormal"},
    {"\"name\": \"fore\"", "\"name\": \"upper\"", "the name 'upper' is taken"},
    {"\"rotor_inertia\": 1e-5", "\"rotor_inertia\": -1e-5", "rotor inertia is -1e-05"},
};

TEST(Broken, UrdfsAreRefusedByName) {
  for (const auto& broken : urdfs)
    expect_says(message_of(changed(arms::urdf, broken)), broken.says);
}

TEST(Broken, TablesAreRefusedByName) {
  for (const auto& broken : tables)
    expect_says(message_of(changed(arms::table, broken)), broken.says);
}

TEST(Broken, ThereAreFortyOrMore) { EXPECT_GE(std::size(urdfs) + std::size(tables), 40U); }

TEST(Broken, TextsThatAreNoDescription) {
  expect_says(message_of(""), "the file is empty");
  expect_says(message_of(" \n\t"), "the file is empty");
  expect_says(message_of("hello"), "malformed XML");
  expect_says(message_of("[1, 2]"), "give an object");
  expect_says(message_of(R"({"name": "a", "convention": "modified", "links": []})"), "there are no links");
  expect_says(message_of(std::string(1000, '\0')), "not a text");
  expect_says(message_of("<gazebo version='1.2'/>"), "this is an SDF of a version before 1.3, there is no <robot>");
  std::string deep;
  for (int i = 0; i < 100000; ++i)
    deep += "<robot>";
  expect_says(message_of(deep), "nested too deeply");
  expect_says(message_of("{\"a\":" + std::string(100000, '[')), "nested too deeply");
  expect_says(message_of("<robot name='r'/>"), "there is no <link>");
  expect_says(message_of("<robot name='r'><link name='one'/></robot>"), "no joint that moves");
}

TEST(Broken, TooManyJoints) {
  std::string text = "<robot name='long'><link name='l0'/>";
  for (int i = 1; i <= 65; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    text += "<link name='l" + n + "'/><joint name='j" + n + "' type='continuous'><parent link='l" + before +
            "'/><child link='l" + n + "'/><axis xyz='0 0 1'/></joint>";
  }
  expect_says(message_of(text + "</robot>"), "there are 65 joints; import at most 64");
}

TEST(Broken, RootsAndTipsThatAreNotThere) {
  Options options;
  options.reading.tip = "tool1";
  expect_says(message_of(arms::urdf, options), "--tip: there is no link 'tool1'; links at the ends are tool0");
  options.reading = {};
  options.reading.root = "ground";
  expect_says(message_of(arms::urdf, options), "--root: there is no link 'ground'");
  options.reading.root = "fore", options.reading.tip = "upper";
  expect_says(message_of(arms::urdf, options), "link 'upper' does not hang on 'fore'");
  options.reading.root = "fore", options.reading.tip = "tool0";
  expect_says(message_of(arms::urdf, options), "no joint that moves");
}

// A validator warns, it does not refuse: published models have such bodies.
TEST(Doubtful, BodiesAreWarnedOf) {
  const auto warnings = [](const Broken& change) {
    return description::lines(importer::import_text(changed(arms::urdf, change), "arm", {}).imported.warnings, false);
  };
  expect_says(warnings({"izz=\"0.013\"", "izz=\"0.01648\"", ""}),
              "link 'fore': inertia violates the triangle inequality by 3 %");
  expect_says(warnings({"ixx=\"0.004\"", "ixx=\"-0.004\"", ""}), "link 'fore': inertia is not positive definite");
  expect_says(warnings({"ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.002\" iyz=\"0\" izz=\"0.002\"",
                        "ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"", ""}),
              "link 'tool0': has a mass of 0.5 kg and no inertia");
}

}  // namespace
