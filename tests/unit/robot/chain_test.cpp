#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <robots/robots.hpp>

using namespace axial;

namespace {

constexpr auto everything = axial::chain(axial::gravity(1, 2, 3),
                                         revolute()
                                             .a(0.1)
                                             .alpha_deg(-90)
                                             .d(0.2)
                                             .theta_deg(180)
                                             .mass(2)
                                             .com(0.1, 0.2, 0.3)
                                             .inertia_com(3, 2, 1, 0.1, 0.2, 0.3)
                                             .rotor_inertia(1e-4, 50)
                                             .viscous(0.5)
                                             .coulomb(0.3, -0.2)
                                             .position_limits(-1, 1)
                                             .speed_limit(2)
                                             .acceleration_limit(3)
                                             .effort_limit(4),
                                         prismatic().theta(0.5));

template <class T, class = decltype(std::declval<T>().payload)>
constexpr bool names_payload(int) {
  return true;
}
template <class T>
constexpr bool names_payload(...) {
  return false;
}

struct Impossible {  // 0.5 > 0.1 + 0.1: no mass is distributed so
  static constexpr auto chain = axial::chain(accept(as_published), revolute().mass(1).inertia_com(0.2, 0.2, 0.3),
                                             revolute().mass(1).inertia_com(0.1, 0.5, 0.1));
};

}  // namespace

TEST(Chain, HoldsWhatWasWritten) {
  constexpr auto& l = everything.links[0];
  static_assert(everything.size == 2 && everything.gravity.y == 2);
  static_assert(l.a == 0.1 && l.alpha.sin == -1.0 && l.alpha.cos == 0.0 && l.theta.cos == -1.0 && l.theta.sin == 0.0);
  static_assert(l.com[2] == 0.3 && l.inertia_com[3] == 0.1 && l.gear == 50 && l.coulomb_backward == -0.2);
  static_assert(l.position_min == -1 && l.speed_limit == 2 && l.acceleration_limit == 3 && l.effort_limit == 4);
  static_assert(everything.links[1].type == JointType::prismatic && everything.parent(1) == 0 &&
                everything.parent(0) == -1);
}

TEST(Chain, OneCoulombValueHoldsInBothDirections) {
  constexpr auto l = revolute().coulomb(0.7).parameters();
  static_assert(l.coulomb_forward == 0.7 && l.coulomb_backward == -0.7);
}

TEST(Chain, LimitsInDegreesAreRadians) {
  constexpr auto l = revolute().position_limits_deg(-180, 90).parameters();
  static_assert(l.position_min > -3.1415926535898 && l.position_min < -3.1415926535897);
  static_assert(l.position_max > 1.5707963267948 && l.position_max < 1.5707963267949);
}

TEST(Chain, WhatIsAcceptedIsKeptAsItIs) {
  constexpr auto published =
      axial::chain(axial::accept(axial::as_published), gravity(0, 0, -9.81), gravity(0, 0, -1.62),
                   revolute().a(300).inertia_com(0, 0, 0.35).mass(1).mass(0));
  constexpr auto l = published.links[0];
  static_assert(l.a == 300 && l.inertia_com[2] == 0.35 && l.mass == 0.0 && published.gravity.z == -1.62);
  constexpr auto one = axial::chain(revolute().accept(axial::as_published).a(300).inertia_com(0, 0, 0.35));
  static_assert(one.links[0].a == 300 && one.links[0].inertia_com[2] == 0.35);
  constexpr auto body = axial::chain(base_body().inertia_com(0, 0, 0.35).accept(axial::as_published), revolute());
  static_assert(body.has_base_body && body.base_body.inertia_com[2] == 0.35);
}

TEST(Angle, QuarterTurnsAreExactInEitherDirection) {
  for (int k = -9; k <= 9; ++k) {
    const auto angle = Angle::from_degrees(90.0 * k);
    EXPECT_EQ(angle.cos * angle.cos + angle.sin * angle.sin, 1.0);
    EXPECT_EQ(angle.cos * angle.sin, 0.0);
    EXPECT_NEAR(angle.cos, std::cos(angle.radians), 1e-14);
    EXPECT_NEAR(angle.sin, std::sin(angle.radians), 1e-14);
  }
}

TEST(Inertia, AboutOriginAndAboutCentreOfMassAgree) {
  constexpr auto com = revolute().mass(2).com(0.1, -0.2, 0.3).inertia_com(0.5, 0.6, 0.7, 0.01, 0.02, 0.03).parameters();
  constexpr auto derived = link_constants(com, -1);
  constexpr auto origin =
      revolute()
          .mass(2)
          .com(0.1, -0.2, 0.3)
          .inertia_origin(derived.jxx, derived.jyy, derived.jzz, derived.jxy, derived.jxz, derived.jyz)
          .parameters();
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(origin.inertia_com[i], com.inertia_com[i], 4e-16) << i;
  EXPECT_NEAR(derived.jxx, 0.5 + 2 * (0.04 + 0.09), 4e-16);
  EXPECT_NEAR(derived.jxy, 0.01 + 2 * 0.1 * 0.2, 4e-16);
}

TEST(Scene, InputsHoldOneMemberANamedFeature) {
  using R = robots::Scara;
  static_assert(sizeof(Inputs<R, float>) == 1, "empty");
  static_assert(!names_payload<Inputs<Scene<R, Gravity, TipWrench>, float>>(0));
  static_assert(names_payload<Inputs<Scene<R, Gravity, Payload>, float>>(0));
  static_assert(sizeof(Inputs<Scene<R, TipWrench>, float>) == 6 * sizeof(float));
}

TEST(Scene, ABareRobotHasGravityAndRotorsButNoFriction) {
  using S = scene_of<robots::Puma560>;
  static_assert(S::has<Gravity> && S::has<RotorInertia> && !S::has<Friction> && !S::has<Payload> && !S::has<TipWrench>);
  const Joints<robots::Puma560, double> rest{}, spin{0, 0, 0, 0, 0, 1.0};
  const auto with = inverse_dynamics<robots::Puma560>(rest, rest, spin);
  const auto without = inverse_dynamics<Scene<robots::Puma560, Gravity>>(rest, rest, spin);
  constexpr auto& link = robots::Puma560::chain.links[5];
  EXPECT_NEAR(with[5] - without[5], link.gear * link.gear * link.rotor_inertia, 1e-12);
}

TEST(Model, RefusesWhatDoesNotFit) {
  Model<2> model;
  EXPECT_FALSE(model.add(revolute().parent(0))) << "its parent does not exist yet";
  EXPECT_TRUE(model.add(revolute().mass(1)));
  EXPECT_TRUE(model.add(revolute().mass(1)));
  EXPECT_FALSE(model.add(revolute().mass(1))) << "full";
  EXPECT_EQ(model.size(), 2);
}

TEST(Consistency, IsAQueryThatNamesTheLink) {
  static_assert(!physically_consistent<Impossible>() && first_inconsistent_link<Impossible>() == 1);
  static_assert(physically_consistent<robots::Scara>());
  // Off-diagonal entries decide too: the diagonal alone is fine here.
  static_assert(!physically_consistent({0.2, 0.2, 0.2, 0.19, 0.0, 0.0}, 1.0));
  static_assert(physically_consistent({0.0, 0.1, 0.1, 0.0, 0.0, 0.0}, 1.0), "a rod is the limit and is allowed");
}
