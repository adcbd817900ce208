// Forward dynamics of joints that share drives in fixed point: inside the error that is certified beforehand and inside
// the one of each answer, without an overflow, at corners, beyond declared efforts and where searches climb; against
// Lagrange's equations of all joints with a multiplier each.
#include <gtest/gtest.h>
#include <cstdlib>
#include <robots/robots.hpp>

#include "constrained.hpp"
#include "driven_robots.hpp"
#include "driven_states.hpp"

namespace {

using namespace axial;
using property::real;
using T = Fixed32;

int states_asked() {
  const char* asked = std::getenv("AXIAL_UNTUNED_STATES");
  return asked != nullptr ? std::atoi(asked) : 2000;
}

template <class R, class... Features>
class DrivenForward {
 public:
  using Checked = Scene<R, Gravity, RangeCheck, Features...>;
  using Exact = Scene<R, Gravity, CompositeBody, Features...>;
  using State = exhaustive::FixedState<Checked, T>;
  using Values = Joints<R, double>;
  static constexpr int drives = joint_count<R>;
  static constexpr auto bound = error_bound<Checked, T>(algorithm::forward_dynamics);

  double nearest = 0.0, nearest_certified = 0.0, least_exact = 0.0, share = 0.0, widest = 0.0;
  int seen = 0, flagged = 0, uncertain = 0;
  std::uint64_t overflows = 0;

  /// One state; inside what is declared unless `beyond`.
  void see(State state, bool beyond) {
    property::hold_joints<R>(state, true);
    Values u{}, ud{}, tau{};
    for (int k = 0; k < drives; ++k)
      u[k] = real(state.q, k), ud[k] = real(state.qd, k), tau[k] = real(state.tau, k);
    const std::uint64_t before = range_overflows;
    const auto plain = forward_dynamics<Checked>(state.q, state.qd, state.tau);
    const auto answer = certified_forward_dynamics<Checked, T>(state.q, state.qd, state.tau);
    overflows += range_overflows - before;
    const auto exact = forward_dynamics<Exact>(u, ud, tau);
    share = 0.0;
    see_certificate(answer, exact);
    const auto code = plain.status.code;
    if (code == Status::Code::position_limit || code == Status::Code::speed_limit) return;
    if (beyond) return;
    ++seen, flagged += !plain.status.ok(), uncertain += !answer.status.ok();
    for (int k = 0; k < drives; ++k) {
      const double off = std::fabs(real(plain, k) - exact[k]);
      if (code != Status::Code::saturated) share = std::fmax(share, off / bound[k]);
      if (plain.status.ok()) least_exact = std::fmax(least_exact, off / limit(k));
      widest = std::fmax(widest, std::fabs(exact[k]) / limit(k));
    }
    nearest = std::fmax(nearest, share);
  }
  static double limit(int k) { return DriveCoordinates<R>::chain.links[k].acceleration_limit; }

 private:
  template <class Answer, class Values>
  void see_certificate(const Answer& answer, const Values& exact) {
    for (int k = 0; k < drives; ++k) {
      if (answer.bound[k].raw == INT32_MAX) continue;
      const double own = std::fabs(real(answer, k) - exact[k]) / real(answer.bound, k);
      nearest_certified = std::fmax(nearest_certified, own);
    }
  }
};

template <class R, class... Features>
void expect_inside() {
  DrivenForward<R, Features...> robot;
  using State = typename DrivenForward<R, Features...>::State;
  const int states = states_asked();
  exhaustive::Random random(11);
  for (int k = 0; k < states; ++k) {
    const bool beyond = k % 8 == 7;  // efforts as large as words hold them
    robot.see(exhaustive::next_state<State>(random, static_cast<std::uint64_t>(k)), beyond);
  }
  for (unsigned start = 0; start < 3; ++start)
    exhaustive::climb<State>(20 + start, states / 8, 4 * State::size, [&](const State& state) {
      robot.see(state, false);
      return robot.share;
    });
  std::printf(
      "%s: %d states inside; nearest to the bound %.2g, to an answer's own %.2f; worst %.2g of the declared "
      "acceleration, answers up to %.0f times that; %d flagged, %d not certified\n",
      R::name, robot.seen, robot.nearest, robot.nearest_certified, robot.least_exact, robot.widest, robot.flagged,
      robot.uncertain);
  EXPECT_EQ(robot.overflows, 0U) << R::name;
  EXPECT_LE(robot.nearest, 1.0) << R::name;
  EXPECT_LE(robot.nearest_certified, 1.0) << R::name;
  EXPECT_GT(robot.nearest_certified, 0.05) << R::name << ": a bound of an answer is of its error's size";
  EXPECT_LE(robot.least_exact, 1e-3) << R::name;
  EXPECT_GT(robot.seen, states / 4) << R::name;
  EXPECT_LE(50 * robot.flagged, robot.seen) << R::name;
  EXPECT_LE(50 * robot.uncertain, robot.seen) << R::name;
}

/// Multipliers in 113 bits; the certificate's bound alone is what may lie between.
template <class R>
void expect_multipliers(unsigned seed) {
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  using State = exhaustive::FixedState<S, T>;
  oracle::Load<constrained::quad> load;
  load.friction = true;
  const auto exact = constrained::Constrained::of<R>(load);
  exhaustive::Random random(seed);
  int known = 0;
  for (int k = 0; k < 40; ++k) {
    auto state = exhaustive::next_state<State>(random, static_cast<std::uint64_t>(k % 4));
    property::hold_joints<R>(state);
    constrained::Vector<constrained::quad> u, ud, tau;
    for (int i = 0; i < joint_count<R>; ++i)
      u.push_back(real(state.q, i)), ud.push_back(real(state.qd, i)), tau.push_back(real(state.tau, i));
    const auto answer = certified_forward_dynamics<S, T>(state.q, state.qd, state.tau);
    const auto wanted = exact.forward(u, ud, tau);
    known += answer.status.ok();
    for (int i = 0; i < joint_count<R>; ++i) {
      if (answer.bound[i].raw == INT32_MAX) continue;
      EXPECT_LE(std::fabs(real(answer, i) - static_cast<double>(wanted[std::size_t(i)])), real(answer.bound, i))
          << R::name << " " << k;
    }
  }
  EXPECT_GT(known, 0) << R::name;
}

}  // namespace

TEST(ForwardDynamicsOfDrives, StaysInsideBothBounds) {
  expect_inside<robots::WristArm, RotorInertia, Friction>();
  expect_inside<robots::ScaraQuill, RotorInertia, Friction>();
  expect_inside<robots::Palletiser, RotorInertia, Friction>();
  expect_inside<robots::Gripper, RotorInertia, Friction>();
  expect_inside<property::Followers, RotorInertia, Friction>();
}
// By one step for all joints.
TEST(ForwardDynamicsOfDrives, LoopedStaysInsideBothBounds) {
  expect_inside<robots::WristArm, RotorInertia, Friction, Looped>();
  expect_inside<robots::Gripper, RotorInertia, Friction, Looped>();
  expect_inside<property::Followers, RotorInertia, Friction, Looped>();
#ifdef AXIAL_EVERY_UNTUNED
  expect_inside<robots::ScaraQuill, RotorInertia, Friction, Looped>();
  expect_inside<robots::Palletiser, RotorInertia, Friction, Looped>();
  expect_inside<property::Coupled<3>, RotorInertia, Friction, Looped>();
#endif
}
TEST(ForwardDynamicsOfDrives, StaysInsideThemWithoutRotorsAndWithRandomCouplings) {
  expect_inside<robots::Gripper>();
  expect_inside<property::Coupled<0>, RotorInertia, Friction>();
  expect_inside<property::Coupled<1>, RotorInertia>();
#ifdef AXIAL_EVERY_UNTUNED
  expect_inside<robots::ScaraQuill>();
  expect_inside<robots::Palletiser>();
  expect_inside<property::Coupled<2>, RotorInertia, Friction>();
  expect_inside<property::Coupled<3>, RotorInertia, Friction>();
  expect_inside<property::Coupled<7>, RotorInertia, Friction>();
  expect_inside<property::Coupled<5>, RotorInertia, Friction>();
#endif
}
TEST(ForwardDynamicsOfDrives, IsConstraintsWithMultipliers) {
  expect_multipliers<robots::WristArm>(1);
  expect_multipliers<robots::ScaraQuill>(2);
  expect_multipliers<robots::Palletiser>(3);
  expect_multipliers<robots::Gripper>(4);
}
