// SDF: what DART makes of a made-up file, and what each element means, by hand.
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/importer.hpp>
#include <host_sim/robots/import/sdf/sdf_reader.hpp>

#include <axial/axial.hpp>

#include "arms.hpp"
#include "trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

using importer::Options;
using importer::Result;
using trees::expect_near;
using trees::joint;
using trees::link;
using trees::said;
using trees::says;

constexpr double tight = 1e-13;
const std::string folder = std::string(AXIAL_ROOT) + "/tests/import/sdf/";

importer::EngineTree read(const std::string& text, const importer::ReadingOptions& options = {}) {
  return importer::read_sdf(text, folder + "test.sdf", options);
}
std::string model(const std::string& inside) {
  return "<sdf version='1.9'><model name='m'>" + inside + "</model></sdf>";
}
std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name='" + name + "'>" + inside +
         "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial></link>";
}
std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& axis = "<xyz>0 0 1</xyz>", const std::string& inside = "") {
  return "<joint name='" + name + "' type='" + type + "'>" + inside + "<parent>" + parent + "</parent><child>" + child +
         "</child><axis>" + axis + "</axis></joint>";
}
/// A base that stands, and what it carries.
std::string standing(const std::string& inside) {
  return model(link("base") + "<joint name='stand' type='fixed'><parent>world</parent><child>base</child></joint>" +
               inside);
}
Result imported(const std::string& text, const Options& options = {}) {
  return importer::import_text(text, folder + "test.sdf", options);
}
// --- against DART: the answer is committed. AXIAL_DART=PROGRAM, that is dart_engine, writes it anew.

constexpr unsigned seed = 3;
constexpr int states = 3;

std::string answer_of_dart() {
  const std::string path = folder + "arm.json";
  if (const char* program = std::getenv("AXIAL_DART"); program != nullptr) {
    const std::string questions = testing::TempDir() + "questions.json", file = folder + "arm.sdf";
    std::ofstream(questions) << importer::engine_questions(file, read(description::read_text(file)), seed, states);
    EXPECT_EQ(std::system((std::string(program) + " " + questions + " " + path).c_str()), 0);
  }
  return description::read_text(path);
}
importer::EngineFigures figures_of(const std::string& text, const std::string& answer) {
  return importer::compared_with_engine(read(text), seed, states, answer);
}

TEST(Sdf, IsWhatDartMakesOfIt) {
  const auto figures = figures_of(description::read_text(folder + "arm.sdf"), answer_of_dart());
  EXPECT_TRUE(says(figures.engine, "DART 6"));
  EXPECT_EQ(figures.bound, 1e-9);
  EXPECT_TRUE(figures.good()) << figures.line();
  for (const double error : {figures.pose, figures.torque, figures.mass_matrix, figures.body, figures.joint})
    EXPECT_LT(error, 1e-13);
}

// A ten-thousandth in any number that is read: DART's answer is of another arm.
TEST(Sdf, AnyNumberIsRead) {
  const std::string text = description::read_text(folder + "arm.sdf"), answer = answer_of_dart();
  int count = 0;
  for (std::size_t at = text.find("<model name"), last = text.find("<plugin"); at < last; ++at) {
    const auto before = text[at - 1];
    char* end = nullptr;
    const double value = std::strtod(&text[at], &end);
    const auto length = static_cast<std::size_t>(end - &text[at]);
    if ((before != '>' && before != ' ') || text[at] == ' ' || length == 0 || (*end != ' ' && *end != '<')) continue;
    std::string other = text;
    other.replace(at, length, std::to_string(value + (value < 0.0 ? -1e-4 : 1e-4)));
    EXPECT_FALSE(figures_of(other, answer).good()) << text.substr(at - 20, 60);
    at += length, ++count;
  }
  EXPECT_GT(count, 200);
}

TEST(Sdf, TheDescriptionIsTheTree) {
  const auto result = importer::import_file(folder + "arm.sdf", {});
  EXPECT_TRUE(result.figures.good());
  EXPECT_EQ(result.imported.robot.size(), 5);
  EXPECT_TRUE(says(result.figures.lines().back(), "not against DART: it is not here"));
  for (const std::string tip : {"tip", "hand::finger", "clamp"}) {
    Options options;
    options.reading.tip = tip;
    EXPECT_TRUE(importer::import_file(folder + "arm.sdf", options).figures.good()) << tip;
  }
}

// --- by hand

// m l^2 + I about the axis; a torque that holds it, and one that speeds it up.
TEST(Sdf, APendulumIsThatOfTheTextbook) {
  const auto result = imported(
      "<sdf version='1.9'><world name='w'><gravity>0 0 -10</gravity><model name='m'><link name='base'/><link "
      "name='rod'>"
      "<inertial><pose>0.5 0 0 0 0 0</pose><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.3</izz></inertia>"
      "</inertial></link><joint name='stand' type='fixed'><parent>world</parent><child>base</child></joint>" +
      joint("j", "revolute", "base", "rod", "<xyz>0 1 0</xyz>") + "</model></world></sdf>");
  using Model = axial::Model<description::most_links, axial::Gravity, axial::RotorInertia, axial::SharedDrives>;
  const auto robot = description::to_model<Model>(result.imported.robot);
  axial::Joints<Model, double> q{}, qd{}, qdd{};
  q[0] = 0.4, qdd[0] = 1.5;
  EXPECT_NEAR(axial::inverse_dynamics(robot, q, qd, qdd)[0],
              (2.0 * 0.25 + 0.2) * 1.5 - 2.0 * 10.0 * 0.5 * std::cos(0.4), tight);
}

TEST(Sdf, PosesAreRelativeToWhatTheyName) {
  const auto origin = [](const std::string& of_link, const std::string& of_joint = "") {
    const auto tree =
        read(standing("<frame name='f' attached_to='base'><pose>0 0 2 0 0 0</pose></frame>"
                      "<frame name='g' attached_to='f'><pose>1 0 0 0 0 0</pose></frame>" +
                      link("l", of_link) + joint("j", "revolute", "base", "l", "<xyz>0 0 1</xyz>", of_joint)));
    return link(tree, "l").joint.origin.position;
  };
  expect_near(origin("<pose>1 2 3 0 0 0</pose>"), {1.0, 2.0, 3.0});
  expect_near(origin("<pose relative_to='f'>1 2 3 0 0 0</pose>"), {1.0, 2.0, 5.0});
  expect_near(origin("<pose relative_to='g'>1 2 3 0 0 0</pose>"), {2.0, 2.0, 5.0});
  expect_near(origin("<pose>1 2 3 0 0 0</pose>", "<pose>0.5 0 0 0 0 0</pose>"), {1.5, 2.0, 3.0});  // the child's frame
  expect_near(origin("<pose relative_to='j'/>", "<pose relative_to='g'>0 0 7 0 0 0</pose>"), {1.0, 0.0, 9.0});
}

TEST(Sdf, AnglesAreRadiansUnlessThePoseSaysDegrees) {
  const auto x_axis = [](const std::string& pose) {
    const auto tree = read(standing(link("l", pose) + joint("j", "revolute", "base", "l")));
    const auto& r = link(tree, "l").joint.origin.rotation;
    return std::array<double, 3>{r[0], r[3], r[6]};
  };
  expect_near(x_axis("<pose degrees='true'>0 0 0 0 0 90</pose>"), {0.0, 1.0, 0.0});
  expect_near(x_axis("<pose>0 0 0 0 0 1.5707963267948966</pose>"), {0.0, 1.0, 0.0});
  expect_near(x_axis("<pose>0 0 0 1.5707963267948966 0 1.5707963267948966</pose>"), {0.0, 1.0, 0.0});
  expect_near(x_axis("<pose rotation_format='quat_xyzw'>0 0 0 0 0 0.7071067811865476 0.7071067811865476</pose>"),
              {0.0, 1.0, 0.0});
}

TEST(Sdf, AnAxisIsExpressedWhereItSays) {
  const auto axis = [](const std::string& in) {
    const auto tree = read(standing(
        link("l", "<pose degrees='true'>0 0 0 90 0 0</pose>") +
        joint("j", "revolute", "base", "l", "<xyz" + in + ">0 0 3</xyz>", "<pose degrees='true'>0 0 0 0 90 0</pose>")));
    return joint(tree, "j").axis;
  };
  expect_near(axis(""), {1.0, 0.0, 0.0});  // in axes of the link
  expect_near(axis(" expressed_in='l'"), {0.0, 0.0, 1.0});
  expect_near(axis(" expressed_in='__model__'"), {0.0, 1.0, 0.0});
}

// The flange stands where the model is put.
TEST(Sdf, ANestedModelIsPutByItsPlacementFrame) {
  const auto tree =
      read(standing("<model name='n' placement_frame='flange'><pose>0 0 5 0 0 0</pose>"
                    "<frame name='flange'><pose>1 0 0 0 0 0</pose></frame>" +
                    link("l") + link("k", "<pose>0 1 0 0 0 0</pose>") + joint("i", "prismatic", "l", "k") + "</model>" +
                    joint("j", "revolute", "base", "n::flange")));
  expect_near(link(tree, "n::l").joint.origin.position, {0.0, 0.0, 5.0});  // the child is a frame: its link is carried
  expect_near(link(tree, "n::l frame").joint.origin.position, {-1.0, 0.0, 0.0});
  EXPECT_EQ(joint(tree, "n::i").kind, importer::Kind::prismatic);
}

TEST(Sdf, FixedJointsMerge) {
  const auto& robot =
      imported(standing(link("l") + link("k", "<pose>0 3 0 0 0 0</pose>") + joint("j", "revolute", "base", "l") +
                        "<joint name='f' type='fixed'><parent>l</parent><child>k</child></joint>"))
          .imported.robot;
  ASSERT_EQ(robot.size(), 1);
  EXPECT_EQ(robot.links[0].parameters.mass, 2.0);
  EXPECT_NEAR(robot.links[0].parameters.inertia_com[2], 2.0 + 2.0 * 1.5 * 1.5, tight);
}

importer::SourceJoint with_axis(const std::string& inside, const std::string& type = "revolute") {
  return joint(read(standing(link("l") + link("k") + joint("j", type, "base", "l", "<xyz>0 0 1</xyz>" + inside) +
                             joint("i", "revolute", "l", "k"))),
               "j");
}

TEST(Sdf, LimitsAreThoseThatAreGiven) {
  const auto limits = [](const std::string& inside) { return with_axis("<limit>" + inside + "</limit>"); };
  const auto all = limits("<lower>-1</lower><upper>2</upper><effort>3</effort><velocity>4</velocity>");
  EXPECT_TRUE(all.has_limits);
  EXPECT_EQ(all.lower, -1.0);
  EXPECT_EQ(all.upper, 2.0);
  EXPECT_EQ(all.effort, 3.0);
  EXPECT_EQ(all.speed, 4.0);
  const auto none = limits("<lower>-1e16</lower><upper>inf</upper><effort>-1</effort><velocity>-1</velocity>");
  EXPECT_FALSE(none.has_limits);
  EXPECT_EQ(none.effort, 0.0);
  EXPECT_EQ(none.speed, 0.0);
  EXPECT_FALSE(limits("<upper>1</upper>").has_limits);
  EXPECT_FALSE(with_axis("<limit><lower>-1</lower><upper>2</upper></limit>", "continuous").has_limits);
  const auto locked = limits("<lower>0.25</lower><upper>0.25</upper>");
  EXPECT_FALSE(locked.moves());
  EXPECT_EQ(locked.held_at, 0.25);
}

TEST(Sdf, DynamicsAreTheJoints) {
  const auto read_joint = with_axis(
      "<dynamics><damping>1</damping><friction>2</friction><spring_stiffness>3</spring_stiffness>"
      "<spring_reference>0.5</spring_reference></dynamics>");
  EXPECT_EQ(read_joint.damping, 1.0);
  EXPECT_EQ(read_joint.friction, 2.0);
  EXPECT_EQ(read_joint.stiffness, 3.0);
  EXPECT_EQ(read_joint.rest, 0.5);
}

// position = multiplier * (leader - reference) + offset
TEST(Sdf, AMimicIsACoupling) {
  const std::string mimic =
      "<mimic joint='i'><multiplier>-2</multiplier><offset>0.3</offset><reference>0.1</reference></mimic>";
  const auto follower = with_axis(mimic);
  EXPECT_EQ(follower.leader, "i");
  EXPECT_EQ(follower.ratio, -2.0);
  EXPECT_NEAR(follower.offset, 0.3 + 2.0 * 0.1, tight);
  Options options;
  options.reading.hold_mimic = true;
  const auto held =
      imported(standing(link("l") + link("k") + joint("j", "revolute", "base", "l", "<xyz>0 0 1</xyz>" + mimic) +
                        joint("i", "revolute", "l", "k")),
               options);
  EXPECT_EQ(held.imported.robot.size(), 1);
}

TEST(Sdf, GravityIsTheWorldsInAxesOfTheRoot) {
  importer::ReadingOptions options;
  options.root = "base";
  const std::string robot = "<model name='m'><pose degrees='true'>0 0 0 90 0 0</pose>" + link("base") + link("l") +
                            joint("j", "revolute", "base", "l") + "</model>";
  const auto tree =
      read("<sdf version='1.9'><world name='w'><gravity>0 0 -3</gravity>" + robot + "</world></sdf>", options);
  EXPECT_NEAR(tree.gravity.y, -3.0, tight);
  EXPECT_NEAR(tree.gravity.z, 0.0, tight);
  EXPECT_TRUE(tree.assumptions.empty());
  const auto alone = read("<sdf version='1.9'>" + robot + "</sdf>", options);
  EXPECT_NEAR(alone.gravity.y, -9.81, tight);
  EXPECT_EQ(alone.assumptions.size(), 1U);
}

TEST(Sdf, WhatNothingFixesToTheWorldIsTheBase) {
  const auto result = imported(model(link("base") + link("l") + joint("j", "revolute", "base", "l")));
  ASSERT_TRUE(result.imported.robot.base_body.has_value());
  EXPECT_EQ(result.imported.robot.base_body->mass, 1.0);
  EXPECT_TRUE(result.figures.good());
  EXPECT_FALSE(imported(arms::sdf).imported.robot.base_body.has_value());
}

TEST(Sdf, RobotsOfAWorldAreChosen) {
  const auto robot = [](const std::string& name) {
    return "<model name='" + name + "'>" + link("base") + link("l") + joint("j", "revolute", "base", "l") + "</model>";
  };
  const std::string world = "<sdf version='1.9'><world name='w'>" + robot("one") + robot("two") + "</world></sdf>";
  EXPECT_THROW(read(world), description::Refused);
  importer::ReadingOptions options;
  options.root = "two::base";
  const auto tree = read(world, options);
  EXPECT_EQ(tree.tree.name, "two");
  EXPECT_TRUE(says(said(tree), "models that are left out: one"));
}

TEST(Sdf, DefaultsOfTheFormatAreWarnings) {
  const auto warnings = [](const std::string& inside) {
    const auto tree = read(standing("<link name='l'>" + inside + "</link>" + joint("j", "revolute", "base", "l")));
    return description::lines(tree.tree.warnings, false);
  };
  EXPECT_TRUE(says(warnings(""), "link 'l': has no mass and inertia: in an SDF these are 1 kg"));
  EXPECT_TRUE(says(warnings("<inertial><mass>2</mass></inertial>"), "link 'l': has no inertia"));
  for (const std::string turn : {"90", "6.2833", "-6.2833"})
    EXPECT_TRUE(says(warnings("<pose>0 0 0 0 " + turn + " 0</pose>"), "more than a turn: angles are radians")) << turn;
  EXPECT_FALSE(says(warnings("<pose>0 0 0 6.283 -6.283 6.283</pose>"), "more than a turn"));
}

TEST(Sdf, WhatIsIgnoredIsSaid) {
  const auto tree =
      read(standing("<plugin filename='libdrive.so' name='p'/><link name='loose'/>" +
                    link("l", "<sensor name='s' type='imu'/><gz:paint/>") +
                    joint("j", "revolute", "base", "l", "<xyz>0 0 1</xyz><limit><upper>1</upper></limit>")));
  EXPECT_TRUE(says(said(tree), "not read: gz:paint, plugin 'libdrive.so', sensor"));
  EXPECT_TRUE(says(said(tree), "position limits of which there is only one are left out: j"));
  EXPECT_TRUE(says(said(tree), "links that nothing carries are left out: loose"));
}

TEST(Sdf, AnglesThatAreNearlyRightAreMadeSoWhereAsked) {
  const auto text =
      standing(link("upper", "<pose>0 0 0.1 0 0 0</pose>") + link("fore", "<pose>0.3 0 0.1 1.5738 0 0</pose>") +
               joint("shoulder", "revolute", "base", "upper") + joint("elbow", "revolute", "upper", "fore"));
  for (const bool snap : {false, true}) {
    Options options;
    options.reading.snap = snap;
    const auto result = imported(text, options);
    EXPECT_TRUE(result.figures.good());
    ASSERT_EQ(result.imported.robot.size(), 2);
    EXPECT_EQ(result.imported.robot.links[1].parameters.alpha.cos == 0.0, snap);
    EXPECT_EQ(
        says(description::lines(result.imported.warnings, false), "joint 'elbow': its axis or frame is 0.003 rad"),
        !snap);
    EXPECT_NEAR(result.figures.changed_angle, snap ? -std::cos(1.5738) : 0.0, 1e-9);
  }
}

// What follows is refused where it moves, and held beside the chain.
TEST(Sdf, JointsOfOtherKindsAreHeldBesideTheChain) {
  importer::ReadingOptions options;
  options.tip = "l";
  const auto tree = read(standing(link("l") + link("b") + joint("j", "revolute", "base", "l") +
                                  "<joint name='ball' type='ball'><parent>l</parent><child>b</child></joint>"),
                         options);
  EXPECT_FALSE(joint(tree, "ball").moves());
  EXPECT_TRUE(says(said(tree), "held at 0 (or their nearest limit), their bodies carried along: ball"));
}

TEST(Sdf, ModelsAreIncludedFromTheFolder) {
  namespace fs = std::filesystem;
  const fs::path place = fs::path(testing::TempDir()) / "axial_sdf_models";
  fs::remove_all(place), fs::create_directories(place / "arm"), fs::create_directories(place / "hand");
  const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(place / name) << text; };
  write("hand/model.sdf", model(link("palm") + link("finger") + joint("grip", "prismatic", "palm", "finger")));
  write("arm/model.config", "<model><sdf>model.sdf</sdf></model>");
  const auto arm = [](const std::string& uri) {
    return standing(link("l") + joint("j", "revolute", "base", "l") + "<include><uri>" + uri +
                    "</uri><name>hand</name><pose>0 0 2 0 0 0</pose></include>"
                    "<joint name='f' type='fixed'><parent>l</parent><child>hand::palm</child></joint>");
  };
  const auto read_at = [&](const std::string& file, const std::string& text) {
    return importer::read_sdf(text, (place / file).string(), {});
  };
  for (const auto& tree : {read_at("arm/model.sdf", arm("model://hand")), read_at("world.sdf", arm("model://hand")),
                           read_at("world.sdf", arm("hand")), read_at("world.sdf", arm("file://hand/model.sdf"))})
    expect_near(link(tree, "hand::palm").joint.origin.position, {0.0, 0.0, 2.0});
  fs::remove_all(place);
}

TEST(Sdf, NumbersOfFewDigitsAreSettled) {
  const auto result = imported(
      standing(link("l", "<pose>0 0 0 1.57080 0 3.14159</pose>") + link("k", "<pose>0 0 0.3 1.57079 0 3.14159</pose>") +
               joint("j", "revolute", "base", "l", "<xyz expressed_in='__model__'>0 1 0</xyz>") +
               joint("i", "revolute", "l", "k", "<xyz>0 0 1</xyz>")));
  EXPECT_TRUE(result.figures.good());
  EXPECT_EQ(result.imported.robot.links[1].parameters.alpha.sin, 0.0);
}

}  // namespace
