// A payload behind joints that share drives in fixed point: rows inside their certified errors against the same
// difference equation in real numbers, and an estimate of what hangs there.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <cmath>
#include <robots/robots.hpp>

#include "driven_robots.hpp"
#include "driven_states.hpp"

namespace {

using namespace axial;
using property::real;
using T = Fixed32;

struct Weighing {
  static constexpr double period = 1e-3, gain = 50.0, deviation = 0.001, memory = 4.0, mass_deviation = 0.02,
                          moment_deviation = 0.01;
};

/// The estimator's columns behind the observer's lag, in real numbers.
template <class R>
struct RealRows {
  using Columns = detail::PayloadColumns<Scene<R, Gravity>, double>;
  double row[joint_count<R>][4] = {};
  Columns last{};
  bool ready = false;

  void sample(const Joints<R, double>& u, const Joints<R, double>& ud) {
    const auto now = detail::payload_columns<Scene<R, Gravity>, double>(u, ud);
    const double share = Weighing::gain * Weighing::period / (1.0 + Weighing::gain * Weighing::period);
    for (int k = 0; ready && k < joint_count<R>; ++k)
      for (int c = 0; c < 4; ++c) {
        const double change = (now.momentum[k].of[c] - last.momentum[k].of[c]) / Weighing::period;
        row[k][c] += share * (change - 0.5 * (now.drift[k].of[c] + last.drift[k].of[c]) - row[k][c]);
      }
    last = now, ready = true;
  }
};

template <class R>
void expect_rows() {
  using S = Scene<R, Gravity, RotorInertia, RangeCheck>;
  using State = exhaustive::FixedState<S, T>;
  using Sums = detail::PayloadSums<S, T, Weighing>;
  constexpr auto bound = error_bound<S, T>(algorithm::PayloadEstimator<Weighing>{});
  exhaustive::Random random(23);
  const std::uint64_t before = range_overflows;
  double mass = 0.0, moment = 0.0;
  int taken = 0;
  for (int run = 0; run < 100; ++run) {
    PayloadState<S, T> state{};
    RealRows<R> exact;
    for (int sample = 0; sample < 8; ++sample) {
      auto motion = exhaustive::next_state<State>(random, static_cast<std::uint64_t>(sample % 4));
      property::hold_joints<R>(motion, true);
      if (!check_request<S>(motion.q, motion.qd, Accelerations<R, T>{}).ok()) continue;
      Joints<R, double> u{}, ud{};
      for (int k = 0; k < joint_count<R>; ++k)
        u[k] = real(motion.q, k), ud[k] = real(motion.qd, k);
      for (int held = 0; held < 20; ++held, ++taken) {
        ASSERT_TRUE((update_payload<S, T, Weighing>(state, motion.q, motion.qd, {}).ok()));
        exact.sample(u, ud);
        for (int k = 0; k < joint_count<R>; ++k)
          for (int c = 0; c < 4; ++c) {
            const double off = std::fabs(state.lagged[k].of[c].raw * detail::power_of_two(-Sums::formats.exponent[c]) -
                                         exact.row[k][c]);
            double& nearest = c == 0 ? mass : moment;
            nearest = std::fmax(nearest, off / (c == 0 ? bound.mass[k] : bound.first_moment[k]));
          }
      }
    }
  }
  std::printf("%s: %d samples, rows come to %.3f of their bounds, %.3f along moments\n", R::name, taken, mass, moment);
  EXPECT_EQ(range_overflows, before) << R::name;
  EXPECT_GT(taken, 2000) << R::name;
  EXPECT_LE(mass, 1.0) << R::name;
  EXPECT_LE(moment, 1.0) << R::name;
  EXPECT_GT(mass, 0.01) << R::name;
  EXPECT_GT(moment, 0.01) << R::name;
}

}  // namespace

TEST(PayloadOfDrives, RowsStayInsideTheirBounds) {
  expect_rows<robots::WristArm>();
  expect_rows<robots::ScaraQuill>();
  expect_rows<property::Followers>();
}
TEST(PayloadOfDrives, IsFoundFromWhatPushesTheDrives) {
  using R = robots::WristArm;
  using S = Scene<R, Gravity, RotorInertia>;
  using Loaded = Scene<R, Gravity, RotorInertia, Payload>;
  constexpr double mass = 1.25, com[] = {0.02, -0.03, 0.06};
  Inputs<Loaded, double> with;
  with.payload.mass = mass, with.payload.com = {com[0], com[1], com[2]};
  ObserverState<S, T, Weighing> observer;
  PayloadState<S, T> state{};
  const auto at = [](int n) {
    const double t = n * Weighing::period;
    return Joints<R, double>{0.8 * std::sin(t), 0.9 + 0.4 * std::sin(1.3 * t), 0.2 + 0.3 * std::sin(1.7 * t),
                             1.2 * std::sin(2.1 * t), 1.1 * std::sin(1.9 * t + 1.0)};
  };
  for (int n = 1; n < 12000; ++n) {
    const auto last = at(n - 1), now = at(n), next = at(n + 1);
    Joints<R, double> ud{}, udd{};
    for (int k = 0; k < joint_count<R>; ++k)
      ud[k] = (next[k] - last[k]) / (2.0 * Weighing::period),
      udd[k] = (next[k] - 2.0 * now[k] + last[k]) / (Weighing::period * Weighing::period);
    const auto tau = inverse_dynamics<Loaded>(now, ud, udd, with);
    const auto q = to_fixed<Positions<R, T>>(now).values;
    const auto qd = to_fixed<Velocities<R, T>>(ud).values;
    ASSERT_TRUE(observe(observer, q, qd, to_fixed<EffortsOf<S, T>>(tau).values).ok());
    ASSERT_TRUE((update_payload<S, T, Weighing>(state, q, qd, observer.residual).ok()));
  }
  const auto found = estimate<Weighing>(state);
  EXPECT_TRUE(found.status.ok()) << int(found.status.code);
  const auto words = payload_words<S>(found);
  EXPECT_TRUE(words.status.ok());
  EXPECT_NEAR(words.mass.raw * detail::power_of_two(-words.mass_exponent), mass, 0.01);
  const double per = detail::power_of_two(-words.first_moment_exponent);
  EXPECT_NEAR(words.first_moment.x.raw * per, mass * com[0], 0.005);
  EXPECT_NEAR(words.first_moment.y.raw * per, mass * com[1], 0.005);
  EXPECT_NEAR(words.first_moment.z.raw * per, mass * com[2], 0.005);
}
