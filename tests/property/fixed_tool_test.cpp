// J^T w in fixed point: against integers of 128 bits, word by word, and against the oracle's Jacobians in quadruple
// precision, within the certified errors.
#include <random>

#include <axial/fixed.hpp>
#include <robots/panda.hpp>
#include <robots/scara.hpp>

#include "support.hpp"

namespace {

using namespace axial;
using oracle::quad;

constexpr int states = 20'000;
constexpr unsigned seed = 2024;
using T = Fixed32;
using Push = ForceVector<Vec3<T>, Vec3<T>>;

/// A robot with a declared wrench at its tip, and a tool beside the last axis.
template <class R>
struct Pushed {
  static constexpr auto chain = [] {
    auto c = R::chain;
    c.tip_wrench_limit = tip_wrench_limit(60.0, 12.0);
    c.tool = tool(0.05, -0.02, 0.15);
    return c;
  }();
};

template <class R>
class FixedToolOf : public testing::Test {
 protected:
  std::mt19937 random{seed};

  std::int32_t word() { return static_cast<std::int32_t>(random()); }
  double unit() { return std::uniform_real_distribution<>(-1.0, 1.0)(random); }

  /// Anywhere within the limits.
  Positions<R, T> position() {
    Positions<R, T> q;
    for (int i = 0; i < q.size; ++i) {
      const auto& link = R::chain.links[i];
      const double mean = 0.5 * (link.position_min + link.position_max), half = link.position_max - mean;
      q[i].raw = link.type == JointType::revolute
                     ? word()
                     : static_cast<std::int32_t>(std::ldexp(mean + 0.999 * half * unit(), q.exponent(i)));
    }
    return q;
  }
  static quad value(const Positions<R, T>& q, int i) {
    const quad two_pi = quad(6.283185307179586232) + quad(2.449293598294706414e-16);  // to 106 bits
    return R::chain.links[i].type == JointType::revolute ? two_pi * quad(q[i].raw) / quad(4294967296.0)
                                                         : quad(std::ldexp(q[i].raw, -q.exponent(i)));
  }
  /// As long as declared, any way.
  Vec3<T> vector(double most, int exponent) {
    const double x = unit(), y = unit(), z = unit(), length = std::hypot(x, y, z);
    const auto part = [&](double v) { return T{static_cast<std::int32_t>(std::ldexp(most * v / length, exponent))}; };
    return {part(x), part(y), part(z)};
  }
  static quad part(const Vec3<T>& v, int i, int exponent) {
    return quad(std::ldexp(i == 0 ? v.x.raw : i == 1 ? v.y.raw : v.z.raw, -exponent));
  }
  static quad found(const WrenchEfforts<R, T>& tau, int i) { return quad(std::ldexp(tau[i].raw, -tau.exponent(i))); }
};
using Robots = testing::Types<Pushed<robots::Scara>, Pushed<robots::Panda>>;
TYPED_TEST_SUITE(FixedToolOf, Robots);

/// Words at the ends of their range and in it: nothing overflows, and the product of the words is rounded once.
TYPED_TEST(FixedToolOf, TransposeTimesIsTheProductOfItsWordsWhateverTheyAre) {
  using R = TypeParam;
  using F = InputFormats<R, T>;
  constexpr int turn = direction_exponent<T>, length = length_exponent<R, T>;
  constexpr std::int32_t ends[] = {(std::numeric_limits<std::int32_t>::max)(),
                                   (std::numeric_limits<std::int32_t>::min)()};
  quad worst = 0;
  for (int k = 0; k < states; ++k) {
    const auto j = jacobian<R>(this->position());
    const auto any = [&] { return T{k % 2 == 0 ? ends[this->word() & 1] : this->word()}; };
    const Push w{{any(), any(), any()}, {any(), any(), any()}};
    const auto tau = transpose_times(j, w);
    for (int i = 0; i < joint_count<R>; ++i) {
      quad exact = 0;
      for (int c = 0; c < 3; ++c)
        exact += this->part(j[i].angular, c, turn) * this->part(w.moment, c, F::tip_moment) +
                 this->part(j[i].linear, c, length) * this->part(w.force, c, F::tip_force);
      const quad off = (this->found(tau, i) - exact) * quad(std::ldexp(1.0, tau.exponent(i)));
      worst = off > worst ? off : -off > worst ? -off : worst;
    }
  }
  EXPECT_LE(static_cast<double>(worst), 0.5 + 1e-6) << "units of the result";
  EXPECT_GT(static_cast<double>(worst), 0.4);
}

TYPED_TEST(FixedToolOf, TransposeTimesStaysWithinItsCertifiedError) {
  using R = TypeParam;
  using F = InputFormats<R, T>;
  constexpr auto bound = error_bound<R, T>(algorithm::TransposeTimes{});
  const auto chain = oracle::of_robot<quad, R>();
  std::array<quad, joint_count<R>> worst{};
  for (int k = 0; k < states / 10; ++k) {
    const auto q = this->position();
    const Push w{this->vector(F::wrench.moment, F::tip_moment), this->vector(F::wrench.force, F::tip_force)};
    const auto j = jacobian<R>(q);
    ASSERT_TRUE(j.status.ok());
    const auto tau = transpose_times(j, w);
    oracle::Vector<quad> at;
    for (int i = 0; i < joint_count<R>; ++i)
      at.push_back(this->value(q, i));
    const auto exact = oracle::tool_jacobian(chain, at);
    for (int i = 0; i < joint_count<R>; ++i) {
      quad effort = 0;
      for (int c = 0; c < 3; ++c)
        effort += exact.angular(c, i) * this->part(w.moment, c, F::tip_moment) +
                  exact.linear(c, i) * this->part(w.force, c, F::tip_force);
      const quad off = this->found(tau, i) - effort;
      auto& most = worst[std::size_t(i)];
      most = off > most ? off : -off > most ? -off : most;
    }
  }
  for (int i = 0; i < joint_count<R>; ++i) {
    const double share = static_cast<double>(worst[std::size_t(i)]) / bound[i];
    EXPECT_LE(share, 1.0) << "joint " << i;
    EXPECT_GT(share, 0.01) << "joint " << i;
    this->RecordProperty("share_of_joint_" + std::to_string(i), std::to_string(share));
  }
}

}  // namespace
