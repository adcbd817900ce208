// Hostile run-time inputs in fixed point: payload, wrench, gravity, pairs of sines and cosines of any words.
#include "hostile_fixed.hpp"

#include <gtest/gtest.h>

namespace {

using namespace axial;
using R = property::SlidingTree;
using property::Wrong;
using S = Scene<R, RuntimeGravity, RotorInertia, Friction, Payload, TipWrench, SineCosines>;
using Reference = Scene<R, RuntimeGravity, RotorInertia, Friction, Payload, TipWrench, SineCosines, ArticulatedBody>;
using F = InputFormats<R, Fixed32>;
using State = property::HostileState<S>;
using Pairs = Joints<R, SinCos<Fixed32>>;

// Inputs as one row of words: payload mass, com, inertia; force, moment; gravity.
constexpr int exponents[] = {F::payload_mass,    F::payload_com,     F::payload_com,     F::payload_com,
                             F::payload_inertia, F::payload_inertia, F::payload_inertia, F::payload_inertia,
                             F::payload_inertia, F::payload_inertia, F::tip_moment,      F::tip_moment,
                             F::tip_moment,      F::tip_force,       F::tip_force,       F::tip_force,
                             F::gravity,         F::gravity,         F::gravity};
constexpr double most[] = {1.0, 0.05, 0.05, 0.05, 0.01, 0.01, 0.01, 0.003, 0.003, 0.003,
                           2.8, 2.8,  2.8,  11.0, 11.0, 11.0, 5.6,  5.6,   5.6};
constexpr int words = 19, load_words = 10;

template <class In>
auto row_of(In& in) {
  auto &p = in.payload, &w = in.tip_wrench;
  auto& j = p.inertia_com;
  struct Row {
    decltype(&p.mass) at[words];
  };
  return Row{{&p.mass, &p.com.x, &p.com.y, &p.com.z, &j.xx, &j.yy, &j.zz, &j.xy, &j.xz, &j.yz, &w.moment.x, &w.moment.y,
              &w.moment.z, &w.force.x, &w.force.y, &w.force.z, &in.gravity.x, &in.gravity.y, &in.gravity.z}};
}

/// What is given, as words and as numbers.
struct Given {
  Inputs<S, Fixed32> fixed{};
  Inputs<Reference, double> exact{};
  bool stretched = false;  ///< whether pairs are no longer those of angles: then the routes differ by as much
  double limit(int k) const { return most[k] * detail::power_of_two(exponents[k]); }

  Given(exhaustive::Random& random, const State& state, std::uint64_t index) {
    const auto row = row_of(fixed);
    const std::int64_t one = random.between(0, words - 1);
    for (int k = 0; k < words; ++k) {
      const auto high = static_cast<std::int64_t>(limit(k));
      const exhaustive::Span span{k < 1 || (k > 3 && k < 7) ? high / 2 : -high, high};
      const bool hostile = index % 4 == 0 || (index % 4 == 1 && k == one);
      row.at[k]->raw = static_cast<std::int32_t>(hostile ? property::hostile_word(random, span)
                                                         : random.between(span.low, span.high));
    }
    for (int i = 0; i < R::chain.size; ++i) {
      const auto pair = integer::sincos(static_cast<std::uint32_t>(state.q[i].raw));
      const std::int64_t longer = index % 8 == 7 ? random.between(-(1 << 22), 1 << 22) : 0;  // to 2^-8 of the length
      const bool hostile = index % 8 == 3 && random.between(0, 3) == 0;
      const auto word = [&](std::int64_t x) {
        return static_cast<std::int32_t>(hostile ? static_cast<std::int32_t>(random.bits()) : x + ((x * longer) >> 30));
      };
      fixed.turns[i].sin.raw = word(pair.sin), fixed.turns[i].cos.raw = word(pair.cos);
      stretched = stretched || longer != 0;
      exact.turns[i] = {fixed.turns[i].sin.raw * 0x1p-30, fixed.turns[i].cos.raw * 0x1p-30};
    }
    const auto numbers = row_of(exact);
    for (int k = 0; k < words; ++k)
      *numbers.at[k] = row.at[k]->raw * detail::power_of_two(-exponents[k]);
  }
};

double length(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }
double smallest_principal(const Sym3<double>& j) {
  // Smith's formula for the eigenvalues of a symmetric 3x3.
  const double mean = (j.xx + j.yy + j.zz) / 3.0, off = j.xy * j.xy + j.xz * j.xz + j.yz * j.yz;
  const double x = j.xx - mean, y = j.yy - mean, z = j.zz - mean;
  const double p = std::sqrt((x * x + y * y + z * z + 2.0 * off) / 6.0);
  if (!(p > 0.0)) return mean;
  const double det = x * (y * z - j.yz * j.yz) - j.xy * (j.xy * z - j.yz * j.xz) + j.xz * (j.xy * j.yz - y * j.xz);
  const double r = std::fmin(std::fmax(det / (2.0 * p * p * p), -1.0), 1.0);
  return mean + 2.0 * p * std::cos(std::acos(r) / 3.0 + 2.0943951023931953);
}

/// What the status must be where no input is within a millionth of its limit; payloads first.
struct ExpectedInputs {
  Status::Code code = Status::Code::ok;
  bool doubtful = false;
  explicit ExpectedInputs(const Inputs<Reference, double>& in) {
    const auto& p = in.payload;
    const auto& j = p.inertia_com;
    for (const double x : {p.mass, j.xx, j.yy, j.zz})
      see(-x, 0.0, Status::Code::payload_limit, 1e-9);
    see(p.mass, 1.0, Status::Code::payload_limit), see(length(p.com), 0.1, Status::Code::payload_limit);
    for (const double x : {j.xx, j.yy, j.zz, j.xy, j.xz, j.yz})
      see(std::fabs(x), 0.01, Status::Code::payload_limit);
    see(-smallest_principal(j), 0.0, Status::Code::payload_limit, 1e-9);
    see(length(in.tip_wrench.force), 20.0, Status::Code::input_limit);
    see(length(in.tip_wrench.moment), 5.0, Status::Code::input_limit);
    see(length(in.gravity), 9.81, Status::Code::input_limit);
    for (int i = 0; i < R::chain.size; ++i)
      if (State::turns(i))
        see(std::fabs(in.turns[i].sin * in.turns[i].sin + in.turns[i].cos * in.turns[i].cos - 1.0), 0x1p-9,
            Status::Code::input_limit);
  }

 private:
  void see(double x, double limit, Status::Code of, double slack = 0.0) {
    slack += 1e-6 * limit;
    if (code != Status::Code::ok) return;
    if (x > limit + slack) code = of;
    doubtful = doubtful || std::fabs(x - limit) <= slack;
  }
};

}  // namespace

TEST(HostileInputs, ForwardDynamicsIsRightOrSaysOtherwise) {
  exhaustive::Random random(property::hostile_seed);
  Wrong wrong;
  std::uint64_t met = 0;
  const std::uint64_t states = property::hostile_states(20000, 8);
  for (std::uint64_t k = 0; k < states; ++k) {
    const auto state = property::hostile_state<State>(random, 3);
    const Given in(random, state, k);
    const ExpectedInputs expected(in.exact);
    const auto fixed = forward_dynamics<S>(state.q, state.qd, state.tau, in.fixed);
    if (!expected.doubtful) {
      const bool named = expected.code == fixed.status.code ||
                         (expected.code == Status::Code::ok && fixed.status.code != Status::Code::payload_limit &&
                          fixed.status.code != Status::Code::input_limit);
      wrong.note(named, "the status of inputs", k, static_cast<int>(fixed.status.code),
                 static_cast<int>(expected.code));
    }
    if (!fixed.status.ok() && fixed.status.code != Status::Code::rescaled) continue;
    ++met;
    if (in.stretched) continue;
    const auto exact =
        forward_dynamics<Reference>(exhaustive::in_double<R>(state.q), exhaustive::in_double<R>(state.qd),
                                    exhaustive::in_double<R>(state.tau), in.exact);
    const auto seen = exhaustive::in_double<R>(fixed);
    for (int i = 0; i < R::chain.size; ++i) {
      const double range = 0x1p31 * detail::power_of_two(-fixed.exponent(i));
      wrong.note(std::fabs(seen[i] - exact[i]) <= range * 0x1p-10, "forward dynamics", k, seen[i], exact[i]);
    }
  }
  EXPECT_EQ(wrong.count, 0U) << wrong.first;
  EXPECT_GT(met, states / 4);
}
