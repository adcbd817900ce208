// Every kernel in 32 bits over robots that nobody tuned for: nothing overflows, no certified error is exceeded, and
// that of inverse dynamics is not far above what a search finds.
#pragma once

#include <axial/fixed.hpp>

#include "untuned_reference.hpp"

namespace property {

/// How far a robot's certified errors of efforts may lie above what is found: the less, the longer the search.
inline double allowed_looseness(std::uint64_t states) { return states >= 1000000 ? 20.0 : 50.0; }

/// The largest error over its certified one of each kernel, and of inverse dynamics joint by joint.
template <class R>
class UntunedKernels : UntunedReference<R> {
  using Base = UntunedReference<R>;
  using Base::real, Base::values, Base::model;

 public:
  using Checked = typename Base::Checked;
  using State = typename Base::State;
  using Base::joints;

  enum Kernel { inverse, bias, gravity, mass, poses, columns, momenta, drifts, separated, payload, kernels };
  static constexpr const char* names[kernels] = {
      "inverse dynamics", "bias",    "gravity", "mass matrix",      "poses",
      "Jacobian",         "momenta", "drifts",  "separated torque", "payload's columns"};
  double nearest[kernels] = {}, nearest_of_joint[joints] = {};
  double share[joints] = {};  ///< of inverse dynamics at the last state
  std::uint64_t overflows[kernels] = {};

  /// Compares every kernel at one state.
  void see(State state) {
    Base::hold_positions(state);
    const auto q = values(state.q, true), qd = values(state.qd), qdd = values(state.qdd);
    see_efforts(state, q, qd, qdd);
    see_structure(state, q);
    see_momenta(state, q, qd);
    see_payload(state, q, qd);
  }

 private:
  double largest_[kernels] = {};  // of the exact results so far

  // `size` is that of the exact result: double precision rounds, too, where a bound is 0.
  void see(Kernel kernel, double error, double bound, double size) {
    size = largest_[kernel] = std::fmax(largest_[kernel], size);
    const double share = bound > 0.0 ? error / bound : error > 1e-12 * size ? HUGE_VAL : 0.0;
    nearest[kernel] = std::fmax(nearest[kernel], share);
  }
  // What a kernel answers; counts what did not fit.
  template <class Run>
  auto run(Kernel kernel, const Run& run) {
    const std::uint64_t before = axial::range_overflows;
    const auto result = run();
    overflows[kernel] += axial::range_overflows - before;
    return result;
  }
  template <class Exact>
  static double largest(const Exact& exact) {
    double most = 0.0;
    for (int i = 0; i < joints; ++i)
      most = std::fmax(most, std::fabs(exact[i]));
    return most;
  }
  template <class Got, class Exact, class Bound>
  void see_joints(Kernel kernel, const Got& got, const Exact& exact, const Bound& bound) {
    for (int i = 0; i < joints; ++i)
      see(kernel, std::fabs(real(got, i) - exact[i]), bound[i], largest(exact));
  }
  template <class Q>
  void see_efforts(const State& state, const Q& q, const Q& qd, const Q& qdd) {
    constexpr auto bound = axial::error_bound<Checked>(axial::algorithm::inverse_dynamics);
    const auto got = run(inverse, [&] { return axial::inverse_dynamics<Checked>(state.q, state.qd, state.qdd); });
    const auto exact = inverse_dynamics(model(), q, qd, qdd);
    see_joints(inverse, got, exact, bound);
    see_joints(bias, run(bias, [&] { return axial::bias_torque<Checked>(state.q, state.qd); }),
               bias_torque(model(), q, qd), axial::error_bound<Checked>(axial::algorithm::bias));
    see_joints(gravity, run(gravity, [&] { return axial::gravity_torque<Checked>(state.q); }),
               gravity_torque(model(), q), axial::error_bound<Checked>(axial::algorithm::gravity));
    constexpr auto separated_bound = axial::error_bound<Checked>(axial::algorithm::separated_torque);
    const auto in_parts = [&] { return torque(axial::separate<Checked>(state.q), state.qd, state.qdd); };
    see_joints(separated, run(separated, in_parts), exact, separated_bound);
    for (int i = 0; i < joints; ++i) {
      share[i] = bound[i] > 0.0 ? std::fabs(real(got, i) - exact[i]) / bound[i] : 0.0;
      nearest_of_joint[i] = std::fmax(nearest_of_joint[i], share[i]);
    }
  }
  template <class Q>
  void see_structure(const State& state, const Q& q) {
    constexpr auto bound = axial::error_bound<Checked>(axial::algorithm::mass_matrix);
    const auto got = run(mass, [&] { return axial::mass_matrix<Checked>(state.q); });
    const auto exact = mass_matrix(model(), q);
    for (int i = 0; i < joints; ++i)
      for (int j = 0; j <= i; ++j)
        see(mass, std::fabs(got(i, j).raw * axial::detail::power_of_two(-got.exponent(i, j)) - exact(i, j)), bound[i],
            exact(i, i));
    constexpr double length = axial::detail::power_of_two(-axial::length_exponent<Checked, axial::Fixed32>);
    const auto far = [&](const auto& a, const auto& b) {
      return std::sqrt(std::pow(a.x.raw * length - b.x, 2) + std::pow(a.y.raw * length - b.y, 2) +
                       std::pow(a.z.raw * length - b.z, 2));
    };
    const auto frames = run(poses, [&] { return axial::forward_kinematics<Checked>(state.q); });
    const auto exact_frames = forward_kinematics(model(), q);
    const auto columns_of_tool = run(columns, [&] { return axial::jacobian<Checked>(state.q); });
    const auto exact_columns = jacobian(model(), q);
    for (int i = 0; i < joints; ++i) {
      see(poses, far(frames.frames[i].position, exact_frames.frames[i].position),
          axial::error_bound<Checked>(axial::algorithm::forward_kinematics)[i], 1.0);
      see(columns, far(columns_of_tool[i].linear, exact_columns[i].linear),
          axial::error_bound<Checked>(axial::algorithm::jacobian)[i], 1.0);
    }
  }
  template <class Q>
  void see_momenta(const State& state, const Q& q, const Q& qd) {
    const auto got = run(momenta, [&] { return axial::momentum_terms<Checked>(state.q, state.qd); });
    const auto exact = momentum_terms(model(), q, qd);
    see_joints(momenta, got.momentum, exact.momentum, axial::error_bound<Checked>(axial::algorithm::Momentum{}));
    see_joints(drifts, got.drift, exact.drift, axial::error_bound<Checked>(axial::algorithm::MomentumDrift{}));
  }
  template <class Q>
  void see_payload(const State& state, const Q& q, const Q& qd) {
    using Formats = axial::detail::ColumnRounding<Checked, axial::Fixed32>;
    constexpr auto bound = axial::bounds::payload_columns<Checked, std::int32_t>();
    const auto got = run(payload, [&] { return axial::detail::payload_columns<Checked>(state.q, state.qd); });
    axial::Joints<R, double> position{}, velocity{};
    for (int i = 0; i < joints; ++i)
      position[i] = q[i], velocity[i] = qd[i];
    const auto exact = axial::detail::payload_columns<Checked>(position, velocity);
    const auto see_row = [&](const auto& words, const auto& row, const auto& within, const int(&exponents)[2]) {
      for (int k = 0; k < 4; ++k) {
        const double found = words.of[k].raw * axial::detail::power_of_two(-exponents[k > 0]);
        see(payload, std::fabs(found - row.of[k]), k > 0 ? within.moment.error : within.mass.error,
            std::fabs(row.of[k]));
      }
    };
    for (int i = 0; i < joints; ++i) {
      see_row(got.momentum[i], exact.momentum[i], bound.momentum[i], Formats::momentum);
      see_row(got.drift[i], exact.drift[i], bound.drift[i], Formats::drift);
    }
  }
};

/// All kernels of one robot.
template <class R>
void expect_kernels_inside_their_bounds() {
  UntunedKernels<R> robot;
  using State = typename UntunedKernels<R>::State;
  const std::uint64_t states = untuned_states(), seed = 11;
  exhaustive::Random random(seed);
  for (std::uint64_t k = 0; k < states; ++k)
    robot.see(exhaustive::next_state<State>(random, k % 4));
  const int steps = static_cast<int>(states / 10);
  for (int i = 0; i < State::size; ++i)
    exhaustive::climb<State>(seed + static_cast<std::uint64_t>(i), steps, 3 * State::size, [&](const State& state) {
      robot.see(state);
      return robot.share[i];
    });
  std::printf("%s, %d joints: %llu states;", R::name, State::size, static_cast<unsigned long long>(states));
  for (int kernel = 0; kernel < robot.kernels; ++kernel) {
    std::printf(" %s %.2f", robot.names[kernel], robot.nearest[kernel]);
    EXPECT_LE(robot.nearest[kernel], 1.0) << robot.names[kernel];
    EXPECT_EQ(robot.overflows[kernel], 0U) << robot.names[kernel];
  }
  double loosest = 0.0;
  for (const double share : robot.nearest_of_joint)
    loosest = std::fmax(loosest, share > 0.0 ? 1.0 / share : 0.0);
  std::printf("; an effort's bound is at most %.1f times what was found\n", loosest);
  EXPECT_LE(loosest, allowed_looseness(states));
}

template <class R>
class UntunedRobotsKernels : public testing::Test {};
TYPED_TEST_SUITE_P(UntunedRobotsKernels);
TYPED_TEST_P(UntunedRobotsKernels, StayInsideTheirBounds) { expect_kernels_inside_their_bounds<TypeParam>(); }
REGISTER_TYPED_TEST_SUITE_P(UntunedRobotsKernels, StayInsideTheirBounds);

}  // namespace property
