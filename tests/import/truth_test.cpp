// An import tells the truth: what is written is what is read, what is changed is said, and a number that is wrong
// anywhere between the text and the header is seen.
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/import/importer.hpp>

#include "arms.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using importer::Options;
using importer::Result;

std::string changed(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}
bool says(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }
std::string warnings(const Result& result) { return description::lines(result.imported.warnings, false); }
std::string assumptions(const Result& result) {
  std::string text;
  for (const auto& line : result.imported.robot.assumptions)
    text += line + "\n";
  return text;
}
std::vector<std::string> joints_of(const Result& result) {
  std::vector<std::string> joints;
  for (const auto& link : result.imported.robot.links)
    joints.push_back(link.joint);
  return joints;
}

/// Whether what was read from one text passes for another one.
bool passes_for(const Result& result, const std::string& text) {
  try {
    const auto reference =
        importer::reference_of(text, {}, result.imported.changes, {0.0, 0.0, -9.81}, joints_of(result), "tool0");
    return importer::verify(result.imported, reference, 1, 20).good();
  } catch (const description::Refused&) {
    return false;
  }
}

// Nothing in it is symmetric.
const std::string arm = changed(changed(arms::urdf, "xyz=\"0 0 1\"", "xyz=\"0.3 -0.4 1\""), "iyz=\"0\" izz=\"0.002\"",
                                "iyz=\"0\" izz=\"0.0025\"");
const std::string follower = changed(arm, "<axis xyz=\"0 1 1\"/>",
                                     "<axis xyz=\"0 1 1\"/><dynamics damping=\"4\" friction=\"2\"/>"
                                     "<mimic joint=\"shoulder\" multiplier=\"0.25\" offset=\"0.01\"/>");
const std::string rods = changed(arm, "</robot>",
                                 "<transmission name=\"rods\"><type>x/FourBarLinkageTransmission</type><joint "
                                 "name=\"shoulder\"><mechanicalReduction>2.5</mechanicalReduction></joint><joint "
                                 "name=\"elbow\"><mechanicalReduction>1.5</mechanicalReduction></joint></transmission>"
                                 "</robot>");

/// Each number of a text between `from` and the end: where it stands, and how long it is.
std::vector<std::pair<std::size_t, std::size_t>> numbers_of(const std::string& text, std::size_t from) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = from; i < text.size(); ++i) {
    const bool starts = text[i - 1] == '"' || text[i - 1] == ' ' || (text[i - 1] == '>' && text[i] != '<');
    char* end = nullptr;
    std::strtod(&text[i], &end);
    const auto length = static_cast<std::size_t>(end - &text[i]);
    if (!starts || length == 0 || std::isspace(static_cast<unsigned char>(text[i])) != 0) continue;
    if (*end == '"' || *end == ' ' || *end == '<') found.emplace_back(i, length), i += length;
  }
  return found;
}

// A tenth of a thousandth in any number of the file, the others as they are.
TEST(Truth, AnyNumberOfTheTextIsRead) {
  for (const std::string* each : {&arm, &follower, &rods}) {
    const std::string& text = *each;
    const auto result = importer::import_text(text, "arm", {});
    ASSERT_TRUE(result.figures.good());
    auto unassumed = result;  // as it is verified: an acceleration limit is in no URDF, a speed limit is
    ASSERT_TRUE(passes_for(unassumed, text));
    int count = 0;
    for (const auto& [at, length] : numbers_of(text, text.find("<link"))) {
      if (each != &arm && text.compare(at - 8, 8, "effort=\"") == 0) continue;  // of no drive, which is said
      const double value = std::strtod(&text[at], nullptr);
      auto other = text;
      other.replace(at, length, description::number(value + 1e-4));
      EXPECT_FALSE(passes_for(unassumed, other)) << other.substr(at > 60 ? at - 60 : 0, 90);
      ++count;
    }
    EXPECT_GE(count, 50);
  }
}

TEST(Truth, AnyNumberOfATableIsRead) {
  const std::string text = changed(arms::table, "\"theta\": 0.4",
                                   "\"theta\": 0.4, \"gamma\": 0.3, \"b\": 0.05, \"coulomb\": 0.7, \"viscous\": 0.1");
  const auto result = importer::import_text(text, "arm", {});
  ASSERT_TRUE(result.figures.good());
  const auto passes = [&](const std::string& other) {
    return importer::verify(result.imported, importer::reference_of(other, result.imported.changes, 1e-5), 1, 20)
        .good();
  };
  ASSERT_TRUE(passes(text));
  int count = 0;
  for (std::size_t at = text.find("gravity"); at < text.size(); ++at) {
    const bool starts = std::isspace(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '[';
    if (!starts || (std::isdigit(static_cast<unsigned char>(text[at])) == 0 && text[at] != '-')) continue;
    char* end = nullptr;
    const double value = std::strtod(&text[at], &end);
    auto other = text;
    other.replace(at, static_cast<std::size_t>(end - &text[at]), description::number(value + 1e-4));
    EXPECT_FALSE(passes(other)) << other.substr(at > 40 ? at - 40 : 0, 60);
    ++count;
  }
  EXPECT_GE(count, 35);
}

TEST(Truth, TablesFollowTheSameRule) {
  const auto result = importer::import_text(
      changed(arms::table, "\"a\": 0.25, \"alpha_deg\": -90", "\"a\": 3e-17, \"alpha\": -1.5708"), "arm", {});
  EXPECT_TRUE(result.figures.good());
  EXPECT_EQ(result.imported.robot.links[1].parameters.alpha.cos, 0.0);
  EXPECT_EQ(result.imported.robot.links[1].parameters.a, 0.0);
  EXPECT_GT(result.figures.changed_angle, 3e-6);
  ASSERT_EQ(result.imported.changes.size(), 2U);
  EXPECT_FALSE(importer::verify(result.imported, importer::reference_of(arms::table, {}, 0.0), 1, 20).good());
}

// The same in any number of what was made of it.
TEST(Truth, AnyNumberOfTheHeaderIsCompared) {
  const auto result = importer::import_text(arm, "arm", {});
  using Parameters = axial::LinkParameters;
  const auto seen = [&](auto&& change) {
    auto wrong = result;
    change(wrong.imported);
    return !passes_for(wrong, arm);
  };
  const auto turned = [](axial::Angle& angle) { angle = axial::Angle::from_radians(angle.radians + 1e-4); };
  for (std::size_t i = 0; i < 2; ++i) {
    SCOPED_TRACE(i);
    for (auto length : {&Parameters::a, &Parameters::d, &Parameters::b, &Parameters::mass, &Parameters::position_min,
                        &Parameters::position_max, &Parameters::speed_limit, &Parameters::effort_limit,
                        &Parameters::viscous, &Parameters::coulomb_forward, &Parameters::coulomb_backward})
      EXPECT_TRUE(seen([&](auto& imported) { imported.robot.links[i].parameters.*length += 1e-4; }));
    for (auto angle : {&Parameters::alpha, &Parameters::theta, &Parameters::gamma})
      EXPECT_TRUE(seen([&](auto& imported) { turned(imported.robot.links[i].parameters.*angle); }));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_TRUE(seen([&](auto& imported) { imported.robot.links[i].parameters.com[k] += 1e-4; }));
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_TRUE(seen([&](auto& imported) { imported.robot.links[i].parameters.inertia_com[k] += 1e-4; }));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(seen([&](auto& imported) { imported.robot.base.position[k] += 1e-4; }));
    EXPECT_TRUE(seen([&](auto& imported) { imported.robot.tool.position[k] += 1e-4; }));
  }
  EXPECT_TRUE(seen([](auto& imported) { imported.robot.gravity.z += 1e-4; }));
  EXPECT_TRUE(seen([](auto& imported) { imported.robot.tool.rotation[1] += 1e-4; }));
  EXPECT_TRUE(seen([](auto& imported) { imported.changes.front().read += 1e-4; })) << "nothing is changed so far";
  EXPECT_TRUE(seen([](auto& imported) { imported.changes.front().written += 1e-9; })) << "the file has it not";
}

// Near the poles roll and yaw of a rotation are one: what a quaternion gives back of them is another pitch.
TEST(Truth, APitchNearThePoleIsAsWritten) {
  for (const double off : {0.0039, 0.0044, 0.0021, 1e-4, 2e-5, -0.0039, -3e-5}) {
    for (const char* place : {"rpy=\"0 0 0\"/><axis", "rpy=\"0 1.5708 0\"", "rpy=\"0 0 0\"/><mass"}) {
      const std::string pitch = description::number(M_PI / 2.0 + off), rpy = "rpy=\"0 " + pitch + " 0\"";
      const std::string by = std::string(place).replace(0, std::string(place).find('"', 5) + 1, rpy);
      const auto result = importer::import_text(changed(arms::urdf, place, by), "arm", {});
      EXPECT_TRUE(result.figures.good()) << place << pitch;
      EXPECT_LE(result.figures.changed_angle, 1e-5) << place << pitch;
      const bool joint = !says(place, "mass");
      EXPECT_EQ(says(warnings(result), "pitch of 1.5"), joint) << place << pitch;
    }
  }
  const auto tip = importer::import_text(changed(arms::urdf, "rpy=\"0 1.5708 0\"", "rpy=\"0 1.5669 0\""), "arm", {});
  EXPECT_TRUE(says(warnings(tip), "joint 'flange': pitch of 1.5669 rad is 0.0039 rad off"));
  EXPECT_EQ(tip.figures.changed_angle, 0.0);
}

/// Values near every special one, and others.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : random_(seed) {}

  std::string urdf() {
    std::string text = "<robot name=\"drawn\"><link name=\"l0\"/>";
    const int links = 2 + pick(6);
    for (int i = 1; i <= links; ++i)
      text += link(i) + joint(i, pick(4) == 0 ? i - 1 - pick(std::min(i, 2)) : i - 1, i == links);
    return text + "</robot>";
  }

 private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double tiny() {
    static constexpr double sizes[] = {0.0, 1e-16, 1e-12, 1e-9, 1e-7, 2e-6, 9e-6, 1.1e-5, 5e-5, 8e-4, 3.9e-3};
    return sizes[pick(11)] * (pick(2) == 0 ? 1.0 : -1.0);
  }
  std::string number(double value) { return description::number(value, pick(3) == 0 ? 6 : pick(2) == 0 ? 17 : 9); }
  double angle() { return pick(4) == 0 ? between(-3.0, 3.0) : M_PI / 2.0 * (pick(5) - 2) + tiny(); }
  double length() { return pick(3) == 0 ? tiny() * 0.1 : pick(2) == 0 ? 0.25 + 1e-3 * tiny() : between(-0.4, 0.4); }
  std::string rpy() { return "rpy=\"" + number(angle()) + " " + number(angle()) + " " + number(angle()) + "\""; }
  std::string xyz() { return "xyz=\"" + number(length()) + " " + number(length()) + " " + number(length()) + "\""; }
  std::string axis() {
    double a[3] = {tiny(), tiny(), tiny()};
    a[pick(3)] += pick(2) == 0 ? 1.0 : -1.0;
    if (pick(4) == 0) a[pick(3)] += between(0.3, 1.0);
    return "<axis xyz=\"" + number(a[0]) + " " + number(a[1]) + " " + number(a[2]) + "\"/>";
  }
  std::string link(int i) {
    return "<link name=\"l" + std::to_string(i) + "\"><inertial><origin " + xyz() + " " + rpy() + "/><mass value=\"" +
           number(between(0.1, 3.0)) + "\"/><inertia ixx=\"0.011\" ixy=\"0.001\" ixz=\"0\" iyy=\"0.022\" iyz=\"0\" " +
           "izz=\"0.023\"/></inertial></link>";
  }
  std::string joint(int i, int parent, bool moves) {
    const int kind = moves ? 0 : pick(6);
    const std::string type = kind == 5 ? "fixed" : kind == 4 ? "prismatic" : "revolute";
    const std::string name = "j" + std::to_string(i);
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"l" + std::to_string(parent) +
           "\"/><child link=\"l" + std::to_string(i) + "\"/><origin " + xyz() + " " + rpy() + "/>" + axis() +
           "<limit lower=\"-1\" upper=\"1.5\" effort=\"3\" velocity=\"2\"/></joint>";
  }

  std::mt19937 random_;
};

// Whatever is near: nothing is changed by more than it may be, all of it is among the changes, and the header is the
// text to 1e-12. Axes that are nearly parallel beyond that have lengths that no header has: those are refused by name.
TEST(Truth, OfDrawnDescriptions) {
  int good = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Options options;
    options.states = 5, options.as_published = true;
    const auto text = Drawn(seed).urdf();
    try {
      const auto result = importer::import_text(text, "drawn", options);
      EXPECT_LE(result.figures.changed_angle, 1e-5 + 1e-12);
      EXPECT_LE(result.figures.changed_length, 1e-5);
      double longest = 1.0;
      for (const auto& link : result.imported.robot.links)
        for (const double length : {link.parameters.a, link.parameters.d, link.parameters.b})
          longest = std::max(longest, std::abs(length));
      EXPECT_LE(result.figures.pose, 1e-12 * longest);
      EXPECT_LE(result.figures.body, 1e-12 * longest * longest);
      EXPECT_LE(result.figures.limits, 0.0);
      good += result.figures.good();
    } catch (const description::Refused& refused) {
      ADD_FAILURE() << refused.what();
    }
  }
  EXPECT_GE(good, 150);
}

TEST(Truth, AxesThatAreParallelTo1em7AreParallel) {
  for (const char* roll : {"1e-7", "-1e-7", "3.14159255", "9e-6", "-3.1415926"}) {
    auto text = changed(arms::urdf, "rpy=\"1.5707963267948966 0 0.4\"", std::string("rpy=\"") + roll + " 0 0.4\"");
    text = changed(text, "xyz=\"0 1 1\"", "xyz=\"0 0 1\"");
    const auto result = importer::import_text(text, "arm", {});
    EXPECT_TRUE(result.figures.good()) << roll;
    EXPECT_LE(std::abs(result.imported.robot.links[1].parameters.d), 1.0) << roll;
    EXPECT_EQ(result.imported.robot.links[1].parameters.alpha.sin, 0.0) << roll;
  }
  // Parallel by what several joints and fixed joints add up to, none of which is near anything.
  auto text = changed(arms::urdf, "xyz=\"0 0 0.3\" rpy=\"0 0 0\"", "xyz=\"0 0 0.3\" rpy=\"0.3 0 0\"");
  text = changed(changed(text, "rpy=\"1.5707963267948966 0 0.4\"", "rpy=\"0.7000001 0 0\""), "xyz=\"0 0 1\"",
                 "xyz=\"0 1 0\"");
  text = changed(text, "rpy=\"0 1.5708 0\"", "rpy=\"0 0 0\"");
  text = changed(text, "xyz=\"0 1 1\"", "xyz=\"0 0.7648421872844885 -0.644217687237691\"");
  const auto result = importer::import_text(text, "arm", {});
  EXPECT_TRUE(result.figures.good());
  EXPECT_EQ(result.imported.robot.links[1].parameters.alpha.sin, 0.0);
  EXPECT_TRUE(result.figures.changed_angle > 1e-8 && result.figures.changed_angle < 2e-7);
}

TEST(Truth, ConstantsHaveTheDigitsThatTheyHave) {
  auto text = changed(arms::urdf, "xyz=\"0.25 0 0.1\"", "xyz=\"0.0388353 -8.97657e-09 0.0624\"");
  text = changed(text, "rpy=\"1.5707963267948966 0 0.4\"", "rpy=\"3.14159 4.18253e-17 -3.14159\"");
  text = changed(changed(text, "xyz=\"0 1 1\"", "xyz=\"0 1e-9 1\""), "xyz=\"0.15 0 0.01\"",
                 "xyz=\"5.3e-06 -0.0301 0.01\"");
  text = changed(text, "rpy=\"0.1 0.2 0.3\"", "rpy=\"0 0 0\"");
  const auto header = description::header(importer::import_text(text, "arm", {}).imported.robot, {});
  EXPECT_TRUE(says(header, ".a(0.0388353).alpha_deg(180)")) << header;
  EXPECT_TRUE(says(header, ".com(0.1, 0.02, 0.3).inertia_com(0.011, 0.022, 0.023, 0.001, 0.0, 0.0)")) << header;
  EXPECT_FALSE(says(header, "base(") || says(header, "theta")) << header;
}

// Two axes that miss each other by the rounding of one's direction meet.
TEST(Truth, LengthsFinerThanTheDigitsAreNone) {
  auto text = changed(changed(arms::urdf, "xyz=\"0 1 1\"", "xyz=\"0.6 0.8000001 0\""),
                      "rpy=\"1.5707963267948966 0 0.4\"", "rpy=\"0 0 0\"");
  text = changed(text, "xyz=\"0.25 0 0.1\"", "xyz=\"0.15 0.2 0.1\"");
  const auto result = importer::import_text(text, "arm", {});
  EXPECT_TRUE(result.figures.good());
  EXPECT_EQ(result.imported.robot.links[1].parameters.a, 0.0);
  EXPECT_TRUE(result.figures.changed_length > 1e-8 && result.figures.changed_length < 1e-7);
  Options options;
  options.reading.right_angles = 0.0;
  const auto written = importer::import_text(text, "arm", options);
  EXPECT_TRUE(written.figures.good());
  EXPECT_NEAR(std::abs(written.imported.robot.links[1].parameters.a), 1.5e-8, 1e-12);
  EXPECT_EQ(written.figures.changed_length, 0.0);
}

TEST(Blank, LimitsAreNotGiven) {
  const std::string limit = "lower=\"-1.5\" upper=\"1.25\" effort=\"10\" velocity=\"2\"";
  for (const char* blank : {"lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"", "effort=\"10\" velocity=\"2\"",
                            "lower=\"0\" upper=\"0\" effort=\"10\"", ""}) {
    const auto text = changed(arms::urdf, limit, blank);
    const auto result = importer::import_text(text, "arm", {});
    EXPECT_TRUE(result.figures.good());
    EXPECT_TRUE(says(assumptions(result),
                     "position limits of a turn either way (fixed point needs limits; wrap the angle): shoulder"))
        << blank;
    Options options;
    options.assumed.position = 1.75, options.assumed.speed = 3.0, options.assumed.effort = 7.0;
    const auto p = importer::import_text(text, "arm", options).imported.robot.links[0].parameters;
    EXPECT_EQ(p.position_min, -1.75);
    EXPECT_EQ(p.position_max, 1.75);
    EXPECT_EQ(p.speed_limit, says(blank, "velocity=\"2\"") ? 2.0 : 3.0);
    EXPECT_EQ(p.effort_limit, says(blank, "effort=\"10\"") ? 10.0 : 7.0);
  }
  const auto none = importer::import_text(changed(arms::urdf, "<limit " + limit + "/>", ""), "arm", {});
  EXPECT_TRUE(says(assumptions(none), "no effort limit: shoulder"));
}

TEST(Blank, AMimicTakesItsLeaders) {
  const auto text = changed(changed(arms::urdf, "<limit lower=\"0\" upper=\"0.3\" effort=\"20\" velocity=\"1\"/>", ""),
                            "<axis xyz=\"0 1 1\"/>",
                            "<axis xyz=\"0 1 1\"/><mimic joint=\"shoulder\" multiplier=\"-0.2\" offset=\"0.01\"/>");
  const auto result = importer::import_text(text, "arm", {});
  EXPECT_TRUE(result.figures.good());
  const auto& p = result.imported.robot.links[1].parameters;
  EXPECT_DOUBLE_EQ(p.position_min, -0.2 * 1.25 + 0.01);
  EXPECT_DOUBLE_EQ(p.position_max, 0.2 * 1.5 + 0.01);
  EXPECT_DOUBLE_EQ(p.speed_limit, 0.4);
  EXPECT_TRUE(says(assumptions(result), "limits of the joints that they mimic: elbow"));
  EXPECT_FALSE(description::header(result.imported.robot, {}).empty());
}

TEST(Absurd, JointsThatNothingResistsAreNamed) {
  // A point mass on its own axis, and a joint beyond it that does carry something.
  auto text = changed(arms::urdf, "xyz=\"0 1 1\"", "xyz=\"0 0 1\"");
  text = changed(text, "type=\"prismatic\"", "type=\"revolute\"");
  text = changed(text, "xyz=\"0.15 0 0.01\"", "xyz=\"0 0 0.01\"");
  text = changed(text, "ixx=\"0.004\" ixy=\"0\" ixz=\"0\" iyy=\"0.012\" iyz=\"0\" izz=\"0.013\"",
                 "ixx=\"0.004\" ixy=\"0\" ixz=\"0\" iyy=\"0.004\" iyz=\"0\" izz=\"0\"");
  text = changed(text, "xyz=\"0.1 0 0\" rpy=\"0 1.5708 0\"", "xyz=\"0 0 0.1\" rpy=\"0 0 0\"");
  text = changed(text, "ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.002\" iyz=\"0\" izz=\"0.002\"",
                 "ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.001\" iyz=\"0\" izz=\"0\"");
  const auto result = importer::import_text(text, "arm", {});
  EXPECT_TRUE(says(warnings(result), "link 'fore': joint 'elbow' is resisted by 0 kg m^2")) << warnings(result);
  EXPECT_FALSE(says(warnings(importer::import_text(arms::urdf, "arm", {})), "resisted"));
}

TEST(Absurd, InertiasLargerThanTheRobotAreNamed) {
  const auto text = changed(arms::urdf, "izz=\"0.013\"", "izz=\"1000\"");
  EXPECT_TRUE(
      says(warnings(importer::import_text(text, "arm", {})),
           "link 'fore': joint 'elbow' moves 2 kg with an inertia of 500 kg m^2: a radius of gyration of 15.8 m"));
  EXPECT_FALSE(says(warnings(importer::import_text(arms::urdf, "arm", {})), "gyration"));
}

}  // namespace
