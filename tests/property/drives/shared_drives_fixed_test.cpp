// Joints that share drives in fixed point: nothing overflows and no certified error is exceeded, at corners of the
// drives' limits and of the joints', and where searches climb; power on either side.
#include <gtest/gtest.h>
#include <cstdlib>
#include <robots/robots.hpp>

#include "driven_robots.hpp"
#include "driven_states.hpp"

namespace {

using namespace axial;
using property::Followers;
using property::hold_joints;
using property::real;

std::uint64_t states_asked() {
  const char* asked = std::getenv("AXIAL_UNTUNED_STATES");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : 2000;
}

template <class R, class T, class... Features>
class SharedKernels {
 public:
  using Checked = Scene<R, Gravity, RotorInertia, Friction, RangeCheck, Features...>;
  using Exact = Scene<R, Gravity, RotorInertia, Friction>;
  using State = exhaustive::FixedState<Checked, T>;
  using Values = Joints<R, double>;
  static constexpr int drives = joint_count<R>, joints = link_count<R>;

  enum Kernel { inverse, bias, gravity, mass, poses, columns, momenta, drifts, power, kernels };
  static constexpr const char* names[kernels] = {"inverse dynamics", "bias",    "gravity", "mass matrix", "poses",
                                                 "Jacobian",         "momenta", "drifts",  "power"};
  double nearest[kernels] = {}, share[drives] = {}, nearest_of_drive[drives] = {};
  std::uint64_t overflows[kernels] = {};

  /// Every kernel at one state.
  void see(State state) {
    hold_joints<R>(state);
    Values u{}, ud{}, udd{};
    for (int k = 0; k < drives; ++k)
      u[k] = real(state.q, k), ud[k] = real(state.qd, k), udd[k] = real(state.qdd, k);
    see_efforts(state, u, ud, udd);
    see_structure(state, u);
    const auto got = run(momenta, [&] { return momentum_terms<Checked>(state.q, state.qd); });
    const auto exact = momentum_terms<Exact>(u, ud);
    constexpr auto p = error_bound<Checked, T>(algorithm::Momentum{}),
                   d = error_bound<Checked, T>(algorithm::MomentumDrift{});
    see_drives(momenta, got.momentum, exact.momentum, p), see_drives(drifts, got.drift, exact.drift, d);
  }

 private:
  void see(Kernel kernel, double error, double bound, double size) {
    const double share = bound > 0.0 ? error / bound : error > 1e-12 * size ? HUGE_VAL : 0.0;
    nearest[kernel] = std::fmax(nearest[kernel], share);
  }
  template <class Run>
  auto run(Kernel kernel, const Run& run) {
    const std::uint64_t before = range_overflows;
    const auto result = run();
    overflows[kernel] += range_overflows - before;
    return result;
  }
  template <class Got, class Bound>
  void see_drives(Kernel kernel, const Got& got, const Values& exact, const Bound& bound) {
    for (int k = 0; k < drives; ++k)
      see(kernel, std::fabs(real(got, k) - exact[k]), bound[k], 1.0);
  }
  void see_efforts(const State& state, const Values& u, const Values& ud, const Values& udd) {
    constexpr auto bound = error_bound<Checked, T>(algorithm::inverse_dynamics);
    const auto got = run(inverse, [&] { return inverse_dynamics<Checked>(state.q, state.qd, state.qdd); });
    const auto exact = inverse_dynamics<Exact>(u, ud, udd);
    see_drives(inverse, got, exact, bound);
    see_drives(bias, run(bias, [&] { return bias_torque<Checked>(state.q, state.qd); }), bias_torque<Exact>(u, ud),
               error_bound<Checked, T>(algorithm::bias));
    see_drives(gravity, run(gravity, [&] { return gravity_torque<Checked>(state.q); }), gravity_torque<Exact>(u),
               error_bound<Checked, T>(algorithm::gravity));
    for (int k = 0; k < drives; ++k) {
      share[k] = std::fabs(real(got, k) - exact[k]) / bound[k];
      nearest_of_drive[k] = std::fmax(nearest_of_drive[k], share[k]);
    }
    see_power(got, u, ud, udd, bound);
  }
  /// ud . tau_u of words without rotors and friction is qd . tau_q of the joints.
  template <class Got, class Bound>
  void see_power(const Got& got, const Values& u, const Values& ud, const Values& udd, const Bound& bound) {
    const auto qd = joint_rates<R>(ud);
    const auto tau =
        inverse_dynamics<Scene<JointCoordinates<R>, Gravity>>(joint_positions<R>(u), qd, joint_rates<R>(udd));
    double of_joints = 0.0, of_drives = 0.0, allowed = 0.0;
    for (int i = 0; i < joints; ++i)
      of_joints += qd[i] * tau[i];
    for (int k = 0; k < drives; ++k) {
      const auto& drive = scene_of<R>::Robot::chain.links[k];
      const double coulomb = ud[k] > 0.0 ? drive.coulomb_forward : ud[k] < 0.0 ? drive.coulomb_backward : 0.0;
      const double own = drive.gear * drive.gear * drive.rotor_inertia * udd[k] + drive.viscous * ud[k] + coulomb;
      of_drives += ud[k] * (real(got, k) - own), allowed += std::fabs(ud[k]) * bound[k];
    }
    see(power, std::fabs(of_joints - of_drives), allowed + 1e-12, 1.0);
  }
  void see_structure(const State& state, const Values& u) {
    constexpr auto bound = error_bound<Checked, T>(algorithm::mass_matrix);
    const auto got = run(mass, [&] { return mass_matrix<Checked>(state.q); });
    const auto exact = mass_matrix<Exact>(u);
    for (int i = 0; i < drives; ++i)
      for (int j = 0; j <= i; ++j)
        see(mass, std::fabs(got(i, j).raw * detail::power_of_two(-got.exponent(i, j)) - exact(i, j)), bound[i], 1.0);
    constexpr double length = detail::power_of_two(-length_exponent<Checked, T>);
    constexpr double column = detail::power_of_two(column_headroom<Checked> - length_exponent<Checked, T>);
    const auto far = [](const auto& a, const auto& b, double unit) {
      return std::sqrt(std::pow(a.x.raw * unit - b.x, 2) + std::pow(a.y.raw * unit - b.y, 2) +
                       std::pow(a.z.raw * unit - b.z, 2));
    };
    const auto frames = run(poses, [&] { return forward_kinematics<Checked>(state.q); });
    const auto exact_frames = forward_kinematics<Exact>(u);
    for (int i = 0; i < joints; ++i)
      see(poses, far(frames.frames[i].position, exact_frames.frames[i].position, length),
          error_bound<Checked, T>(algorithm::forward_kinematics)[i], 1.0);
    const auto of_tool = run(columns, [&] { return jacobian<Checked>(state.q); });
    const auto exact_columns = jacobian<Exact>(u);
    for (int k = 0; k < drives; ++k)
      see(columns, far(of_tool[k].linear, exact_columns[k].linear, column),
          error_bound<Checked, T>(algorithm::jacobian)[k], 1.0);
  }
};

template <class R, class T, class... Features>
void expect_kernels_inside_their_bounds(double looseness) {
  SharedKernels<R, T, Features...> robot;
  using State = typename SharedKernels<R, T, Features...>::State;
  const std::uint64_t states = states_asked(), seed = 5;
  exhaustive::Random random(seed);
  for (std::uint64_t k = 0; k < states; ++k)
    robot.see(exhaustive::next_state<State>(random, k % 4));
  for (int k = 0; k < State::size; ++k)
    exhaustive::climb<State>(seed + static_cast<std::uint64_t>(k), static_cast<int>(states / 10), 3 * State::size,
                             [&](const State& state) {
                               robot.see(state);
                               return robot.share[k];
                             });
  std::printf("%s, %d bits: %llu states;", R::name, 8 * static_cast<int>(sizeof(typename T::Word)),
              static_cast<unsigned long long>(states));
  for (int kernel = 0; kernel < robot.kernels; ++kernel) {
    std::printf(" %s %.2f", robot.names[kernel], robot.nearest[kernel]);
    EXPECT_LE(robot.nearest[kernel], 1.0) << robot.names[kernel];
    EXPECT_EQ(robot.overflows[kernel], 0U) << robot.names[kernel];
  }
  double loosest = 0.0;
  for (const double share : robot.nearest_of_drive)
    loosest = std::fmax(loosest, 1.0 / share);
  std::printf("; an effort's bound is at most %.1f times what was found\n", loosest);
  EXPECT_LE(loosest, looseness);
}

}  // namespace

TEST(SharedDrivesInFixedPoint, StayInsideTheirBounds) {
  expect_kernels_inside_their_bounds<robots::WristArm, Fixed32>(50.0);
  expect_kernels_inside_their_bounds<robots::ScaraQuill, Fixed32>(50.0);
  expect_kernels_inside_their_bounds<Followers, Fixed32>(50.0);
#ifdef AXIAL_EVERY_UNTUNED
  expect_kernels_inside_their_bounds<robots::Palletiser, Fixed32>(50.0);
  expect_kernels_inside_their_bounds<robots::Gripper, Fixed32>(50.0);
  expect_kernels_inside_their_bounds<robots::Gripper, Fixed16>(50.0);
#endif
}
// By one step for all joints.
TEST(SharedDrivesInFixedPoint, LoopedStayInsideTheirBounds) {
  expect_kernels_inside_their_bounds<robots::WristArm, Fixed32, Looped>(100.0);
  expect_kernels_inside_their_bounds<Followers, Fixed32, Looped, HighWord>(100.0);
#ifdef AXIAL_EVERY_UNTUNED
  expect_kernels_inside_their_bounds<robots::ScaraQuill, Fixed32, Looped>(100.0);
  expect_kernels_inside_their_bounds<Followers, Fixed32, Looped, RoundDown>(100.0);
  expect_kernels_inside_their_bounds<robots::Palletiser, Fixed32, Looped>(100.0);
  expect_kernels_inside_their_bounds<robots::Gripper, Fixed32, Looped>(100.0);
  expect_kernels_inside_their_bounds<robots::Gripper, Fixed16, Looped>(100.0);
#endif
}
TEST(SharedDrivesInFixedPoint, CountTurnsOfDrivesThatPassOne) {
  using R = robots::WristArm;
  using T = Fixed32;
  // The wrist's drives reach 8 rad together, at which its pitch stands a turn and 1.7 rad: no place inside +-1.9.
  const auto at = [](double a, double b) {
    return to_fixed<Positions<R, T>>(Joints<R, double>{0.1, 0.5, 0.2, a, b}).values;
  };
  EXPECT_TRUE(check_position<R>(at(7.5, -7.5)).ok() == false) << "the roll at 7.5 of 6";
  EXPECT_TRUE(check_position<R>(at(5.5, -5.5)).ok());
  EXPECT_EQ(check_position<R>(at(7.9, 7.9)).code, Status::Code::position_limit);
  EXPECT_EQ(check_position<R>(at(7.9, 7.9)).joint, 3);
  EXPECT_EQ(check_request<R>(at(7.9, 7.9), Velocities<R, T>{}, Accelerations<R, T>{}).code,
            Status::Code::position_limit);
  EXPECT_TRUE(check_position<R>(at(1.9, 1.9)).ok()) << "the limit is inside";
  EXPECT_FALSE(check_position<R>(at(1.9001, 1.9)).ok());
  const auto speeds = to_fixed<Velocities<R, T>>(Joints<R, double>{0, 0, 0, 11.0, 11.0}).values;
  EXPECT_EQ((check_request<R>(at(0, 0), speeds, Accelerations<R, T>{})).code, Status::Code::speed_limit);
  EXPECT_EQ(momentum_terms<R>(at(0, 0), speeds).status.code, Status::Code::speed_limit);
  using Q = robots::ScaraQuill;
  const auto quill = to_fixed<Positions<Q, T>>(Joints<Q, double>{0, 0, 69.0, 0.0}).values;  // 0.2196 m of 0.2
  EXPECT_EQ(forward_kinematics<Q>(quill).status.code, Status::Code::position_limit);
  EXPECT_EQ(forward_kinematics<Q>(quill).status.joint, 2);
}
TEST(SharedDrivesInFixedPoint, FeedForwardAndTrackingTakeWordsOfDrives) {
  using R = robots::WristArm;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  using T = Fixed32;
  const Joints<R, double> u{0.1, 0.5, 0.2, 1.0, -0.5}, ud{0.5, -0.5, 0.3, 2.0, 1.0}, udd{1, 2, -1, 5, -5};
  const auto wanted = to_fixed_request<S, std::int32_t>(u, ud, udd);
  ASSERT_TRUE(wanted.status.ok());
  FeedforwardState<S, T> state;
  const auto fed = feedforward(state, wanted.q, wanted.qd, wanted.qdd);
  EXPECT_TRUE(fed.status.ok());
  const auto exact = inverse_dynamics<S>(u, ud, udd);
  constexpr auto bound = error_bound<S, T>(algorithm::RequestedTorque{});
  for (int k = 0; k < joint_count<R>; ++k)
    EXPECT_NEAR(to_real<double>(fed.tau)[k], exact[k], bound[k]) << k;
  TrackingGains<S, double> gains;
  for (int k = 0; k < joint_count<R>; ++k)
    gains.stiffness[k] = 10.0;
  SafeLoopState<S, T> loop;
  auto off = u;
  off[4] -= 0.01;
  const auto measured = to_fixed_request<S, std::int32_t>(off, ud, udd);
  const auto followed = track(loop, wanted, MeasuredMotion<S, T>{measured.q, measured.qd, {}},
                              to_fixed_gains<S, std::int32_t>(gains).gains);
  EXPECT_TRUE(followed.status.ok());
  EXPECT_NEAR(to_real<double>(followed.tau)[4], exact[4] + 0.1, bound[4] + 1e-6);
}
struct Tuning {
  static constexpr double period = 1e-3, gain = 50.0;
};
TEST(SharedDrivesInFixedPoint, ObserversSeeWhatPushesADrive) {
  using R = robots::WristArm;
  using S = Scene<R, Gravity, RotorInertia>;
  using T = Fixed32;
  const Joints<R, double> u{0.1, 0.5, 0.2, 1.0, -0.5};
  auto tau = gravity_torque<S>(u);
  tau[3] -= 0.5;
  const auto at = to_fixed<Positions<R, T>>(u).values;
  const auto applied = to_fixed<EffortsOf<S, T>>(tau).values;
  ObserverState<S, T, Tuning> state;
  for (int k = 0; k < 1000; ++k)
    ASSERT_TRUE(observe(state, at, Velocities<R, T>{}, applied).ok());
  constexpr auto bound = error_bound<S, T>(algorithm::MomentumObserver<Tuning>{});
  for (int k = 0; k < joint_count<R>; ++k)
    EXPECT_NEAR(real(state.residual, k), k == 3 ? 0.5 : 0.0, bound[k] + 1e-6) << k;
}
