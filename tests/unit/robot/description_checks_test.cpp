// Every rule of a description on values: the last number that keeps it, and the first that breaks it.
#include <gtest/gtest.h>
#include <axial/robot/chain.hpp>
#include <axial/robot/description_checks.hpp>
#include <cmath>
#include <functional>

using namespace axial;
using detail::Problem;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), no_number = std::numeric_limits<double>::quiet_NaN();
using Change = std::function<void(LinkParameters&)>;

/// The problem of the third link of a robot, which was sound.
Problem after(const Change& change, JointType type = JointType::revolute, bool accepted = false) {
  LinkParameters p;
  p.type = type, p.mass = 1.0, p.inertia_com[0] = p.inertia_com[1] = p.inertia_com[2] = 1.0;
  change(p);
  detail::Given given;
  given.note(detail::Quantity::mass);
  return detail::link_problem(p, given, 2, accepted);
}

void expect_between(double LinkParameters::*field, double good, double bad, Problem problem) {
  EXPECT_EQ(after([&](auto& p) { p.*field = good; }), Problem::none) << good;
  EXPECT_EQ(after([&](auto& p) { p.*field = bad; }), problem) << bad;
  EXPECT_EQ(after([&](auto& p) { p.*field = no_number; }) == Problem::none, false);
}
double above(double x) { return std::nextafter(x, inf); }
double below(double x) { return std::nextafter(x, -inf); }

constexpr bool body(double xx, double yy, double zz, double xy, double xz, double yz, double mass = 1.0,
                    double tolerance = 1e-9) {
  const double j[] = {xx, yy, zz, xy, xz, yz};
  return physically_consistent(j, mass, tolerance);
}

}  // namespace

TEST(DescriptionChecks, ASoundLinkHasNoProblem) {
  EXPECT_EQ(after([](auto&) {}), Problem::none);
}

TEST(DescriptionChecks, LengthsEndAtAHundredMetres) {
  for (const double sign : {1.0, -1.0}) {
    expect_between(&LinkParameters::a, sign * 100, sign * above(100), Problem::a_is_beyond_100_m);
    expect_between(&LinkParameters::d, sign * 100, sign * above(100), Problem::d_is_beyond_100_m);
    expect_between(&LinkParameters::b, sign * 100, sign * above(100), Problem::b_of_branch_is_beyond_100_m);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(after([&](auto& p) { p.com[k] = sign * above(100); }), Problem::com_is_beyond_100_m) << k;
      EXPECT_EQ(after([&](auto& p) { p.water.centre[k] = sign * 101; }), Problem::buoyancy_centre_is_beyond_100_m) << k;
    }
  }
  EXPECT_EQ(after([](auto& p) { p.a = inf; }), Problem::a_or_d_is_not_finite);
  EXPECT_EQ(after([](auto& p) { p.d = -inf; }), Problem::a_or_d_is_not_finite);
  EXPECT_EQ(after([](auto& p) { p.b = inf; }), Problem::branch_is_not_finite);
}

TEST(DescriptionChecks, LinksWeighATonAtMostBodiesThatFloatMore) {
  expect_between(&LinkParameters::mass, 1000, above(1000), Problem::mass_is_beyond_1000_kg);
  EXPECT_EQ(after([](auto& p) { p.mass = 1200; }, JointType::revolute, true), Problem::none) << "as published";
  constexpr auto ship = chain(gravity(0, 0, 0), revolute().mass(1), base_body().mass(1e6));
  EXPECT_EQ(ship.base_body.mass, 1e6);
}

TEST(DescriptionChecks, TurnsEndAtOne) {
  const auto turn = [](Angle LinkParameters::*field, double radians) {
    return after([&](auto& p) { p.*field = Angle::from_radians(radians); });
  };
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(turn(&LinkParameters::alpha, sign * 6.2831853071795862), Problem::none);
    EXPECT_EQ(turn(&LinkParameters::alpha, sign * 6.284), Problem::alpha_is_beyond_one_turn);
    EXPECT_EQ(turn(&LinkParameters::theta, sign * 6.284), Problem::theta_is_beyond_one_turn);
    EXPECT_EQ(turn(&LinkParameters::gamma, sign * 6.284), Problem::gamma_of_branch_is_beyond_one_turn);
    EXPECT_EQ(turn(&LinkParameters::alpha, sign * inf), Problem::alpha_or_theta_is_not_finite);
    EXPECT_EQ(turn(&LinkParameters::theta, sign * inf), Problem::alpha_or_theta_is_not_finite);
    EXPECT_EQ(turn(&LinkParameters::gamma, sign * inf), Problem::branch_is_not_finite);
  }
}

TEST(DescriptionChecks, AParentPrecedes) {
  const auto parent = [](int index) { return after([&](auto& p) { p.parent = index; }); };
  for (const int good : {LinkParameters::previous, LinkParameters::base, 0, 1})
    EXPECT_EQ(parent(good), Problem::none) << good;
  for (const int bad : {2, 3, -3})
    EXPECT_EQ(parent(bad), Problem::parent_does_not_precede) << bad;
}

TEST(DescriptionChecks, ACarrierOfARotorPrecedes) {
  const auto carrier = [](int index) { return after([&](auto& p) { p.rotor_carrier = index; }); };
  for (const int good : {LinkParameters::previous, LinkParameters::base, 0, 1})
    EXPECT_EQ(carrier(good), Problem::none) << good;
  for (const int bad : {2, 3, -3})
    EXPECT_EQ(carrier(bad), Problem::rotor_carrier_does_not_precede) << bad;
  for (int k = 0; k < 3; ++k)
    for (const double bad : {inf, -inf, no_number})
      EXPECT_EQ(after([&](auto& p) { p.rotor_axis[k] = bad; }), Problem::rotor_axis_is_no_direction);
  constexpr auto turning = [](double x, double y, double z) {
    return chain(gravity(0, 0, -9.81), revolute().mass(1).rotor_inertia(1e-5, 50).rotor_axis(x, y, z));
  };
  static_assert(turning(1, 0, 0).size + turning(0, 1, 0).size + turning(0, 0, 1).size == 3, "any direction is one");
}

// Each by itself: what a drive has, a joint without one has not.
TEST(DescriptionChecks, AJointWithoutADriveHasNothingOfOne) {
  DriveMatrix<2> g;
  g.drives = 1, g.ratio[0][0] = g.ratio[1][0] = 1.0, g.named[0] = g.named[1] = true, g.independent = true;
  LinkParameters bare;
  EXPECT_EQ(detail::shared_drives_problem(g, bare, 1), Problem::none);
  for (auto field : {&LinkParameters::viscous, &LinkParameters::coulomb_forward, &LinkParameters::coulomb_backward,
                     &LinkParameters::static_friction, &LinkParameters::rotor_inertia, &LinkParameters::effort_limit}) {
    LinkParameters p = bare;
    p.*field = 0.5;
    EXPECT_EQ(detail::shared_drives_problem(g, p, 0), Problem::none);
    EXPECT_EQ(detail::shared_drives_problem(g, p, 1), Problem::joint_without_drive_has_what_a_drive_has);
  }
}

TEST(DescriptionChecks, DrivesAndFrictionTakeEnergyOut) {
  expect_between(&LinkParameters::rotor_inertia, 0.0, -1e-300, Problem::rotor_inertia_is_negative);
  expect_between(&LinkParameters::gear, -1e300, inf, Problem::rotor_inertia_or_gear_is_no_value);
  const auto geared = [](double gear) { return after([&](auto& p) { p.rotor_inertia = 1.0, p.gear = gear; }); };
  EXPECT_EQ(geared(1e-300), Problem::none);
  EXPECT_EQ(geared(0.0), Problem::rotor_inertia_or_gear_is_no_value);
  expect_between(&LinkParameters::viscous, 0.0, -1e-300, Problem::viscous_is_negative);
  expect_between(&LinkParameters::coulomb_forward, 0.0, -1e-300, Problem::coulomb_feeds_energy_in);
  expect_between(&LinkParameters::coulomb_backward, 0.0, 1e-300, Problem::coulomb_feeds_energy_in);
  expect_between(&LinkParameters::smooth_speed, 1e-9, below(1e-9), Problem::smooth_speed_is_too_small);
  expect_between(&LinkParameters::spring_stiffness, -1.0, inf, Problem::spring_is_not_finite);
  expect_between(&LinkParameters::spring_rest, -1.0, inf, Problem::spring_is_not_finite);
  expect_between(&LinkParameters::stiffness, 1e-300, 0.0, Problem::stiffness_is_not_positive);
  const auto stribeck = [](double forward, double backward, double effort, double speed) {
    return after([&](auto& p) {
      p.coulomb_forward = forward, p.coulomb_backward = backward, p.static_friction = effort, p.stribeck_speed = speed;
    });
  };
  EXPECT_EQ(stribeck(2, -1, 2, 1e-9), Problem::none);
  EXPECT_EQ(stribeck(1, -2, 2, 1e-9), Problem::none);
  EXPECT_EQ(stribeck(2, -1, below(2), 1), Problem::stribeck_effort_is_below_coulomb);
  EXPECT_EQ(stribeck(1, -2, below(2), 1), Problem::stribeck_effort_is_below_coulomb);
  EXPECT_EQ(stribeck(1, -1, 2, below(1e-9)), Problem::stribeck_speed_is_too_small);
  EXPECT_EQ(stribeck(1, -1, inf, 1), Problem::stribeck_or_smooth_speed_is_not_finite);
}

TEST(DescriptionChecks, LimitsLeaveRoom) {
  const auto between = [](double low, double high, JointType type = JointType::revolute) {
    return after([&](auto& p) { p.position_min = low, p.position_max = high; }, type);
  };
  EXPECT_EQ(between(1, 1), Problem::position_limits_are_upside_down);
  EXPECT_EQ(between(no_number, 1), Problem::position_limits_are_upside_down);
  EXPECT_EQ(between(-1000.0, 1000.0), Problem::none);
  EXPECT_EQ(between(-1000.5, 1.0), Problem::position_limits_are_beyond_1000_rad);
  EXPECT_EQ(between(-1.0, 1000.5), Problem::position_limits_are_beyond_1000_rad);
  EXPECT_EQ(between(-100, 100, JointType::prismatic), Problem::none);
  EXPECT_EQ(between(-100.5, 1, JointType::prismatic), Problem::position_limits_are_beyond_100_m);
  EXPECT_EQ(between(-1, 100.5, JointType::prismatic), Problem::position_limits_are_beyond_100_m);
  EXPECT_EQ(between(-inf, inf, JointType::prismatic), Problem::none);
  expect_between(&LinkParameters::speed_limit, 1e-300, 0.0, Problem::speed_limit_is_not_positive);
  expect_between(&LinkParameters::acceleration_limit, 1e-300, 0.0, Problem::acceleration_limit_is_not_positive);
  expect_between(&LinkParameters::effort_limit, 1e-300, 0.0, Problem::effort_limit_is_not_positive);
}

TEST(DescriptionChecks, DegreesAreSeen) {
  using detail::looks_like_degrees;
  for (const auto& [low, high] : {std::pair{-90.0, 90.0}, {0.0, 90.0}, {-90.0, 1.0}, {-180.0, 180.0}, {-399.0, 0.0}})
    EXPECT_TRUE(looks_like_degrees(low, high)) << low << ' ' << high;
  for (const auto& [low, high] : {std::pair{-89.0, 89.0}, {-90.5, 90.0}, {-90.0, 89.5}, {-401.0, 1.0}, {-100.0, 100.0}})
    EXPECT_FALSE(looks_like_degrees(low, high)) << low << ' ' << high;
  EXPECT_EQ(after([](auto& p) { p.position_min = -180, p.position_max = 180; }),
            Problem::position_limits_look_like_degrees);
}

TEST(DescriptionChecks, BodiesAreMadeOfMatter) {
  expect_between(&LinkParameters::mass, 1.0, -1e-300, Problem::mass_is_negative);
  EXPECT_EQ(after([](auto& p) { p.mass = 0.0; }), Problem::inertia_without_mass);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(after([&](auto& p) { p.inertia_com[k] = inf; }), Problem::mass_com_or_inertia_is_not_finite) << k;
    const Problem lone = after([&](auto& p) {
      p.mass = 0.0;
      for (int i = 0; i < 6; ++i)
        p.inertia_com[i] = i == k ? 0.1 : 0.0;
    });
    EXPECT_EQ(lone, Problem::inertia_without_mass) << k;
  }
  const auto largest = [](double moment) { return after([&](auto& p) { p.inertia_com[2] = moment; }); };
  EXPECT_EQ(largest(2.0 * 1.0499), Problem::none) << "what published tensors miss by";
  EXPECT_EQ(largest(2.0 * 1.0501), Problem::inertia_breaks_the_triangle_inequality);
  const auto least = [](double moment) {
    return after([&](auto& p) { p.inertia_com[0] = moment, p.inertia_com[1] = p.inertia_com[2] = 1.0; });
  };
  EXPECT_EQ(least(-0.0499), Problem::none);
  EXPECT_EQ(least(-0.0501), Problem::inertia_is_not_positive_definite);
}

TEST(DescriptionChecks, ACentreOfMassNeedsAMass) {
  for (int k = 0; k < 3; ++k) {
    LinkParameters p;
    p.com[k] = 0.1;
    EXPECT_EQ(detail::link_problem(p, {}, 0, false), Problem::com_without_mass) << k;
  }
  EXPECT_EQ(detail::link_problem({}, {}, 0, false), Problem::none) << "nothing at all is a massless link";
}

TEST(DescriptionChecks, WaterTakesEnergyOut) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(after([&](auto& p) { p.water.added_mass[k] = -1; }), Problem::added_mass_is_negative_or_not_finite);
    EXPECT_EQ(after([&](auto& p) { p.water.added_inertia[k] = no_number; }),
              Problem::added_mass_is_negative_or_not_finite);
    EXPECT_EQ(after([&](auto& p) { p.water.centre[k] = inf; }), Problem::buoyancy_is_negative_or_not_finite);
  }
  EXPECT_EQ(after([](auto& p) { p.water.displaced_mass = -1; }), Problem::buoyancy_is_negative_or_not_finite);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(after([&](auto& p) { p.water.drag_linear[k] = -1; }), Problem::drag_is_negative_or_not_finite);
    EXPECT_EQ(after([&](auto& p) { p.water.drag_quadratic[k] = inf; }), Problem::drag_is_negative_or_not_finite);
  }
}

TEST(DescriptionChecks, WhatIsAcceptedMayBeDoubtfulButMustMeanSomething) {
  const auto accepted = [](const Change& change) { return after(change, JointType::revolute, true); };
  EXPECT_EQ(accepted([](auto& p) { p.a = 300; }), Problem::none);
  EXPECT_EQ(accepted([](auto& p) { p.mass = 0; }), Problem::none);
  EXPECT_EQ(accepted([](auto& p) { p.mass = -1; }), Problem::mass_is_negative);
  EXPECT_EQ(accepted([](auto& p) { p.speed_limit = 0; }), Problem::speed_limit_is_not_positive);
}

// Pseudo-inertias S = tr(J)/2 - J that one condition alone excludes: J = tr(S) - S.
TEST(PhysicallyConsistent, IsAQuestionOfEveryMinor) {
  EXPECT_FALSE(body(0, 1, 1.1, 0, 0, 0)) << "xx, yy or zz of S";
  EXPECT_FALSE(body(1.1, 0, 1, 0, 0, 0));
  EXPECT_FALSE(body(1, 1.1, 0, 0, 0, 0));
  EXPECT_FALSE(body(1, 1, 2, -2, 0, 0, 1.0, 0.0)) << "S is 1 2 0; 2 1 0; 0 0 0: its determinant is 0";
  EXPECT_FALSE(body(1, 2, 1, 0, -2, 0, 1.0, 0.0));
  EXPECT_FALSE(body(2, 1, 1, 0, 0, -2, 1.0, 0.0));
  // S = 1 - 1.1 v v^T with v along (1, 1, 1), and along it with other signs: every minor is positive.
  const double d = 1.0 - 1.1 / 3.0, off = 1.1 / 3.0, moment = 2.0 * d;
  EXPECT_FALSE(body(moment, moment, moment, off, off, off));
  EXPECT_FALSE(body(moment, moment, moment, -off, -off, off));
  EXPECT_FALSE(body(moment, moment, moment, -off, off, -off));
  EXPECT_FALSE(body(moment, moment, moment, off, -off, -off));
  EXPECT_TRUE(body(moment, moment, moment, -off, -off, -off)) << "S = (1 - 2 off) + off: a body";
}

TEST(PhysicallyConsistent, HasATolerance) {
  EXPECT_TRUE(body(1, 1, 2, 0, 0, 0)) << "a plate";
  EXPECT_TRUE(body(1, 1, 2.01, 0, 0, 0, 1.0, 0.01));
  EXPECT_FALSE(body(1, 1, 2.01, 0, 0, 0, 1.0, 0.001));
}

TEST(PhysicallyConsistent, NeedsMassWhereThereIsInertia) {
  EXPECT_TRUE(body(0, 0, 0, 0, 0, 0, 0.0));
  EXPECT_FALSE(body(0, 0, 0, 0, 0, 0, -1.0));
  EXPECT_FALSE(body(-1, -1, -1, 0, 0, 0));
  for (int k = 0; k < 6; ++k) {
    double j[6] = {};
    j[k] = 1.0;
    EXPECT_FALSE(physically_consistent(j, 0.0)) << k;
  }
}
