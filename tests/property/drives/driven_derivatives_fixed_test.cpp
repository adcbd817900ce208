// Derivatives of inverse dynamics of joints that share drives in fixed point: nothing overflows and no certified error
// is exceeded, at corners of both kinds of limits and where searches climb; against differences of Lagrange's equations
// of all joints with a multiplier each in 113 bits.
#include <gtest/gtest.h>
#include <robots/robots.hpp>

#include "driven_robots.hpp"
#include "driven_slopes.hpp"
#include "driven_states.hpp"

namespace {

using namespace axial;
using constrained::quad;
using constrained::Vector;
using property::real;

template <class R, class T, class... Features>
class DrivenSlopes {
 public:
  using Checked = Scene<R, Gravity, RotorInertia, RangeCheck, Features...>;
  using Exact = std::conditional_t<Checked::template has<Friction>, Scene<R, Gravity, RotorInertia, Friction>,
                                   Scene<R, Gravity, RotorInertia>>;
  using State = exhaustive::FixedState<Checked, T>;
  using Values = Joints<R, double>;
  static constexpr int drives = joint_count<R>;
  static constexpr auto bound = error_bound<Checked, T>(algorithm::inverse_dynamics_derivatives);

  enum Part { efforts, mass, by_position, by_velocity, parts };
  static constexpr const char* names[parts] = {"efforts", "M", "d tau / d u", "d tau / d ud"};
  double nearest[parts] = {}, share[parts] = {};
  std::uint64_t overflows = 0;

  auto asked(const State& state) {
    const std::uint64_t before = range_overflows;
    const auto got = inverse_dynamics_derivatives<Checked>(state.q, state.qd, state.qdd);
    overflows += range_overflows - before;
    return got;
  }
  /// One state against double.
  void see(State state) {
    property::hold_joints<R>(state);
    Values u{}, ud{}, udd{};
    for (int k = 0; k < drives; ++k)
      u[k] = real(state.q, k), ud[k] = real(state.qd, k), udd[k] = real(state.qdd, k);
    const auto got = asked(state);
    const auto exact = inverse_dynamics_derivatives<Exact>(u, ud, udd);
    for (double& own : share)
      own = 0.0;
    for (int k = 0; k < drives; ++k)
      see(efforts, real(got.tau, k) - exact.tau[k], bound.tau[k]);
    see_matrices(
        got, [&](int k, int l) { return exact.M(k, l); }, [&](int k, int l) { return exact.dtau_dq(k, l); },
        [&](int k, int l) { return exact.dtau_dqd(k, l); });
  }
  /// Words of matrices against what functions of their indices say.
  template <class Got, class M, class ByPosition, class ByVelocity>
  void see_matrices(const Got& got, const M& m, const ByPosition& dq, const ByVelocity& dqd) {
    const auto word = [](const auto& matrix, int k, int l) {
      return matrix(k, l).raw * detail::power_of_two(-matrix.exponent(k, l));
    };
    for (int k = 0; k < drives; ++k)
      for (int l = 0; l < drives; ++l) {
        see(mass, word(got.M, k, l) - m(k, l), bound.M(k, l));
        see(by_position, word(got.dtau_dq, k, l) - dq(k, l), bound.dtau_dq(k, l));
        see(by_velocity, word(got.dtau_dqd, k, l) - dqd(k, l), bound.dtau_dqd(k, l));
      }
  }

 private:
  void see(Part part, double off, double most) {
    constexpr double doubles = 1e-11;  // what differences of doubles leave
    const double own = most > 0.0 ? std::fabs(off) / (most + 1e-13) : std::fabs(off) > doubles ? HUGE_VAL : 0.0;
    share[part] = std::fmax(share[part], own), nearest[part] = std::fmax(nearest[part], own);
  }
};

template <class R, class T, class... Features>
void expect_inside(double least) {
  DrivenSlopes<R, T, Features...> robot;
  using State = typename DrivenSlopes<R, T, Features...>::State;
  property::search_bounds<State>(R::name, robot, property::states_asked(2000), 9, 50);
  for (int part = 0; part < robot.parts; ++part)
    EXPECT_GT(robot.nearest[part], least)
        << R::name << " " << robot.names[part] << ": a bound as loose as this says little";
}

/// Two bodies on one axis: nothing but friction has a slope, which no word holds.
struct Spindles {
  static constexpr const char* name = "spindles";
  static constexpr auto spindle = revolute()
                                      .mass(1)
                                      .com(0, 0, 0.1)
                                      .inertia_com(0.01, 0.01, 0.01)
                                      .rotor_inertia(1e-4, 10)
                                      .viscous(1000.1)
                                      .drive_limits(-3, 3, 2, 10);
  static constexpr auto chain = axial::chain(gravity(0, 0, -9.81), spindle, spindle.driven_by(0, -1.0));
};

/// Differences of the multipliers' efforts.
template <class R, class... Features>
[[maybe_unused]] void expect_multipliers(unsigned seed) {
  DrivenSlopes<R, Fixed32, Features...> robot;
  using State = typename DrivenSlopes<R, Fixed32, Features...>::State;
  const auto exact = constrained::Constrained::of<R>();
  exhaustive::Random random(seed);
  for (int round = 0; round < 12; ++round) {
    auto state = exhaustive::next_state<State>(random, static_cast<std::uint64_t>(round % 4));
    property::hold_joints<R>(state);
    Vector<quad> u, ud, udd;
    for (int i = 0; i < joint_count<R>; ++i)
      u.push_back(real(state.q, i)), ud.push_back(real(state.qd, i)), udd.push_back(real(state.qdd, i));
    const auto m = exact.mass(u);
    const auto dq = constrained::slopes(u, [&](const auto& x) { return exact.inverse(x, ud, udd); });
    const auto dqd = constrained::slopes(ud, [&](const auto& x) { return exact.inverse(u, x, udd); });
    robot.see_matrices(
        robot.asked(state), [&](int k, int l) { return double(m(k, l)); },
        [&](int k, int l) { return double(dq(k, l)); }, [&](int k, int l) { return double(dqd(k, l)); });
  }
  for (int part = robot.mass; part < robot.parts; ++part)
    EXPECT_LE(robot.nearest[part], 1.0) << R::name << " " << robot.names[part];
  EXPECT_GT(robot.nearest[robot.by_position], 0.01) << R::name;
  EXPECT_EQ(robot.overflows, 0U) << R::name;
}

}  // namespace

TEST(DerivativesOfDrivesInFixedPoint, StayInsideTheirBounds) {
  expect_inside<robots::Palletiser, Fixed32, Friction>(0.02);
  expect_inside<robots::ScaraQuill, Fixed32, Friction>(0.02);
}
#ifndef AXIAL_FEW_ROBOTS
TEST(DerivativesOfDrivesInFixedPoint, OfAGripperAndAWristStayInsideTheirBounds) {
  expect_inside<robots::Gripper, Fixed32, Friction>(0.02);
  expect_inside<robots::WristArm, Fixed32, Friction>(0.02);
}
TEST(DerivativesOfDrivesInFixedPoint, StayInsideThemWithRandomCouplingsAndOtherRounding) {
  expect_inside<property::Followers, Fixed32, Friction>(0.01);
  expect_inside<property::Followers, Fixed32, HighWord>(0.01);
}
TEST(DerivativesOfDrivesInFixedPoint, StayInsideThemWhereSumsAreRoundedDownToo) {
  expect_inside<property::Coupled<0>, Fixed32, RoundDown, Friction>(0.01);
  expect_inside<property::Coupled<1>, Fixed32>(0.01);
  expect_inside<property::Coupled<2>, Fixed32, Friction>(0.01);
  expect_inside<robots::Gripper, Fixed16>(0.02);
}
// By one step for all joints.
TEST(DerivativesOfDrivesInFixedPoint, LoopedStayInsideTheirBounds) {
  expect_inside<robots::WristArm, Fixed32, Friction, Looped>(0.001);
  expect_inside<property::Followers, Fixed32, Looped, HighWord>(0.001);
  expect_inside<robots::Gripper, Fixed32, Looped>(0.001);
}
TEST(DerivativesOfDrivesInFixedPoint, AreSlopesOfConstraintsWithMultipliers) {
  expect_multipliers<robots::WristArm>(1);
  expect_multipliers<robots::ScaraQuill>(2);
  expect_multipliers<robots::Palletiser>(3);
  expect_multipliers<robots::Gripper>(4);
}
#endif
TEST(DerivativesOfDrivesInFixedPoint, KnowTheRoundingOfFrictionAlone) {
  using Robot = DrivenSlopes<Spindles, Fixed32, Friction>;
  Robot robot;
  robot.see(typename Robot::State{});
  EXPECT_LE(robot.nearest[robot.by_velocity], 1.0);
  EXPECT_GT(robot.nearest[robot.by_velocity], 0.1);
}
// What is asked for alone has the same bits; efforts are those of inverse dynamics.
TEST(DerivativesOfDrivesInFixedPoint, StandAlone) {
  using R = robots::Gripper;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  using T = Fixed32;
  const auto u = to_fixed<Positions<R, T>>(Joints<R, double>{0.4, 0.01}).values;
  const auto ud = to_fixed<Velocities<R, T>>(Joints<R, double>{1.0, -0.05}).values;
  const auto udd = to_fixed<Accelerations<R, T>>(Joints<R, double>{-2.0, 0.5}).values;
  const auto all = inverse_dynamics_derivatives<S>(u, ud, udd);
  const auto alone = inverse_dynamics_derivatives<S, with_velocity_jacobian>(u, ud, udd);
  static_assert(sizeof alone == 4 * sizeof(T));
  const auto tau = inverse_dynamics<S>(u, ud, udd);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(all.tau[k].raw, tau[k].raw);
    for (int l = 0; l < 2; ++l)
      EXPECT_EQ(all.dtau_dqd(k, l).raw, alone.dtau_dqd(k, l).raw);
  }
  EXPECT_NE(all.dtau_dqd(0, 0).raw, 0);
}
