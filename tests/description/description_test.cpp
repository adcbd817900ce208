// Tables, findings, headers and the run-time model of a description.
#include <axial/axial.hpp>
#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/description/known_robots.hpp>
#include <host_sim/robots/description/table.hpp>

#include <gtest/gtest.h>

namespace {

using namespace description;

std::string message_of(const std::string& text) {
  try {
    check(to_mdh(parse_table(text, "arm.json")));
  } catch (const Refused& refused) {
    return refused.what();
  }
  return "";
}

std::string arm_with(const std::string& row) {
  return R"({"name": "arm", "convention": "modified", "links": [{"type": "revolute", "mass": 1, "inertia_com": [1, 1, 1])" +
         row + "}]}";
}

TEST(Angles, AreExactWhereTheyAreMultiplesOf90Degrees) {
  const auto right = canonical_angle(1.5707963267948966L);
  EXPECT_EQ(right.cos, 0.0);
  EXPECT_EQ(right.sin, 1.0);
  EXPECT_EQ(exact_degrees(right).value(), 90.0);
  EXPECT_EQ(exact_degrees(axial::Angle::from_degrees(-37.25)).value(), -37.25);
  EXPECT_FALSE(exact_degrees(axial::Angle::from_radians(1.23456789012345)).has_value());
}

TEST(Table, ClassicalEqualsTheCompilersConversion) {
  const auto table =
      parse_table(R"({"name": "two", "convention": "classical", "tool": {"xyz": [0, 0.1, 0.2]}, "links": [
      {"type": "revolute", "a": 0.3, "alpha_deg": 90, "mass": 2, "com": [-0.1, 0.02, 0], "inertia_com": [1, 2, 2.5, 0.1, 0.2, 0.3]},
      {"type": "prismatic", "a": 0.1, "alpha": 0.4, "theta_deg": 30, "mass": 1, "inertia_origin": [1, 1, 1]}]})",
                  "two.json");
  const auto robot = to_mdh(table);
  constexpr auto expected = axial::classical_chain(
      axial::tool(0, 0.1, 0.2),
      axial::classical_revolute().a(0.3).alpha_deg(90).mass(2).com(-0.1, 0.02, 0).inertia_com(1, 2, 2.5, 0.1, 0.2, 0.3),
      axial::classical_prismatic().a(0.1).alpha(0.4).theta_deg(30).mass(1).inertia_origin(1, 1, 1));
  for (int i = 0; i < 2; ++i) {
    const auto& p = robot.links[static_cast<std::size_t>(i)].parameters;
    const auto& e = expected.links[i];
    EXPECT_EQ(p.a, e.a);
    EXPECT_EQ(p.alpha.sin, e.alpha.sin);
    EXPECT_EQ(p.theta.cos, e.theta.cos);
    for (int k = 0; k < 6; ++k)
      EXPECT_EQ(p.inertia_com[k], e.inertia_com[k]);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(p.com[k], e.com[k]);
  }
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(robot.tool.position[k], expected.tool.pose.position[k]);
}

TEST(Table, ErrorsNameLinkValueAndRemedy) {
  EXPECT_EQ(message_of(arm_with("")), "");
  EXPECT_NE(message_of(arm_with(R"(, "mass_kg": 1)")).find("\"mass_kg\" is not known"), std::string::npos);
  EXPECT_NE(message_of(arm_with(R"(, "a": 1,5)")).find("neither 1,5 nor nan"), std::string::npos);
  EXPECT_NE(message_of(arm_with(R"(, "viscous": -2)")).find("viscous friction is -2"), std::string::npos);
  EXPECT_NE(message_of(arm_with(R"(, "a": 1, "a": 2)")).find("\"a\" stands twice"), std::string::npos);
  EXPECT_NE(message_of(arm_with(R"(, "position_limits": [1, -1])")).find("upside down: 1 to -1"), std::string::npos);
}

TEST(Findings, SayByHowMuchTheTriangleInequalityIsViolated) {
  axial::LinkParameters p;
  p.mass = 1.0, p.inertia_com[0] = p.inertia_com[1] = 1.0, p.inertia_com[2] = 2.06;
  const auto found = body_findings("forearm", p, false);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].error);
  EXPECT_NE(found[0].text().find("link 'forearm': inertia violates the triangle inequality by 3 %"), std::string::npos);
  p.inertia_com[2] = 1.99;
  EXPECT_TRUE(body_findings("forearm", p, false).empty());
}

TEST(Header, IsTheSameTwiceAndNamesTheRobot) {
  auto robot = known_robot("panda");
  robot.name = "my-arm 7";
  EXPECT_EQ(header(robot, {"poses: 1e-15"}), header(robot, {"poses: 1e-15"}));
  EXPECT_EQ(type_name(robot), "MyArm7");
  EXPECT_EQ(plain_name(robot), "my_arm_7");
}

TEST(Model, OfAKnownRobotHoldsItsLinks) {
  const auto robot = known_robot("two_arm");
  const auto model = to_model<axial::Model<most_links, axial::Gravity, axial::RotorInertia>>(robot);
  ASSERT_EQ(model.size(), 7);
  EXPECT_EQ(model.constants(4).parent, 0);
  EXPECT_EQ(model.constants(4).mass, 4.6);
  EXPECT_THROW(known_robot("nobody"), Refused);
}

}  // namespace
