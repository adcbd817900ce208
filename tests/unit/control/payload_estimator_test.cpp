// Payloads weighed: what is exact in double, fixed point against double, and that nothing wraps.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <oracle/random_chain.hpp>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>

#include <cmath>
#include <type_traits>

namespace {

using namespace axial;
using Panda = robots::Panda;
using robots::Puma560;

struct Weighing {
  static constexpr double period = 1e-3, gain = 50.0;
  static constexpr double deviation = 0.001, memory = 100.0, mass_deviation = 0.02, moment_deviation = 0.01;
};
struct Forgetful : Weighing {
  static constexpr double memory = 0.512;
};
template <class R>
using Loaded = Scene<R, Gravity, Payload>;
template <class R>
using Checked = Scene<R, Gravity, RangeCheck>;

// Joints about the middle of their ranges, each at its own frequency.
template <class R>
struct Sample {
  Joints<R, double> q{}, qd{}, qdd{};
  Sample(double t, double pace) {
    for (int i = 0; i < R::chain.size; ++i) {
      const auto& link = R::chain.links[i];
      const double w = pace * (1.0 + 0.3 * i);
      q[i] = 0.5 * (link.position_min + link.position_max) + 0.3 * (i % 2) + 0.3 * std::sin(w * t);
      qd[i] = 0.3 * w * std::cos(w * t), qdd[i] = -0.3 * w * w * std::sin(w * t);
    }
  }
};

// An observer that knows of no payload, and what weighs it; drives give exactly what robot and payload need.
template <class R, class T, class Tuning>
class Scale {
 public:
  using S = std::conditional_t<is_stored_v<T>, Checked<R>, Scene<R, Gravity>>;

  void watch(double mass, const Vec3<double>& com, double pace, int samples) {
    Inputs<Loaded<R>, double> in;
    in.payload = {mass, com, {}};
    for (int k = 0; k < samples; ++k, ++time_) {
      const Sample<R> now(time_ * 1e-3, pace), middle((time_ - 0.5) * 1e-3, pace);
      step(now, inverse_dynamics<Loaded<R>>(middle.q, middle.qd, middle.qdd, in));
    }
  }
  auto found() const { return estimate<Tuning>(state); }
  PayloadState<S, T> state;

 private:
  void step(const Sample<R>& now, const Joints<R, double>& tau) {
    if constexpr (is_stored_v<T>) {
      const auto q = to_fixed<Positions<R, T>>(now.q), qd = to_fixed<Velocities<R, T>>(now.qd);
      EXPECT_TRUE(observe(observer_, q.values, qd.values, to_fixed<EffortsOf<S, T>>(tau).values).ok());
      EXPECT_TRUE((update_payload<S, T, Tuning>(state, q.values, qd.values, observer_.residual).ok()));
    } else {
      EXPECT_TRUE(observe(observer_, now.q, now.qd, tau).ok());
      EXPECT_TRUE((update_payload<S, T, Tuning>(state, now.q, now.qd, observer_.residual).ok()));
    }
  }
  ObserverState<S, T, Tuning> observer_;
  int time_ = 0;
};

double real(double x) { return x; }
double real(const Scaled& x) { return to_real<double>(x); }
template <class E>
double length_between(const E& found, const Vec3<double>& truth) {
  const auto& h = found.first_moment;
  return std::hypot(real(h.x) - truth.x, real(h.y) - truth.y, real(h.z) - truth.z);
}

}  // namespace

// A point mass at the tool point, slowly moved: the inertia left out is none, the rest is the discretisation's.
TEST(PayloadEstimator, IsExactWithoutNoise) {
  Scale<Panda, double, Weighing> scale;
  scale.watch(1.5, {0.0, 0.0, 0.107}, 1.0, 4000);
  const auto found = scale.found();
  EXPECT_TRUE(found.status.ok());
  EXPECT_NEAR(found.mass, 1.5, 1e-5);
  EXPECT_LT(length_between(found, {0.0, 0.0, 1.5 * 0.107}), 1e-5);
  EXPECT_NEAR(found.body().com.z, 0.107, 1e-5);
  EXPECT_GT(found.variance[0], 0.0);
}

// Half a gram and half a gram metre; double and words see the same samples.
template <class R>
void expect_fixed_like_double(const Vec3<double>& com, double pace) {
  for (const double mass : {0.25, 1.5, 2.4}) {
    const std::uint64_t before = range_overflows;
    Scale<R, double, Weighing> exact;
    Scale<R, Fixed32, Weighing> fixed;
    exact.watch(mass, com, pace, 4000), fixed.watch(mass, com, pace, 4000);
    const auto truth = exact.found();
    const auto found = fixed.found();
    EXPECT_TRUE(truth.status.ok());
    EXPECT_TRUE(found.status.ok());
    EXPECT_NEAR(real(found.mass), truth.mass, 5e-4);
    EXPECT_LT(length_between(found, truth.first_moment), 5e-4);
    // The memory is 131 s of 2^17 samples instead of 100 s: within 2 %.
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(real(found.variance[i]) / truth.variance[i], 1.0, 0.02) << i;
    EXPECT_EQ(range_overflows, before);
  }
}
TEST(PayloadEstimator, InFixedPointFindsWhatDoubleFinds) {
  expect_fixed_like_double<Panda>({0.05, -0.03, 0.15}, 1.0);
  expect_fixed_like_double<Puma560>({0.05, -0.03, 0.1}, 0.7);
}

// One pose does not show how high the centre of mass is; nothing seen shows nothing.
TEST(PayloadEstimator, SaysWhenItHasNotSeenEnough) {
  Scale<Panda, double, Weighing> still;
  Scale<Panda, Fixed32, Weighing> words;
  EXPECT_EQ(still.found().status.code, Status::Code::not_ready);
  EXPECT_EQ(words.found().status.code, Status::Code::not_ready);
  still.watch(1.5, {0.02, 0.01, 0.107}, 0.0, 2000), words.watch(1.5, {0.02, 0.01, 0.107}, 0.0, 2000);
  EXPECT_EQ(still.found().status.code, Status::Code::not_ready);
  EXPECT_EQ(words.found().status.code, Status::Code::not_ready);
  EXPECT_EQ(payload_words<Panda>(words.found()).status.code, Status::Code::not_ready);
  EXPECT_EQ((PayloadEstimate<double>{-0.1, {0.1, 0.0, 0.0}, {}, {}}.body().mass), 0.0);
}

// Memory of 0.512 s, 2^9 samples: ten of them later little is left of what was there before.
template <class T>
void expect_forgetting() {
  Scale<Panda, T, Forgetful> scale;
  scale.watch(0.5, {0.0, 0.0, 0.107}, 2.0, 3000);
  EXPECT_NEAR(real(scale.found().mass), 0.5, 0.02);
  scale.watch(2.0, {0.0, 0.0, 0.107}, 2.0, 300);
  const double between = real(scale.found().mass);
  EXPECT_GT(between, 0.6);
  EXPECT_LT(between, 1.9);
  scale.watch(2.0, {0.0, 0.0, 0.107}, 2.0, 5120);
  EXPECT_NEAR(real(scale.found().mass), 2.0, 0.02);
}
TEST(PayloadEstimator, FollowsAChangedPayload) {
  expect_forgetting<double>();
  expect_forgetting<Fixed32>();
}

// Columns anywhere inside the limits and at their corners, against double, to units of the formats.
template <class R>
void expect_columns_inside_formats() {
  using F = detail::ColumnRounding<Checked<R>, Fixed32>;
  oracle::RandomChains random(11);
  const std::uint64_t before = range_overflows;
  for (int k = 0; k < 1000; ++k) {
    Joints<R, double> q{}, qd{};
    for (int i = 0; i < R::chain.size; ++i) {
      const auto& l = R::chain.links[i];
      q[i] = random.uniform(l.position_min, l.position_max);
      qd[i] = k % 2 == 0 ? random.uniform(-l.speed_limit, l.speed_limit)
                         : l.speed_limit * (random.below(2) == 0 ? 1.0 : -1.0);
    }
    const auto position = to_fixed<Positions<R, Fixed32>>(q), speed = to_fixed<Velocities<R, Fixed32>>(qd);
    const auto ours = detail::payload_columns<Checked<R>, Fixed32>(position.values, speed.values);
    const auto truth = detail::payload_columns<Scene<R, Gravity>, double>(to_real<double>(position.values),
                                                                          to_real<double>(speed.values));
    for (int i = 0; i < R::chain.size; ++i)
      for (int c = 0; c < 4; ++c) {
        const int p = F::momentum[c > 0], d = F::drift[c > 0];
        ASSERT_NEAR(ours.momentum[i].of[c].raw * detail::power_of_two(-p), truth.momentum[i].of[c], 1e-6) << i << c;
        ASSERT_NEAR(ours.drift[i].of[c].raw * detail::power_of_two(-d), truth.drift[i].of[c], 2e-5) << i << c;
      }
  }
  EXPECT_EQ(range_overflows, before);
}
TEST(PayloadEstimator, ColumnsInFixedPointAreExactAndNeverOverflow) {
  expect_columns_inside_formats<Panda>();
  expect_columns_inside_formats<Puma560>();
}

// The largest words that formats hold: lagged rows, their weights and the sums still fit.
TEST(PayloadEstimator, FitsWhateverTheWordsAre) {
  using Sums = detail::PayloadSums<Checked<Panda>, Fixed32, Weighing>;
  using F = detail::ColumnRounding<Checked<Panda>, Fixed32>;
  __extension__ using Wide = __int128;
  const Fixed32 words[] = {{INT32_MAX}, {INT32_MIN}};
  for (int up : {0, 1}) {
    const Fixed32 most = words[up], least = words[1 - up];
    detail::PayloadRow<Fixed32> row;
    for (int k = 0; k < 4; ++k) {
      const int p = F::momentum[k > 0], d = F::drift[k > 0], e = Sums::formats.exponent[k];
      const auto value = [](const Fixed32& x, int exponent) { return x.raw * detail::power_of_two(-exponent); };
      for (int n = 0; n < 2000; ++n)
        row.of[k] = Sums::lagged(k, row.of[k], most, least, least, least);
      const double whole = (value(most, p) - value(least, p)) / Weighing::period - value(least, d);
      EXPECT_NEAR(value(row.of[k], e), whole, 1e-6 * std::fabs(whole)) << k;
    }
    integer::WideSum information[4][4], moment[4];
    Wide truth[4][4] = {}, right[4] = {};
    for (int n = 0; n < 3000; ++n)
      for (int i = 0; i < 7; ++i) {
        Sums::add(information, moment, true, i, row, most);
        const auto at = [i](const Fixed32& x, const auto& factors) {
          return (Wide{x.raw} * factors[i] + (1 << 30)) >> 31;
        };
        for (int a = 0; a < 4; ++a) {
          right[a] -= at(row.of[a], Sums::formats.row_factor) * at(most, Sums::formats.residual_factor);
          for (int b = 0; b <= a; ++b)
            truth[a][b] += at(row.of[a], Sums::formats.row_factor) * at(row.of[b], Sums::formats.row_factor);
        }
      }
    const auto wide = [](const integer::WideSum& x) { return Wide{x.high} * (Wide{1} << 32) + x.low; };
    for (int a = 0; a < 4; ++a) {
      EXPECT_TRUE(wide(moment[a]) == right[a]) << a;
      for (int b = 0; b <= a; ++b)
        EXPECT_TRUE(wide(information[a][b]) == truth[a][b]) << a << b;
    }
  }
  for (int i = 0; i < 7; ++i) {
    EXPECT_LE(Sums::formats.row_factor[i], 0.9995 * detail::power_of_two(31));
    EXPECT_LE(Sums::formats.residual_factor[i], 0.9995 * detail::power_of_two(31));
  }
}

// What was weighed, as feed-forward takes it: the torque of the true payload, and a status beyond the declared one.
TEST(PayloadEstimator, GivesFeedForwardItsPayload) {
  Scale<Panda, Fixed32, Weighing> scale;
  scale.watch(1.5, {0.0, 0.0, 0.107}, 1.0, 4000);
  const auto words = payload_words<Panda>(scale.found());
  EXPECT_TRUE(words.status.ok());
  using Words = PayloadWords<Panda, std::int32_t>;
  EXPECT_NEAR(words.mass.raw * detail::power_of_two(-Words::mass_exponent), 1.5, 1e-3);
  EXPECT_NEAR(words.first_moment.z.raw * detail::power_of_two(-Words::first_moment_exponent), 1.5 * 0.107, 1e-3);
  Inputs<Loaded<Panda>, double> truth;
  truth.payload = {1.5, {0.0, 0.0, 0.107}, {}};
  Inputs<Loaded<Panda>, Fixed32> in;
  in.payload = words.body;
  const Sample<Panda> at(0.3, 1.0);
  const auto expected = inverse_dynamics<Loaded<Panda>>(at.q, at.qd, at.qdd, truth);
  const auto tau = inverse_dynamics<Loaded<Panda>, Fixed32>(to_fixed<Positions<Panda, Fixed32>>(at.q).values,
                                                            to_fixed<Velocities<Panda, Fixed32>>(at.qd).values,
                                                            to_fixed<Accelerations<Panda, Fixed32>>(at.qdd).values, in);
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR(tau[i].raw * detail::power_of_two(-tau.exponent(i)), expected[i], 0.01) << i;
}
TEST(PayloadEstimator, SaysWhenAPayloadIsBeyondTheDeclaredOne) {
  using N = NumberTraits<Scaled>;
  PayloadEstimate<Scaled> heavy;
  heavy.mass = N::constant(100.0), heavy.first_moment = {N::constant(1.0), N::constant(0.0), N::constant(-0.5)};
  const auto words = payload_words<Panda>(heavy);
  EXPECT_EQ(words.status.code, Status::Code::payload_limit);
  EXPECT_EQ(words.body.mass.raw, INT32_MAX);
  heavy.mass = N::constant(-0.01);
  const auto none = payload_words<Panda>(heavy);
  EXPECT_EQ(none.body.mass.raw, 0);
  EXPECT_EQ(none.body.com.x.raw, 0);
}
