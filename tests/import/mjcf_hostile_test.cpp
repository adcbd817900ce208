// Broken and hostile MJCFs: each gets an answer that names what is wrong, within a second.
#include <host_sim/robots/import/importer.hpp>

#include "arms.hpp"
#include "broken.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

using importer::Options;

using broken::Broken;
using broken::changed;
using broken::expect_says;

std::string message_of(const std::string& text, const std::string& from = "arm.xml", const Options& options = {}) {
  return broken::message_within(text, from, options);
}
constexpr Broken mjcfs[] = {
    {"<worldbody>", "<worldbodies>", "malformed XML"},
    {"</mujoco>", "", "malformed XML"},
    {"<option gravity=\"0 0 -9.81\"/>", "<options/>", "arm.xml, line 3: options: is no section of an MJCF"},
    {"angle=\"radian\"", "angle=\"gon\"", "compiler: angle is 'gon'; give one of degree, radian"},
    {"angle=\"radian\"", "coordinate=\"global\"", "coordinate='global'; give poses in their parents' frames"},
    {"angle=\"radian\"", "eulerseq=\"xyw\"", "eulerseq is 'xyw'"},
    {"angle=\"radian\"", "angels=\"radian\"", "attribute angels='radian' is not known here"},
    {"autolimits=\"true\"", "autolimits=\"false\"", "joint 'shoulder': range is '-1.5 1.25' and limited is not given"},
    {"gravity=\"0 0 -9.81\"", "density=\"1000\"", "option: density is 1000"},
    {"<option gravity=\"0 0 -9.81\"/>", "<option><flag equality=\"disable\"/></option>", "equality='disable'"},
    {"<default class=\"link\">", "<default>", "a nested <default> has no class"},
    {"<default class=\"link\">", "<default class=\"main\">", "class 'main' is there already"},
    {"childclass=\"link\"", "childclass=\"lonk\"", "class 'lonk' is not there"},
    {"name=\"fore\"", "name=\"upper\"", "the name 'upper' stands twice"},
    {"name=\"fore\"", "name=\"fore\" weight=\"3\"", "body 'fore': attribute weight='3' is not known here"},
    {"name=\"elbow\"", "name=\"shoulder\"", "joint 'shoulder': the name 'shoulder' stands twice"},
    {"<joint name=\"elbow\" type=\"slide\"", "<joint name=\"elbow\" type=\"ball\"",
     "joint 'elbow': type is 'ball': three freedoms in one joint"},
    {"<joint name=\"elbow\" type=\"slide\"", "<joint name=\"elbow\" type=\"free\"", "is free, in a body that is not"},
    {"<joint name=\"shoulder\" axis=\"0 0 1\"", "<joint name=\"turn\"/><joint name=\"shoulder\" type=\"free\"",
     "is free, in a body that is not"},
    {"<joint name=\"shoulder\"", "<freejoint/><joint type=\"free\" name=\"shoulder\"",
     "is free, in a body that is not"},
    {"<joint name=\"elbow\" type=\"slide\"", "<joint name=\"elbow\" type=\"screw\"", "type is 'screw'"},
    {"<worldbody>", "<worldbody><joint/>", "joint: moves the world"},
    {"axis=\"0 1 1\"", "axis=\"0 0 0\"", "joint 'elbow': axis is '0 0 0'"},
    {"axis=\"0 1 1\"", "axis=\"0 1\"", "axis is '0 1': 2 numbers; give 3"},
    {"axis=\"0 1 1\"", "axis=\"0 1 nan\"", "'nan' is no number"},
    {"axis=\"0 1 1\"", "axis=\"0 1,5 1\"", "'1,5' is no number"},
    {"range=\"-1.5 1.25\"", "range=\"1.5 -1.25\" limited=\"true\"", "range is '1.5 -1.25': upside down"},
    {"stiffness=\"2\"", "stiffness=\"-2\"", "joint 'elbow': stiffness is -2"},
    {"stiffness=\"2\"", "springdamper=\"0.1 1\"", "springdamper is '0.1 1'"},
    {"frictionloss=\"0.2\"", "frictionloss=\"-0.2\"", "frictionloss is -0.2"},
    {"quat=\"0.7 0.7 0.1 0\"", "quat=\"0 0 0 0\"", "quat is '0 0 0 0'"},
    {"quat=\"0.7 0.7 0.1 0\"", "quat=\"1 0 0 0\" euler=\"0 0 1\"", "quat, euler are given together"},
    {"quat=\"0.7 0.7 0.1 0\"", "zaxis=\"0 0 0\"", "zaxis has no direction"},
    {"mass=\"2.5\"", "", "inertial: has no mass"},
    {"mass=\"2.5\"", "mass=\"-2.5\"", "link 'upper': mass is negative: -2.5 kg"},
    {"mass=\"2.5\"", "mass=\"2.5\" diaginertia=\"1 1 1\"", "diaginertia and fullinertia are given"},
    {"mass=\"2.5\"", "mass=\"2.5\" euler=\"0 0 1\"", "fullinertia and an orientation are given"},
    {"type=\"capsule\"", "type=\"mesh\" mesh=\"rod\"",
     "line 12: geom 'rod': its mass and inertia are those of mesh 'rod', which is not computed here; give the body an "
     "<inertial>"},
    {"<joint name=\"elbow\"", "<frame><inertial/></frame><joint name=\"elbow\"", "inertial: stands in a frame"},
    {"type=\"capsule\"", "type=\"cone\"", "geom 'rod': type is 'cone'"},
    {"fromto=\"0 0 0 0.2 0 0\"", "", "size is '0.02', and a capsule has 2 numbers"},
    {"fromto=\"0 0 0 0.2 0 0\"", "fromto=\"0 0 0 0 0 0\"", "fromto has no direction"},
    {"size=\"0.02\"", "size=\"0\"", "size is '0'; give radius"},
    {"<site name=\"tool0\" pos=\"0.05 0 0\"/>", "<attach model=\"m\"/>", "attach: makes bodies that are not written"},
    {"<site name=\"tool0\" pos=\"0.05 0 0\"/>", "<geometry/>", "geometry: is no part of a body"},
    {"joint1=\"wrist\"", "joint1=\"knee\"", "joint 'law': joint1 'knee' is no hinge or slide of the file"},
    {"joint2=\"shoulder\"", "joint2=\"wrist\"", "joint 'wrist' follows itself"},
    {"polycoef=\"0.1 0.5\"", "polycoef=\"0.1 0.5 0.2\"", "polycoef is '0.1 0.5 0.2': not linear"},
    {"<equality>", "<equality><joint joint1=\"wrist\"/>", "joint 'wrist' is determined by another equality too"},
    {"<equality>", "<equality><weld name=\"w\" body1=\"hand\"/>",
     "weld 'w': closes a loop between bodies 'hand' and 'world'"},
    {"<fixed name=\"pull\">", "<fixed name=\"pull\" stiffness=\"3\">", "fixed 'pull': stiffness is '3'"},
};

TEST(MjcfBroken, IsRefusedByName) {
  EXPECT_EQ(message_of(arms::mjcf), "");
  for (const auto& broken : mjcfs)
    expect_says(message_of(changed(arms::mjcf, broken)), broken.says);
}

TEST(MjcfBroken, RootsAndTips) {
  Options options;
  options.reading.tip = "toe";
  expect_says(message_of(arms::mjcf, "arm.xml", options), "--tip: there is no body 'toe', and no site");
  options.reading = {};
  options.reading.root = "fore", options.reading.tip = "upper";
  expect_says(message_of(arms::mjcf, "arm.xml", options), "'upper' does not hang on 'fore'");
}

// Radians that were meant as degrees are read as they are written, and said.
TEST(MjcfBroken, WrongUnitsAreSaid) {
  const auto result =
      importer::import_text(changed(arms::mjcf, {"quat=\"0.7 0.7 0.1 0\"", "euler=\"90 0 0\"", ""}), "arm.xml", {});
  expect_says(description::lines(result.imported.warnings, false), "link 'fore': euler is '90 0 0', more than a turn");
  expect_says(message_of(changed(arms::mjcf, {"-1.5 1.25", "-90000 90000", ""})), "");
  for (const auto& [turn, is_more] :
       {std::pair{"6.283", false}, {"-6.283", false}, {"6.2833", true}, {"-6.2833", true}}) {
    const std::string euler = std::string("euler=\"0 ") + turn + " 0\"";
    const auto turned =
        importer::import_text(changed(arms::mjcf, {"quat=\"0.7 0.7 0.1 0\"", euler.c_str(), ""}), "arm.xml", {});
    EXPECT_EQ(description::lines(turned.imported.warnings, false).find("more than a turn") != std::string::npos,
              is_more)
        << turn;
  }
}

/// A folder of files for as long as it lives.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(std::filesystem::path(testing::TempDir()) / ("axial_" + name)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_ / "inside");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  void link(const std::string& name, const std::string& to) const { std::filesystem::create_symlink(to, path_ / name); }

 private:
  std::filesystem::path path_;
};
std::string including(const std::string& file) { return "<mujoco><include file='" + file + "'/></mujoco>"; }

TEST(MjcfIncludes, StayInTheFolder) {
  const Folder outside("outside"), folder("includes");
  outside.write("secret.xml", "<mujocoinclude><worldbody><body name='secret'/></worldbody></mujocoinclude>");
  folder.link("inside/link.xml", outside.file("secret.xml"));
  const auto message = [&](const std::string& file) {
    return message_of(including(file), folder.file("inside/main.xml"));
  };
  expect_says(message("../part.xml"), "file '../part.xml' is outside of the folder");
  expect_says(message(outside.file("secret.xml")), "is outside of the folder");
  expect_says(message("link.xml"), "file 'link.xml' is outside of the folder");
  expect_says(message("none.xml"), "file 'none.xml' is not there");
  expect_says(message(""), "<include> has no file");
}
TEST(MjcfIncludes, DoNotGoInCircles) {
  const Folder folder("circles");
  folder.write("one.xml", including("two.xml"));
  folder.write("two.xml", including("one.xml"));
  folder.write("twice.xml", "<mujocoinclude/>"), folder.write("main.xml", including("main.xml"));
  expect_says(message_of(including("two.xml"), folder.file("one.xml")), "file 'one.xml' is included already");
  expect_says(message_of(including("main.xml"), folder.file("main.xml")), "file 'main.xml' is included already");
  expect_says(
      message_of("<mujoco><include file='twice.xml'/><include file='./twice.xml'/></mujoco>", folder.file("main.xml")),
      "file './twice.xml' is included already");
}
TEST(MjcfIncludes, StandWhereTheyAreNamed) {
  const Folder folder("places");
  folder.write("inside/hand.xml",
               "<mujocoinclude><body name='hand'><joint name='j'/><geom size='0.1'/></body></mujocoinclude>");
  folder.write("bad.xml", "<mujocoinclude>\n<body colour='red'/></mujocoinclude>");
  const auto with = [&](const std::string& file) {
    return "<mujoco><worldbody><body><include file='" + file + "'/></body></worldbody></mujoco>";
  };
  EXPECT_EQ(message_of(with("inside/hand.xml"), folder.file("main.xml")), "");
  expect_says(message_of(with("bad.xml"), folder.file("main.xml")), "bad.xml, line 2: body: attribute colour");
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i)
    all += text;
  return all;
}
std::string mujoco(const std::string& text) { return "<mujoco>" + text + "</mujoco>"; }

TEST(MjcfHostile, ManyBodies) {
  expect_says(message_of(mujoco("<worldbody>" + repeated("<body/>", 1000000) + "</worldbody>")),
              "has more than 100000 elements; give the robot");
  expect_says(message_of(mujoco("<worldbody>" + repeated("<body/>", 20000) + "</worldbody>")),
              "is one too many: at most 5000 bodies are read");
  expect_says(message_of(mujoco("<worldbody>" + repeated("<body/>", 3000) + "</worldbody>")),
              "is one too many: at most 64 joints and 1000 bodies are imported");
  expect_says(message_of(mujoco("<worldbody><body>" + repeated("<joint/>", 20000) + "</body></worldbody>")),
              "is one too many: at most 5000 joints are read");
  expect_says(message_of(mujoco("<worldbody><body>" + repeated("<joint/>", 2000) + "</body></worldbody>")),
              "at most 64 joints");
  expect_says(message_of(mujoco("<worldbody>" + repeated("<body>", 100000))), "nested too deeply");
}
TEST(MjcfHostile, Entities) {
  const std::string laughs =
      "<!DOCTYPE m [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'><!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;'>]>";
  EXPECT_NE(message_of(laughs + mujoco("<worldbody><body name='&c;'/></worldbody>")), "");
  EXPECT_NE(message_of("<!DOCTYPE m [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>" + mujoco("&x;")), "");
}
TEST(MjcfHostile, DefaultsOfDefaults) {
  std::string deep, many;
  for (int i = 0; i < 190; ++i)
    deep += "<default class='c" + std::to_string(i) + "'>";
  deep = "<default>" + deep + repeated("</default>", 191);
  EXPECT_EQ(message_of(mujoco(deep + "<worldbody><body><joint class='c189'/><geom size='1'/></body></worldbody>")), "");
  expect_says(message_of(mujoco("<default><default class='a'><default class='a'/></default></default>")),
              "class 'a' is there already");
}
TEST(MjcfHostile, Equalities) {
  std::string bodies, laws;
  for (int i = 0; i < 60; ++i)
    bodies += "<body><joint name='j" + std::to_string(i) + "'/><geom size='0.1'/>";
  for (int i = 0; i < 60; ++i)
    laws += "<joint joint1='j" + std::to_string(i) + "' joint2='j" + std::to_string((i + 1) % 60) + "'/>";
  expect_says(message_of(mujoco("<worldbody>" + bodies + repeated("</body>", 60) + "</worldbody><equality>" + laws +
                                "</equality>")),
              "follows itself");
}
TEST(MjcfHostile, OtherFilesSayWhatTheyAre) {
  expect_says(message_of("<sdf version='1.7'/>"), "this is an SDF, and libsdformat, which reads it, was not there");
  expect_says(message_of("<sdf version='1.7'/>"), "install libsdformat-dev");
  expect_says(message_of("<mujocoinclude/>"), "this is a part of an MJCF, which another file includes");
  expect_says(message_of("<?xml version='1.0'?><!-- <mujoco> --><COLLADA/>"), "this is a COLLADA mesh");
  expect_says(message_of("<mujoco/>"), "there is no joint that moves");
  expect_says(message_of("<mujoco"), "malformed XML");
}
TEST(MjcfHostile, NamesCannotLeaveAComment) {
  const auto result = importer::import_text(
      changed(arms::mjcf, {"name=\"hand\"", "name=\"*/ \\ &#10;#include &quot;x&quot;\"", ""}), "arm.xml", {});
  for (const auto& link : result.imported.robot.links)
    EXPECT_EQ(link.name.find_first_of("\\\n\""), std::string::npos) << link.name;
}

}  // namespace
