// Classical Denavit-Hartenberg tables against the MDH chains of the same robots, in constants and in operations.
#include <axial/robot/classical.hpp>

#include <gtest/gtest.h>

#include <axial/cost.hpp>
#include <robots/scara.hpp>

using namespace axial;

namespace {

using Scara = robots::Scara;

/// Table I of Djuric et al. 2016, rods with their centres of mass half-way back from the far end.
struct ClassicalScara {
  static constexpr double rod1 = Scara::rod1, rod2 = Scara::rod2, rod3 = Scara::rod3;
  static constexpr auto chain = classical_chain(gravity(0.0, 0.0, -9.8125), payload_limit(2.0, 0.25, 0.05),
                                                classical_revolute()
                                                    .d(0.5)
                                                    .a(Scara::a1)
                                                    .alpha_deg(0)
                                                    .mass(Scara::m1)
                                                    .com(-Scara::a1 / 2, 0, 0)
                                                    .inertia_com(0, rod1, rod1)
                                                    .position_limits(-2.5, 2.5)
                                                    .speed_limit(4)
                                                    .acceleration_limit(20)
                                                    .effort_limit(80),
                                                classical_revolute()
                                                    .a(Scara::a2)
                                                    .alpha_deg(180)
                                                    .mass(Scara::m2)
                                                    .com(-Scara::a2 / 2, 0, 0)
                                                    .inertia_com(0, rod2, rod2)
                                                    .position_limits(-2.6, 2.6)
                                                    .speed_limit(5)
                                                    .acceleration_limit(30)
                                                    .effort_limit(25),
                                                classical_prismatic()
                                                    .mass(Scara::m3)
                                                    .com(0, 0, -Scara::length3 / 2)
                                                    .inertia_com(rod3, rod3, 0)
                                                    .position_limits(0, 0.25)
                                                    .speed_limit(1)
                                                    .acceleration_limit(10)
                                                    .effort_limit(30));
};

/// The Puma 560 of the robotics toolbox in its own classical table; and by hand, in MDH frames with Craig's names.
struct ClassicalPuma {
  static constexpr auto chain = classical_chain(
      accept(as_published), classical_revolute().d(0.67183).alpha_deg(90).inertia_com(0, 0.35, 0),
      classical_revolute().a(0.4318).mass(17.4).com(-0.3638, 0.006, 0.2275).inertia_com(0.13, 0.524, 0.539),
      classical_revolute()
          .d(0.15005)
          .a(0.0203)
          .alpha_deg(-90)
          .mass(4.8)
          .com(-0.0203, -0.0141, 0.07)
          .inertia_com(0.066, 0.086, 0.0125),
      classical_revolute().d(0.4318).alpha_deg(90).mass(0.82).com(0, 0.019, 0).inertia_com(1.8e-3, 1.3e-3, 1.8e-3),
      classical_revolute().alpha_deg(-90).mass(0.34).inertia_com(0.3e-3, 0.4e-3, 0.3e-3),
      classical_revolute().mass(0.09).com(0, 0, 0.032).inertia_com(0.15e-3, 0.15e-3, 0.04e-3));
};
struct CraigPuma {
  static constexpr auto chain = axial::chain(
      accept(as_published), revolute().d(0.67183).inertia_com(0, 0, 0.35),
      revolute().alpha_previous_deg(90).mass(17.4).com(-0.3638 + 0.4318, 0.006, 0.2275).inertia_com(0.13, 0.524, 0.539),
      revolute().a_previous(0.4318).d(0.15005).mass(4.8).com(0, 0.07, 0.0141).inertia_com(0.066, 0.0125, 0.086),
      revolute()
          .a_previous(0.0203)
          .alpha_previous_deg(-90)
          .d(0.4318)
          .mass(0.82)
          .com(0, 0, 0.019)
          .inertia_com(1.8e-3, 1.8e-3, 1.3e-3),
      revolute().alpha_previous_deg(90).mass(0.34).inertia_com(0.3e-3, 0.3e-3, 0.4e-3),
      revolute().alpha_previous_deg(-90).mass(0.09).com(0, 0, 0.032).inertia_com(0.15e-3, 0.15e-3, 0.04e-3));
};

template <int N>
constexpr bool same_constants(const Chain<N>& left, const Chain<N>& right) {
  for (int i = 0; i < N; ++i) {
    const auto x = link_constants(left.links[i], left.parent(i)), y = link_constants(right.links[i], right.parent(i));
    if (x.prismatic != y.prismatic || x.parent != y.parent) return false;
    for (auto number : link_numbers<double>)
      if (x.*number != y.*number) return false;
  }
  return true;
}
constexpr bool same(const FixedPose& left, const FixedPose& right) {
  for (int i = 0; i < 9; ++i)
    if (left.rotation[i] != right.rotation[i]) return false;
  for (int i = 0; i < 3; ++i)
    if (left.position[i] != right.position[i]) return false;
  return true;
}
constexpr bool same(const LinkParameters& left, const LinkParameters& right) {
  return left.a == right.a && left.alpha.radians == right.alpha.radians && left.alpha.cos == right.alpha.cos &&
         left.alpha.sin == right.alpha.sin && left.d == right.d && left.theta.radians == right.theta.radians;
}

template <class Left, class Right, class Algorithm>
constexpr bool same_cost(Algorithm) {
  return cost<Left>(Algorithm{}) == cost<Right>(Algorithm{});
}
template <class Left, class Right>
constexpr bool same_costs() {
  return same_cost<Left, Right>(algorithm::inverse_dynamics) && same_cost<Left, Right>(algorithm::mass_matrix) &&
         same_cost<Left, Right>(algorithm::forward_dynamics) && same_cost<Left, Right>(algorithm::forward_kinematics);
}

/// A link about whose drive everything is said.
constexpr auto with_drive = [](auto link) {
  return link.rotor_inertia(1e-4, 50)
      .viscous(0.5)
      .coulomb(0.3, -0.2)
      .stribeck(0.6, 0.1)
      .smooth_speed(0.01)
      .spring(7, 0.5)
      .stiffness(9);
};

}  // namespace

TEST(ClassicalChain, ScaraIsItsMdhFormToTheLastBit) {
  static_assert(same_constants(ClassicalScara::chain, Scara::chain));
  static_assert(same(ClassicalScara::chain.tool.pose, Scara::chain.tool.pose));
  static_assert(ClassicalScara::chain.gravity.z == Scara::chain.gravity.z);
  static_assert(ClassicalScara::chain.payload_limit.com_reach == Scara::chain.payload_limit.com_reach);
  const Joints<ClassicalScara, double> q{{0.25, -1.25, 0.125}}, qd{{1.5, -2, 0.5}}, qdd{{3, 4, -1}};
  const Joints<Scara, double> p{{0.25, -1.25, 0.125}}, pd{{1.5, -2, 0.5}}, pdd{{3, 4, -1}};
  const auto tau = inverse_dynamics<ClassicalScara>(q, qd, qdd);
  const auto expected = inverse_dynamics<Scara>(p, pd, pdd);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(tau[i], expected[i]) << i;
}

TEST(ClassicalChain, PumaIsItsMdhFormToTheLastBit) {
  static_assert(same_constants(ClassicalPuma::chain, CraigPuma::chain));
}

TEST(ClassicalChain, CostsWhatTheMdhChainCosts) {
  static_assert(same_costs<ClassicalScara, Scara>());
  static_assert(same_costs<ClassicalPuma, CraigPuma>());
}

TEST(ClassicalChain, AnyTwistKeepsWhatIsSymmetricAboutXAndAddsNoProducts) {
  constexpr auto tilted =
      classical_chain(classical_revolute().alpha_deg(33).a(0.5).mass(2).com(-0.25, 0, 0).inertia_com(0.1, 0.7, 0.7))
          .links[0];
  static_assert(tilted.inertia_com[1] == 0.7 && tilted.inertia_com[2] == 0.7 && tilted.inertia_com[5] == 0.0);
  static_assert(tilted.com[0] == 0.25 && tilted.com[1] == 0.0 && tilted.com[2] == 0.0);
}

TEST(ClassicalChain, LastRowLeadsToTheTool) {
  constexpr auto arm = classical_chain(classical_revolute().a(0.5).alpha_deg(90), tool(0.25, 0.0, 0.125));
  static_assert(same(arm.tool.pose, {{1, 0, 0, 0, 0, -1, 0, 1, 0}, {0.75, -0.125, 0.0}}));
  static_assert(arm.links[0].a == 0.0 && arm.links[0].alpha.cos == 1.0);
}

TEST(ClassicalChain, AToolThatIsTurnedIsTurnedWithTheLastRow) {
  // Its axes are y, z, x of the last classical frame, in rows (0 0 1), (1 0 0), (0 1 0); half a turn about x turns the
  // lower two, a quarter puts the one in place of the other.
  constexpr auto turned = [](double degrees) {
    return classical_chain(classical_revolute().alpha_deg(degrees), tool({{0, 0, 1, 1, 0, 0, 0, 1, 0}, {0.5, 0.25, 1}}))
        .tool.pose;
  };
  static_assert(same(turned(0), {{0, 0, 1, 1, 0, 0, 0, 1, 0}, {0.5, 0.25, 1}}));
  static_assert(same(turned(180), {{0, 0, 1, -1, 0, 0, 0, -1, 0}, {0.5, -0.25, -1}}));
  static_assert(same(turned(90), {{0, 0, 1, 0, -1, 0, 1, 0, 0}, {0.5, -1, 0.25}}));
  static_assert(same(turned(-90), {{0, 0, 1, 0, 1, 0, -1, 0, 0}, {0.5, 1, -0.25}}));
}
TEST(ClassicalChain, PayloadLimitReachesAroundTheFarEnd) {
  constexpr auto arm = classical_chain(payload_limit(1, 0.25, 0.1), classical_revolute().a(-0.5));
  static_assert(arm.payload_limit.com_reach == 0.75);
  constexpr auto with_tools = classical_chain(tool_limit(0.125), classical_revolute().a(-0.5));
  static_assert(with_tools.tool_limit.declared && with_tools.tool_limit.reach == 0.625);
}

TEST(ClassicalChain, DriveLimitsBaseAndOffsetsCarryOver) {
  constexpr auto c =
      classical_chain(gravity(1, 2, 3), base(4, 5, 6), base_body().mass(7),
                      with_drive(classical_prismatic().theta_deg(90).d(0.5).a(1)).position_limits(-1, 2));
  constexpr auto m = axial::chain(gravity(1, 2, 3), base(4, 5, 6), base_body().mass(7),
                                  with_drive(prismatic().theta_deg(90).d(0.5)).position_limits(-1, 2));
  constexpr auto p = c.links[0], r = m.links[0];
  static_assert(p.type == r.type && same(p, r) && p.rotor_inertia == r.rotor_inertia && p.gear == r.gear);
  static_assert(p.viscous == r.viscous && p.coulomb_forward == r.coulomb_forward && p.spring_rest == r.spring_rest &&
                p.coulomb_backward == r.coulomb_backward && p.static_friction == r.static_friction &&
                p.stribeck_speed == r.stribeck_speed && p.smooth_speed == r.smooth_speed &&
                p.spring_stiffness == r.spring_stiffness && p.position_min == r.position_min &&
                p.position_max == r.position_max && p.stiffness == 9 && r.stiffness == 9);
  static_assert(c.gravity.y == m.gravity.y && same(c.base.pose, m.base.pose) && c.base_body.mass == 7.0 &&
                c.has_base_body);
}

TEST(Link, CraigsNamesAreKhalils) {
  static_assert(same(revolute().a_previous(0.5).alpha_previous(0.7).d(1).theta(2).parameters(),
                     revolute().a(0.5).alpha(0.7).d(1).theta(2).parameters()));
  static_assert(same(prismatic().a_previous(0.5).alpha_previous_deg(-90).parameters(),
                     prismatic().a(0.5).alpha_deg(-90).parameters()));
}
