// MJCF: what MuJoCo makes of two made-up files, and what each element means, by hand.
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/importer.hpp>
#include <host_sim/robots/import/mjcf/mjcf_reader.hpp>

#include <axial/axial.hpp>

#include "trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace {

using importer::Options;
using importer::Result;
using trees::expect_near;
using trees::joint;
using trees::link;
using trees::said;
using trees::says;

constexpr double pi = 3.14159265358979323846, tight = 1e-13;

const std::string folder = std::string(AXIAL_ROOT) + "/tests/import/mjcf/";

importer::EngineTree read(const std::string& text, const importer::ReadingOptions& options = {}) {
  return importer::read_mjcf(text, folder + "test.xml", options);
}
importer::EngineTree read_bodies(const std::string& bodies, const std::string& before = "") {
  return read("<mujoco>" + before + "<worldbody>" + bodies + "</worldbody></mujoco>");
}
Result imported(const std::string& text, const Options& options = {}) {
  return importer::import_text(text, folder + "test.xml", options);
}
// --- against MuJoCo: the answers are committed. AXIAL_MUJOCO=FOLDER, that of the package mujoco-js, writes them anew.

constexpr unsigned seed = 3;
constexpr int states = 3;

std::string answer_of(const std::string& name, const importer::EngineTree& found) {
  const std::string path = folder + name + ".json";
  if (const char* package = std::getenv("AXIAL_MUJOCO"); package != nullptr) {
    const std::string questions = testing::TempDir() + name + "_questions.json";
    std::ofstream(questions) << importer::engine_questions(folder + name + ".xml", found, seed, states);
    const std::string command = std::string("node ") + AXIAL_ROOT + "/host_sim/robots/import/mjcf/mujoco.mjs " +
                                package + " " + questions + " " + path;
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
  return description::read_text(path);
}
importer::EngineFigures figures_of(const std::string& text, const std::string& answer) {
  return importer::compared_with_engine(read(text), seed, states, answer);
}

TEST(Mjcf, IsWhatMujocoMakesOfIt) {
  for (const std::string name : {"arm", "floating"}) {
    const std::string text = description::read_text(folder + name + ".xml");
    const auto figures = figures_of(text, answer_of(name, read(text)));
    EXPECT_EQ(figures.engine, "MuJoCo 3.3.8");
    EXPECT_EQ(figures.bound, 1e-6);  // it diagonalises inertias of both
    EXPECT_TRUE(figures.good()) << figures.line();
    EXPECT_LT(figures.pose, 1e-13);
    EXPECT_LT(figures.torque, 1e-8);
    EXPECT_LT(figures.mass_matrix, 1e-8);
  }
}

TEST(Mjcf, AnAnswerThatIsNoneIsSaid) {
  const std::string text = description::read_text(folder + "arm.xml");
  for (const std::string answer : {"", "{}", "[1]", "{\"states\": 3}"})
    EXPECT_EQ(figures_of(text, answer).line(), "not against MuJoCo itself: its answer is none") << answer;
  EXPECT_EQ(figures_of(text, R"({"refused": "no"})").line(), "not against MuJoCo itself: it refuses the file: no");
}

/// Each number of a text behind a place: where it stands, and how long it is.
std::vector<std::pair<std::size_t, std::size_t>> numbers_of(const std::string& text, std::size_t from) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = from; i < text.size(); ++i) {
    if ((text[i - 1] != '"' && text[i - 1] != ' ') || text[i] == ' ') continue;
    char* end = nullptr;
    std::strtod(&text[i], &end);
    const auto length = static_cast<std::size_t>(end - &text[i]);
    if (length > 0 && (*end == '"' || *end == ' ')) found.emplace_back(i, length), i += length;
  }
  return found;
}
std::string attribute_at(const std::string& text, std::size_t at) {
  const auto equals = text.rfind("=\"", at), space = text.find_last_of(" \n", equals);
  return text.substr(space + 1, equals - space - 1);
}

// Two thousandths in any number of a body: MuJoCo's answer is of another arm.
TEST(Mjcf, AnyNumberIsRead) {
  const std::string text = description::read_text(folder + "arm.xml"), answer = answer_of("arm", read(text));
  const auto first = text.find("<frame pos"), last = text.find("<equality>");
  int count = 0;
  for (const auto& [at, length] : numbers_of(text, first)) {
    if (at > last) break;
    const std::string attribute = attribute_at(text, at);
    if (attribute == "actuatorfrcrange") continue;  // a limit of effort, which MuJoCo's joint alone does not tell
    const double value = std::stod(text.substr(at, length)), by = attribute == "euler" ? 0.1 : 0.002;  // degrees
    std::string other = text;
    other.replace(at, length, std::to_string(value + (value < 0.0 ? -by : by)));
    bool passes = false;
    try {
      passes = figures_of(other, answer).good();
    } catch (const description::Refused&) {
    }
    EXPECT_FALSE(passes) << attribute << " at '" << text.substr(at, 40) << "'";
    ++count;
  }
  EXPECT_GT(count, 120);
}

TEST(Mjcf, TheDescriptionIsTheTree) {
  for (const std::string name : {"arm", "floating"}) {
    const auto result = importer::import_file(folder + name + ".xml", {});
    EXPECT_TRUE(result.figures.good());
    EXPECT_TRUE(result.figures.engine.engine.empty());
    EXPECT_TRUE(says(result.figures.lines().back(), "not against MuJoCo itself: it is not here"));
  }
}

// --- by hand

// m l^2 + 2/5 m r^2 + armature about the axis; a torque that holds it, and one that speeds it up.
TEST(Mjcf, APendulumIsThatOfTheTextbook) {
  const auto result = imported(
      "<mujoco><option gravity='0 0 -10'/><worldbody><body><joint axis='0 1 0' armature='0.3'/>"
      "<geom size='0.1' mass='2' pos='0.5 0 0'/></body></worldbody></mujoco>");
  using Model = axial::Model<description::most_links, axial::Gravity, axial::RotorInertia, axial::SharedDrives>;
  const auto model = description::to_model<Model>(result.imported.robot);
  axial::Joints<Model, double> q{}, qd{}, qdd{};
  q[0] = 0.4, qdd[0] = 1.5;
  const double inertia = 2.0 * 0.25 + 0.4 * 2.0 * 0.01 + 0.3;
  EXPECT_NEAR(axial::inverse_dynamics(model, q, qd, qdd)[0], inertia * 1.5 - 2.0 * 10.0 * 0.5 * std::cos(0.4), tight);
}

TEST(Mjcf, AnglesAreDegreesUnlessTheCompilerSaysRadians) {
  const std::string body = "<body><joint name='j' range='-90 45'/><geom size='0.1'/></body>";
  EXPECT_NEAR(joint(read_bodies(body), "j").lower, -pi / 2.0, tight);
  EXPECT_NEAR(joint(read_bodies(body, "<compiler angle='radian'/>"), "j").upper, 45.0, tight);
  const std::string slide = "<body><joint name='j' type='slide' range='-0.5 0.25'/><geom size='0.1'/></body>";
  EXPECT_EQ(joint(read_bodies(slide), "j").lower, -0.5);
}

TEST(Mjcf, ARangeIsALimitAsTheCompilerSays) {
  const auto limited = [](const std::string& attributes, const std::string& compiler = "") {
    return joint(read_bodies("<body><joint name='j' " + attributes + "/><geom size='0.1'/></body>", compiler), "j")
        .has_limits;
  };
  EXPECT_TRUE(limited("range='-1 2'"));
  EXPECT_FALSE(limited("range='-1 2' limited='false'"));
  EXPECT_FALSE(limited("range='0 0'"));
  EXPECT_TRUE(limited("range='-1 2' limited='true'", "<compiler autolimits='false'/>"));
  EXPECT_THROW(limited("range='-1 2'", "<compiler autolimits='false'/>"), description::Refused);
}

TEST(Mjcf, OrientationsAreThoseOfTheReference) {
  const auto x_axis_of = [](const std::string& attributes, const std::string& compiler = "") {
    const auto found = read_bodies("<body name='b' " + attributes + "><joint/><geom size='0.1'/></body>", compiler);
    const auto& r = link(found, "b").joint.origin.rotation;
    return std::array<double, 3>{r[0], r[3], r[6]};
  };
  expect_near(x_axis_of("euler='0 0 90'"), {0.0, 1.0, 0.0});
  expect_near(x_axis_of("euler='90 0 90'"), {0.0, 0.0, 1.0});  // about axes that turn along
  expect_near(x_axis_of("euler='90 0 90'", "<compiler eulerseq='XYZ'/>"), {0.0, 1.0, 0.0});
  expect_near(x_axis_of("euler='90 0 0'", "<compiler eulerseq='zyx'/>"), {0.0, 1.0, 0.0});
  expect_near(x_axis_of("quat='2 0 0 2'"), {0.0, 1.0, 0.0});
  expect_near(x_axis_of("axisangle='0 0 3 90'"), {0.0, 1.0, 0.0});
  expect_near(x_axis_of("xyaxes='0 3 0 -1 1 0'"), {0.0, 1.0, 0.0});
  expect_near(x_axis_of("zaxis='2 0 0'"), {0.0, 0.0, -1.0});
  expect_near(x_axis_of("zaxis='0 0 -1'"), {1.0, 0.0, 0.0});
}

// As in MuJoCo: a class's angles stand in front of a quaternion of the element itself.
TEST(Mjcf, AQuaternionGivesWayToAnyOtherOrientation) {
  const auto inertia = [](const std::string& own) {
    return link(read("<mujoco><default><geom type='box' size='0.1 0.2 0.3' euler='90 0 0'/></default><worldbody>"
                     "<body name='b'><joint/><geom mass='3' " +
                     own + "/></body></worldbody></mujoco>"),
                "b")
        .inertia;
  };
  EXPECT_NEAR(inertia("")[1], 0.01 + 0.04, tight);  // z becomes y
  EXPECT_NEAR(inertia("quat='1 0 0 0'")[1], 0.01 + 0.04, tight);
  EXPECT_NEAR(inertia("axisangle='0 0 1 90'")[1], 0.04 + 0.09, tight);
}

TEST(Mjcf, TheNearestClassGivesWhatAnElementDoesNot) {
  const auto found = read(
      "<mujoco><default><joint damping='1' armature='5'/><default class='a'><joint damping='2' frictionloss='0.5'/>"
      "<default class='b'><joint damping='3'/></default></default></default><worldbody>"
      "<body name='p' childclass='a'><joint name='of_a'/><geom size='0.1'/><body childclass='b'><joint name='of_b'/>"
      "<geom size='0.1'/><body><joint name='own' damping='4' class='b'/><geom size='0.1'/></body>"
      "<body><joint name='of_main' class='main'/><geom size='0.1'/></body></body></body></worldbody></mujoco>");
  EXPECT_EQ(joint(found, "of_a").damping, 2.0);
  EXPECT_EQ(joint(found, "of_b").damping, 3.0);
  EXPECT_EQ(joint(found, "of_b").friction, 0.5);
  EXPECT_EQ(joint(found, "own").damping, 4.0);
  EXPECT_EQ(joint(found, "of_main").damping, 1.0);
  EXPECT_EQ(joint(found, "of_main").friction, 0.0);
  EXPECT_EQ(joint(found, "own").rotor, 5.0);
}

// A joint turns about its anchor; the second about an axis that the first has turned.
TEST(Mjcf, SeveralJointsOfABodyFollowEachOther) {
  const auto found = read_bodies(
      "<body name='b' pos='1 0 0'><joint name='first' axis='0 0 1' pos='0.5 0 0'/>"
      "<joint name='second' type='slide' axis='1 0 0'/><geom size='0.1'/></body>");
  const auto& between = link(found, "b before second");
  expect_near(between.joint.origin.position, {1.5, 0.0, 0.0});
  EXPECT_TRUE(between.between);
  EXPECT_FALSE(between.has_inertial);
  expect_near(link(found, "b").joint.origin.position, {-0.5, 0.0, 0.0});
  EXPECT_EQ(link(found, "b").joint.kind, importer::Kind::prismatic);
}

TEST(Mjcf, ShapesHaveMassAndInertiaOfTheirFormulas) {
  const auto inertia = [](const std::string& geom) {
    return link(read_bodies("<body name='b'><joint/><geom " + geom + "/></body>"), "b");
  };
  const auto sphere = inertia("size='0.1' density='500'");
  EXPECT_NEAR(sphere.mass, 500.0 * 4.0 / 3.0 * pi * 1e-3, tight);
  EXPECT_NEAR(sphere.inertia[1], 0.4 * sphere.mass * 0.01, tight);
  const auto box = inertia("type='box' size='0.1 0.2 0.3' mass='3'");
  EXPECT_NEAR(box.inertia[0], 3.0 / 3.0 * (0.04 + 0.09), tight);
  EXPECT_NEAR(box.inertia[2], 3.0 / 3.0 * (0.01 + 0.04), tight);
  const auto cylinder = inertia("type='cylinder' size='0.1 0.2' mass='3'");
  EXPECT_NEAR(cylinder.inertia[0], 3.0 * (0.01 / 4.0 + 0.04 / 3.0), tight);
  EXPECT_NEAR(cylinder.inertia[2], 3.0 * 0.01 / 2.0, tight);
  const auto tube = inertia("type='cylinder' size='0.1 0.2' mass='3' shellinertia='true'");
  EXPECT_NEAR(tube.inertia[2], 3.0 * (0.8 * 0.01 + 0.2 * 0.01 / 2.0), tight);  // side and lids as 4 to 1
  const auto ball = inertia("size='0.1' mass='3' shellinertia='true'");
  EXPECT_NEAR(ball.inertia[0], 2.0 / 3.0 * 3.0 * 0.01, tight);
  const auto can = inertia("type='ellipsoid' size='0.1 0.2 0.3' mass='5'");
  EXPECT_NEAR(can.inertia[0], 0.04 + 0.09, tight);
  const auto capsule = inertia("type='capsule' fromto='0 0 0 0.4 0 0' size='0.1'");  // along x
  EXPECT_NEAR(capsule.mass, 1000.0 * pi * (0.01 * 0.4 + 4.0 / 3.0 * 1e-3), 1e-12);
  expect_near(capsule.inertial.position, {0.2, 0.0, 0.0});
  EXPECT_LT(capsule.inertia[0], capsule.inertia[1]);
}

TEST(Mjcf, WhatCountsIsGivenByGroupsMassAndTheCompiler) {
  const auto mass = [](const std::string& inside, const std::string& compiler = "") {
    return link(read_bodies("<body name='b'><joint/>" + inside + "</body>", compiler), "b").mass;
  };
  const std::string both = "<geom size='0.1' mass='1'/><geom size='0.1' mass='2' group='4'/>",
                    given = "<inertial pos='0 0 0' mass='7' diaginertia='1 1 1'/>";
  EXPECT_EQ(mass(both), 3.0);
  EXPECT_EQ(mass(both, "<compiler inertiagrouprange='0 3'/>"), 1.0);
  EXPECT_EQ(mass(given + both), 7.0);
  EXPECT_EQ(mass(given + both, "<compiler inertiafromgeom='true'/>"), 3.0);
  EXPECT_EQ(mass(both, "<compiler inertiafromgeom='false'/>"), 0.0);
  EXPECT_EQ(mass(both, "<compiler boundmass='4'/>"), 4.0);
  EXPECT_NEAR(mass(both, "<compiler settotalmass='12'/>"), 12.0, tight);
  EXPECT_EQ(mass("<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/><geom type='mesh' mesh='m'/>"), 1.0);
}

TEST(Mjcf, MomentsAreBoundedAndBalanced) {
  const auto inertia = [](const std::string& compiler) {
    return link(read_bodies("<body name='b'><joint/><inertial pos='0 0 0' mass='1' diaginertia='0.1 0.2 0.6'/></body>",
                            "<compiler " + compiler + "/>"),
                "b")
        .inertia;
  };
  EXPECT_NEAR(inertia("balanceinertia='true'")[0], 0.3, tight);
  EXPECT_NEAR(inertia("boundinertia='0.15'")[0], 0.15, tight);
  EXPECT_NEAR(inertia("boundinertia='0.15'")[2], 0.6, tight);
}

TEST(Mjcf, ActuatorsLimitEfforts) {
  const auto effort = [](const std::string& actuators, const std::string& more = "") {
    return joint(read("<mujoco><worldbody><body><joint name='j' " + more + "/><geom size='0.1'/></body></worldbody>" +
                      "<actuator>" + actuators + "</actuator></mujoco>"),
                 "j")
        .effort;
  };
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 2' gear='10'/>"), 20.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 2' forcerange='-1 1' gear='10'/>"), 10.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 2' forcerange='-60 60' gear='10'/>"), 20.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 3' forcerange='-60 2.5' gear='10'/>"), 20.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 2' forcerange='0 60' gear='10'/>"), 0.0);
  EXPECT_EQ(effort("<general joint='j' ctrlrange='-2 1' forcerange='-60 60' gainprm='-3'/>"), 3.0);
  EXPECT_EQ(effort("<position joint='j' ctrlrange='-2 2' kp='10'/>"), 0.0);
  EXPECT_EQ(effort("<position joint='j' forcerange='-5 4'/>"), 4.0);
  EXPECT_EQ(effort("<position joint='j' forcerange='0 4'/>"), 0.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 2' ctrllimited='false'/>"), 0.0);
  EXPECT_EQ(effort("<general joint='j' ctrlrange='-2 2' gainprm='3'/>"), 6.0);
  EXPECT_EQ(effort("<general joint='j' ctrlrange='-2 2' gainprm='3' biastype='affine'/>"), 0.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 2'/><position joint='j' forcerange='-3 3'/>"), 5.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-2 2'/><velocity joint='j' kv='3'/>"), 0.0);
  EXPECT_EQ(effort("<motor joint='j' ctrlrange='-20 20'/>", "actuatorfrcrange='-6 7'"), 6.0);
}

const std::string two_joints =
    "<mujoco><worldbody><body><joint name='a' ref='10' armature='0.5'/><geom size='0.1' pos='0 1 0'/><body pos='1 0 0'>"
    "<joint name='b' ref='20' armature='0.1' stiffness='2' springref='30'/><geom size='0.1' pos='0 1 0'/></body></body>"
    "</worldbody>";

// y - y0 = c0 + c1 (x - x0), the positions of the file's drawing being 20 and 10 degrees.
TEST(Mjcf, EqualitiesOfJointsAreCouplings) {
  const std::string end = "<equality><joint joint1='b' joint2='a' polycoef='0.3 -2'/></equality></mujoco>";
  const auto found = read(two_joints + end);
  EXPECT_EQ(joint(found, "b").leader, "a");
  EXPECT_EQ(joint(found, "b").ratio, -2.0);
  const double offset = 20.0 * pi / 180.0 + 0.3 + 2.0 * 10.0 * pi / 180.0;
  EXPECT_NEAR(joint(found, "b").offset, offset, tight);
  const auto result = imported(two_joints + end);
  EXPECT_TRUE(result.figures.good());
  const auto& leader = result.imported.robot.links[0].parameters;
  EXPECT_NEAR(leader.rotor_inertia, 0.5 + 4.0 * 0.1, tight);
  EXPECT_NEAR(leader.spring_stiffness, 4.0 * 2.0, tight);
  EXPECT_NEAR(leader.spring_rest, (30.0 * pi / 180.0 - offset) / -2.0, tight);
}
TEST(Mjcf, AnEqualityWithoutALeaderHolds) {
  const auto found = read(two_joints + "<equality><joint joint1='b' polycoef='0.3'/></equality></mujoco>");
  EXPECT_TRUE(joint(found, "b").held);
  EXPECT_NEAR(joint(found, "b").held_at, 20.0 * pi / 180.0 + 0.3, tight);
  const auto off = read(two_joints + "<equality><joint active='false' joint1='b' polycoef='0.3'/></equality></mujoco>");
  EXPECT_TRUE(joint(off, "b").moves());
}
// 2 (a - a0) - 4 (b - b0) = 0.2
TEST(Mjcf, AFixedTendonThatIsHeldIsACoupling) {
  const auto found = read(two_joints +
                          "<tendon><fixed name='t'><joint joint='a' coef='2'/><joint joint='b' coef='-4'/></fixed>"
                          "</tendon><equality><tendon tendon1='t' polycoef='0.2'/></equality></mujoco>");
  EXPECT_EQ(joint(found, "b").leader, "a");
  EXPECT_NEAR(joint(found, "b").ratio, 0.5, tight);
  EXPECT_NEAR(joint(found, "b").offset, (20.0 - 5.0) * pi / 180.0 - 0.05, tight);
}
TEST(Mjcf, ATendonsActuatorIsThatOfTheOneDriveBehindIt) {
  const std::string tendon =
      "<tendon><fixed name='t'><joint joint='a' coef='3'/><joint joint='b' coef='-4'/></fixed></tendon>"
      "<actuator><motor name='m' tendon='t' ctrlrange='-3 3'/></actuator>";
  const auto coupled =
      read(two_joints + tendon + "<equality><joint joint1='b' joint2='a' polycoef='0 -0.5'/></equality></mujoco>");
  EXPECT_NEAR(joint(coupled, "a").effort, 3.0 * (3.0 + 0.5 * 4.0), tight);
  const auto loose = read(two_joints + tendon + "</mujoco>");
  EXPECT_EQ(joint(loose, "a").effort, 0.0);
  EXPECT_TRUE(says(said(loose), "actuator 'm' pulls joints 'a', 'b' by one tendon"));
}

TEST(Mjcf, ABodyThatFloatsIsTheBase) {
  const auto result = importer::import_file(folder + "floating.xml", {});
  const auto& robot = result.imported.robot;
  ASSERT_TRUE(robot.base_body.has_value());
  EXPECT_NEAR(robot.base_body->mass, 4.0 * 12.5 / 12.5616, 1e-3);
  EXPECT_NEAR(std::hypot(robot.gravity.x, robot.gravity.y, robot.gravity.z), 9.81, 1e-12);
  EXPECT_EQ(robot.size(), 3);  // the ball beside is left out
}

TEST(Mjcf, ASiteIsATool) {
  Options options;
  options.reading.tip = "tip";
  const auto result = importer::import_file(folder + "arm.xml", options);
  EXPECT_TRUE(result.figures.good());
  EXPECT_TRUE(says(result.imported.robot.source, "to 'tip'"));
  EXPECT_EQ(result.imported.robot.size(), 5);  // the rod beside the chain is held
}

// What is near a right angle is one, which is said and measured; or it is read as it is written.
TEST(Mjcf, AngularNoiseIsSettled) {
  const std::string text =
      "<mujoco><worldbody><body name='a'><joint name='j'/><geom size='0.1'/><body name='b' pos='0 0 0.3' "
      "quat='0.707105 0.707108 0 0'><joint name='k'/><geom size='0.1' pos='0.2 0 "
      "0'/></body></body></worldbody></mujoco>";
  const auto settled = imported(text);
  EXPECT_TRUE(settled.figures.good());
  EXPECT_EQ(std::abs(settled.imported.robot.links[1].parameters.alpha.radians), pi / 2.0);
  EXPECT_NEAR(settled.figures.changed_angle, 2.0 * (std::atan2(0.707108, 0.707105) - pi / 4.0), 1e-12);
  Options as_written;
  as_written.reading.right_angles = 0.0;
  const auto written = imported(text, as_written);
  EXPECT_NE(std::abs(written.imported.robot.links[1].parameters.alpha.radians), pi / 2.0);
  EXPECT_EQ(written.figures.changed_angle, 0.0);
}

TEST(Mjcf, RootsTurnGravity) {
  importer::ReadingOptions options;
  options.root = "r";
  const auto found = read(
      "<mujoco><worldbody><body name='r' euler='90 0 0'><body><joint name='j'/><geom size='0.1'/></body></body>"
      "</worldbody></mujoco>",
      options);
  EXPECT_NEAR(found.gravity.y, -9.81, tight);
  EXPECT_NEAR(found.gravity.z, 0.0, tight);
}

TEST(Mjcf, WhatIsIgnoredIsSaid) {
  const auto found = read(
      "<mujoco><visual/><keyframe/><worldbody><body name='held' gravcomp='1'><joint name='j'/><geom size='0.1'/></body>"
      "<body name='cube'><freejoint/><geom size='0.1'/></body></worldbody></mujoco>");
  EXPECT_TRUE(says(said(found), "not read: keyframe, visual"));
  EXPECT_TRUE(says(said(found), "gravcomp of body 'held' is not taken over"));
  EXPECT_TRUE(says(said(found), "float beside are left out: cube"));
}

}  // namespace
