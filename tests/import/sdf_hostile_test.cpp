// Broken and hostile SDFs: each gets an answer that names what is wrong, within a second.
#include <host_sim/robots/import/importer.hpp>

#include "arms.hpp"
#include "broken.hpp"
#include "fuzz.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

using broken::Broken;
using broken::changed;
using broken::expect_says;
using importer::Options;

std::string message_of(const std::string& text, const std::string& from = "arm.sdf", const Options& options = {}) {
  return broken::message_within(text, from, options);
}

constexpr Broken sdfs[] = {
    {"</model>", "</models>", "malformed XML"},
    {"version=\"1.9\"", "version=\"1.3\"", "arm.sdf, line 2: version is '1.3'; give an SDF of version 1.4 to 1.12"},
    {"version=\"1.9\"", "", "version is ''"},
    {"<model name=\"arm\">", "<model>", "arm.sdf"},
    {"name=\"fore\"", "name=\"upper\"", "upper"},
    {"<link name=\"base\"/>", "<link name=\"base\"><colour/></link>",
     "arm.sdf, line 5: link 'base', <colour>: is not known in <link>"},
    {"<mass>2.5</mass>", "<mass>2.5</mass><mass>3</mass>", "line 8: link 'upper', <mass>: stands twice in <inertial>"},
    {"<mass>2.5</mass>", "<mass>heavy</mass>", "mass is 'heavy': 'heavy' is no number"},
    {"<mass>2.5</mass>", "<mass>nan</mass>", "'nan' is no number"},
    {"<mass>2.5</mass>", "<mass>inf</mass>", "'inf' is no number"},
    {"<mass>2.5</mass>", "<mass>2,5</mass>", "'2,5' is no number"},
    {"<mass>2.5</mass>", "<mass>-2.5</mass>", "link 'upper': mass is negative: -2.5 kg"},
    {"<mass>2.5</mass>", "<mass>2.5</mass><density>5</density>", "<density>: is not known in <inertial>"},
    {"<inertial><pose>0.1", "<inertial auto=\"true\"><pose>0.1", "its mass and inertia are those of its shapes"},
    {"0.25 0 0.1 0.3 0 0.4", "0.25 0 0.1 0.3 0", "pose is '0.25 0 0.1 0.3 0': 5 numbers; give 6"},
    {"relative_to=\"upper\"", "relative_to=\"lower\"", "lower"},
    {"relative_to=\"upper\"", "relative_to=\"fore\"", "fore"},
    {"relative_to=\"tool\"", "relative_to=\"hand\"", "hand"},
    {"attached_to=\"fore\"", "attached_to=\"tool\"", "tool"},
    {"expressed_in=\"upper\"", "expressed_in=\"lower\"", "lower"},
    {"<xyz expressed_in=\"upper\">0 1 1", "<xyz>0 0 0", "xyz vector cannot be zero"},
    {"<child>fore</child>", "<child>arm</child>", "arm"},
    {"<child>fore</child>", "<child>base</child>", "is the child of joint 'stand' too: a loop, or two carriers"},
    {"<parent>upper</parent><child>fore</child>", "<parent>hand</parent><child>fore</child>", "closes a loop of links"},
    {"<parent>world</parent><child>base</child>", "<parent>base</parent><child>world</child>", "world"},
    {"type=\"prismatic\"", "type=\"screw\"",
     "joint 'elbow' is a screw: a turn that shifts; write a revolute and a prismatic joint"},
    {"type=\"prismatic\"", "type=\"ball\"", "joint 'elbow' is a ball: three freedoms; write three revolute joints"},
    {"type=\"prismatic\"", "type=\"universal\"",
     "joint 'elbow' is universal or revolute2: two freedoms; write two revolute joints"},
    {"type=\"prismatic\"", "type=\"gearbox\"",
     "joint 'elbow' is a gearbox: it couples two other joints; write <mimic>"},
    {"type=\"prismatic\"", "type=\"magic\"", "magic"},
    {"<lower>-1.5</lower>", "<lower>1.5</lower>", "position limits are upside down: lower 1.5, upper 1.25"},
    {"<damping>0.3", "<damping>-0.3", "joint 'shoulder': damping is -0.3"},
    {"<friction>0.2", "<friction>-0.2", "friction is -0.2"},
    {"<spring_stiffness>2", "<spring_stiffness>-2", "spring_stiffness is -2"},
    {"mimic joint=\"shoulder\"", "mimic", "<mimic> names no joint"},
    {"mimic joint=\"shoulder\"", "mimic joint=\"knee\"", "joint 'wrist' mimics 'knee', which does not move here"},
    {"mimic joint=\"shoulder\"", "mimic joint=\"wrist\"", "joint 'wrist' mimics itself"},
    {"mimic joint=\"shoulder\"", "mimic joint=\"shoulder\" axis=\"axis2\"", "mimics 'axis2' of a joint"},
    {"<multiplier>0.5", "<multiplier>0", "mimics with multiplier 0"},
    {"<link name=\"hand\">", "<link name=\"hand\"><gravity>false</gravity>", "link 'hand': gravity does not act on it"},
    {"<link name=\"hand\">", "<link name=\"hand\"><kinematic>true</kinematic>", "link 'hand': kinematic"},
    {"<link name=\"hand\">", "<link name=\"hand\"><velocity_decay><linear>0.1</linear></velocity_decay>",
     "link 'hand': velocity_decay is 0.1: a drag"},
    {"<pose>0 0 0.1 0 0 0.2</pose>", "<static>true</static>", "model 'arm' is static: nothing of it moves"},
};

TEST(SdfBroken, IsRefusedByName) {
  EXPECT_EQ(message_of(arms::sdf), "");
  for (const auto& broken : sdfs)
    expect_says(message_of(changed(arms::sdf, broken)), broken.says);
}

TEST(SdfBroken, RootsAndTips) {
  Options options;
  options.reading.tip = "toe";
  expect_says(message_of(arms::sdf, "arm.sdf", options),
              "--tip: there is no link 'toe', and no frame; links at the ends are hand");
  options.reading = {};
  options.reading.root = "fore", options.reading.tip = "upper";
  expect_says(message_of(arms::sdf, "arm.sdf", options), "'upper' does not hang on 'fore'");
}

TEST(SdfBroken, AWindIsRefused) {
  const std::string robot =
      "<model name='m'><enable_wind>true</enable_wind><link name='a'/><link name='b'/><joint name='j' type='revolute'>"
      "<parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint></model></world></sdf>";
  expect_says(
      message_of("<sdf version='1.9'><world name='w'><wind><linear_velocity>3 4 0</linear_velocity></wind>" + robot),
      "model 'm' stands in a wind of 5 m/s");
  EXPECT_EQ(message_of("<sdf version='1.9'><world name='w'>" + robot), "");
}

/// A folder of files for as long as it lives.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(std::filesystem::path(testing::TempDir()) / ("axial_sdf_" + name)) {
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
std::string including(const std::string& uri) {
  return "<sdf version='1.9'><model name='m'><include><uri>" + uri + "</uri></include></model></sdf>";
}

TEST(SdfIncludes, StayInTheFolder) {
  const Folder outside("outside"), folder("includes");
  outside.write("secret.sdf", "<sdf version='1.9'><model name='secret'><link name='l'/></model></sdf>");
  folder.link("inside/link.sdf", outside.file("secret.sdf"));
  const auto message = [&](const std::string& uri) {
    return message_of(including(uri), folder.file("inside/main.sdf"));
  };
  expect_says(message("../part.sdf"), "file '../part.sdf' is outside of the folder");
  expect_says(message("model://../part"), "file '../part' is outside of the folder");
  expect_says(message("file://" + outside.file("secret.sdf")), "is outside of the folder");
  expect_says(message(outside.file("secret.sdf")), "is outside of the folder");
  expect_says(message("link.sdf"), "file 'link.sdf' is outside of the folder");
  expect_says(message("https://example.org/arm"), "'https://example.org/arm' is outside of the folder");
  expect_says(message("none.sdf"), "file 'none.sdf' is not there");
  expect_says(message(""), "<include> has no <uri>");
  folder.write("inside/arm.urdf", arms::urdf);
  expect_says(message("arm.urdf"), "there is no <sdf> element");
  folder.write("inside/bad.sdf", "<sdf version='1.9'>\n<model name='n'><colour/></model></sdf>");
  expect_says(message("bad.sdf"), "bad.sdf, line 2: model 'n', <colour>: is not known");
}

// What a world has beside a robot may be on the net: it is left out, and said.
TEST(SdfIncludes, SceneryIsLeftOut) {
  std::string world = changed(arms::sdf, {"<model name=\"arm\">",
                                          "<world name='w'><include><uri>model://sun</uri></include><include>"
                                          "<uri>https://example.org/floor</uri></include><model name=\"arm\">",
                                          ""});
  world = changed(world, {"</sdf>", "</world></sdf>", ""});
  const auto result = importer::import_text(world, "world.sdf", {});
  expect_says(result.imported.robot.notes[0], "include 'https://example.org/floor', which is not there");
  expect_says(result.imported.robot.notes[0], "include 'model://sun', which is not there");
}

TEST(SdfIncludes, DoNotGoInCirclesNorGrow) {
  const Folder folder("circles");
  folder.write("one.sdf", including("two.sdf"));
  folder.write("two.sdf", including("one.sdf"));
  expect_says(message_of(including("two.sdf"), folder.file("one.sdf")),
              "file 'one.sdf' includes itself, by way of others");
  expect_says(message_of(including("one.sdf"), folder.file("one.sdf")), "file 'one.sdf' includes itself");
  for (int i = 0; i < 3; ++i) {
    std::string twice = "<sdf version='1.9'><model name='m'><link name='l'/>";
    for (const char* name : {"a", "b"})
      twice += "<include><name>" + std::string(name) + "</name><uri>" + std::to_string(i + 1) + ".sdf</uri></include>";
    folder.write(std::to_string(i) + ".sdf", twice + "</model></sdf>");
  }
  std::string links;
  for (int i = 0; i < 400; ++i)
    links += "<link name='l" + std::to_string(i) + "'/>";
  folder.write("3.sdf", "<sdf version='1.9'><model name='m'>" + links + "</model></sdf>");
  expect_says(message_of(including("0.sdf"), folder.file("main.sdf")), "is one too many");
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i)
    all += text;
  return all;
}
std::string numbered(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i)
    for (const char c : text)
      all += c == '#' ? std::to_string(i) : c == '%' ? std::to_string(i + 1) : std::string(1, c);
  return all;
}
std::string sdf(const std::string& inside) { return "<sdf version='1.9'><model name='m'>" + inside + "</model></sdf>"; }

TEST(SdfHostile, ManyLinks) {
  expect_says(message_of(sdf(repeated("<link/>", 1000000))), "has more than 100000");
  expect_says(message_of(sdf(numbered("<link name='l#'/>", 20000))), "is one too many");
  expect_says(message_of(sdf(repeated("<model name='m'>", 100000))), "nested too deeply");
  const std::string chain = numbered(
      "<link name='l#'/><joint name='j#' type='revolute'><parent>l#</parent><child>l%"
      "</child><axis><xyz>0 0 1</xyz></axis></joint>",
      70);
  // All of it is libsdformat's to read first, under sanitizers on a slow processor for two seconds.
  expect_says(broken::message_within(sdf(chain + "<link name='l70'/>"), "arm.sdf", {}, 10),
              "is one too many: at most 64 joints");
}
TEST(SdfHostile, LongChainsOfFrames) {
  const std::string frames = numbered("<frame name='f%' attached_to='f#'><pose>0 0 0.001 0 0 0</pose></frame>", 300);
  const std::string robot =
      "<link name='a'/><link name='b'><pose relative_to='f300'/></link><frame name='f0'/>" + frames +
      "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>";
  EXPECT_EQ(message_of(sdf(robot)), "");
}
TEST(SdfHostile, Entities) {
  const std::string laughs =
      "<!DOCTYPE m [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'><!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;'>]>";
  EXPECT_NE(message_of(laughs + sdf("<link name='&c;'/>")), "");
  EXPECT_NE(message_of("<!DOCTYPE m [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>" + sdf("&x;")), "");
}
TEST(SdfHostile, ByItsContentWhateverItsName) {
  EXPECT_EQ(message_of(arms::sdf, "arm.urdf"), "");
  EXPECT_EQ(message_of(arms::sdf, "arm.xml"), "");
  EXPECT_EQ(message_of(arms::urdf, "arm.sdf"), "");
  expect_says(message_of("<sdf version='1.9'/>"), "there is no <model>");
  expect_says(message_of("<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>"),
              "there is no joint that moves");
  expect_says(message_of("<sdf"), "malformed XML");
}
TEST(SdfHostile, NamesCannotLeaveAComment) {
  const std::string named = changed(arms::sdf, {"name=\"hand\"", "name=\"*/ \\ #include &quot;x&quot;\"", ""});
  const auto result = importer::import_text(
      changed(named, {"<child>hand<", "<child>*/ \\ #include &quot;x&quot;<", ""}), "arm.sdf", {});
  EXPECT_EQ(result.imported.robot.links[2].name, "*/ / #include 'x'");
}

// libsdformat reads its own schema for each, a tenth of a second.
TEST(SdfFuzz, Bytes) {
  fuzzing::fuzz(
      arms::sdf, [](fuzzing::Mutator& m, const std::string& text) { return m.bytes(text); }, fuzzing::rounds() / 10);
}
TEST(SdfFuzz, Values) {
  fuzzing::fuzz(
      arms::sdf, [](fuzzing::Mutator& m, const std::string& text) { return m.values(text); }, fuzzing::rounds() / 10);
}

}  // namespace
