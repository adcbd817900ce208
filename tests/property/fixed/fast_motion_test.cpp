// Forward dynamics in words of a motion so fast that its bias needs a halving of the drive: inside all limits it is ok,
// and within the proved bound.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>

#include <cmath>

namespace {

using namespace axial;

/// Drives that hold the arm and little more, on links that may swing fast.
struct Whip {
  static constexpr auto chain = axial::chain(gravity(0, 0, -9.81),
                                             revolute()
                                                 .mass(4)
                                                 .com(0.3, 0, 0)
                                                 .inertia_com(0.05, 0.05, 0.05)
                                                 .speed_limit(12)
                                                 .acceleration_limit(900)
                                                 .effort_limit(60),
                                             revolute()
                                                 .a(0.6)
                                                 .mass(2)
                                                 .com(0.3, 0, 0)
                                                 .inertia_com(0.03, 0.03, 0.03)
                                                 .speed_limit(15)
                                                 .acceleration_limit(1800)
                                                 .effort_limit(30));
};
using S = Scene<Whip, Gravity, RotorInertia>;

}  // namespace

TEST(FixedPointForwardDynamics, AFastMotionInsideAllLimitsIsOk) {
  constexpr auto bound = error_bound<S>(algorithm::forward_dynamics);
  int fast = 0;
  for (int k = 0; k < 400; ++k) {
    const double q2 = 0.0157 * k, sign = k % 2 == 0 ? 1.0 : -1.0;
    Joints<Whip, double> q{0.4, q2}, qd{11.0 * sign, k % 3 == 0 ? 13.0 : -13.0},
        tau{k % 5 < 2 ? 40.0 : -40.0, 15.0 * sign};
    Positions<Whip, Fixed32> words{};
    Velocities<Whip, Fixed32> rates{};
    EffortsOf<S, Fixed32> efforts{};
    for (int i = 0; i < 2; ++i) {
      words[i].raw = static_cast<std::int32_t>(std::remainder(q[i] / 6.283185307179586, 1.0) * 4294967296.0);
      rates[i].raw = static_cast<std::int32_t>(std::ldexp(qd[i], rates.exponent(i)));
      efforts[i].raw = static_cast<std::int32_t>(std::ldexp(tau[i], efforts.exponent(i)));
      q[i] = words[i].raw / 4294967296.0 * 6.283185307179586;
      qd[i] = std::ldexp(rates[i].raw, -rates.exponent(i)), tau[i] = std::ldexp(efforts[i].raw, -efforts.exponent(i));
    }
    const auto exact = forward_dynamics<S>(q, qd, tau);
    const auto got = forward_dynamics<S>(words, rates, efforts);
    EXPECT_EQ(got.status.code, Status::Code::ok) << "state " << k;
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(std::ldexp(got[i].raw, -got.exponent(i)), exact[i], bound[i]) << "state " << k;
    fast += std::fabs(exact[1]) > 100.0 ? 1 : 0;
  }
  EXPECT_GT(fast, 40) << "then this tests nothing";
}
