// J-dot and slopes of J^T w: against a closed form, and differences of the Jacobian.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>

using namespace axial;

namespace {

constexpr double l1 = 0.5, l2 = 0.75;

struct Planar {
  static constexpr auto chain = axial::chain(revolute().mass(1.0), revolute().a(l1).mass(1.0), axial::tool(l2, 0, 0));
};
struct Mixed {  // a slide among turns; a branch that does not carry the tool
  static constexpr auto chain =
      axial::chain(revolute().d(0.3).mass(1.0), revolute().alpha_deg(37).a(0.2).d(0.1).mass(1.0),
                   revolute().alpha_deg(20).a(0.1).mass(1.0), prismatic().parent(1).alpha_deg(-64).a(0.15).mass(1.0),
                   revolute().alpha_deg(90).a(0.05).d(0.2).mass(1.0), revolute().alpha_deg(53).a(0.1).mass(1.0));
};
using Values = Joints<Mixed, double>;
using Vector = Vec3<double>;
constexpr Values q{0.4, -1.1, 0.3, 0.8, -0.2, 1.3}, qd{0.7, -0.9, 0.5, 1.1, 0.4, -0.6};

// (8 (f(h) - f(-h)) - (f(2h) - f(-2h))) / 12h along `direction`.
template <class F>
double slope_along(const Values& direction, const F& f) {
  constexpr double h = 1e-3;
  const auto at = [&](double step) {
    Values moved = q;
    for (int i = 0; i < 6; ++i)
      moved[i] += step * direction[i];
    return f(moved);
  };
  return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}
constexpr double Vector::*axes[] = {&Vector::x, &Vector::y, &Vector::z};

void expect_rate(const Jacobian<Mixed, double>& rate, const Values& direction) {
  for (int j = 0; j < 6; ++j) {
    for (const auto axis : axes) {
      const auto angular = [&](const Values& at) { return jacobian<Mixed>(at)[j].angular.*axis; };
      const auto linear = [&](const Values& at) { return jacobian<Mixed>(at)[j].linear.*axis; };
      EXPECT_NEAR(rate[j].angular.*axis, slope_along(direction, angular), 1e-10) << j;
      EXPECT_NEAR(rate[j].linear.*axis, slope_along(direction, linear), 1e-10) << j;
    }
  }
}

}  // namespace

TEST(ToolSlopes, OfAPlanarArmAreTheClosedForm) {
  const double q1 = 0.4, q2 = -1.1, w1 = 0.7, w2 = -0.9, s1 = l1 * std::sin(q1), c1 = l1 * std::cos(q1),
               s12 = l2 * std::sin(q1 + q2), c12 = l2 * std::cos(q1 + q2);
  const auto j = jacobian<Planar>(Joints<Planar, double>{q1, q2});
  const auto rate = jacobian_rate(j, Joints<Planar, double>{w1, w2});
  EXPECT_NEAR(rate[0].linear.x, -c1 * w1 - c12 * (w1 + w2), 1e-14);
  EXPECT_NEAR(rate[0].linear.y, -s1 * w1 - s12 * (w1 + w2), 1e-14);
  EXPECT_NEAR(rate[1].linear.x, -c12 * (w1 + w2), 1e-14);
  EXPECT_NEAR(rate[1].linear.y, -s12 * (w1 + w2), 1e-14);
  const auto slope = wrench_slope(j, ForceVector<Vector, Vector>{{0, 0, 4}, {3, -2, 0}});
  EXPECT_NEAR(slope(0, 0), 3 * (-c1 - c12) - 2 * (-s1 - s12), 1e-14);
  EXPECT_NEAR(slope(0, 1), 3 * -c12 - 2 * -s12, 1e-14);
  EXPECT_NEAR(slope(1, 0), slope(0, 1), 1e-14) << "a moment about the axes changes nothing";
  EXPECT_NEAR(slope(1, 1), slope(0, 1), 1e-14);
}

TEST(ToolSlopes, OfTheJacobianAreDifferences) {
  expect_rate(jacobian_rate(jacobian<Mixed>(q), qd), qd);
  for (int k = 0; k < 6; ++k) {
    Values one{};
    one[k] = 1.0;
    expect_rate(jacobian_rate(jacobian<Mixed>(q), one), one);
  }
}
TEST(ToolSlopes, TheRateTimesSpeedsIsTheBiasAcceleration) {
  const auto j = jacobian<Mixed>(q);
  const auto rate = tool_velocity(jacobian_rate(j, qd), qd), bias = bias_acceleration(j, qd);
  for (const auto axis : axes) {
    EXPECT_NEAR(rate.angular.*axis, bias.angular.*axis, 1e-14);
    EXPECT_NEAR(rate.linear.*axis, bias.linear.*axis, 1e-14);
  }
}
TEST(ToolSlopes, OfAWrenchInWorldAxesAreDifferences) {
  const ForceVector<Vector, Vector> wrench{{0.5, -0.25, 0.75}, {3, -2, 5}};
  const auto slope = wrench_slope(jacobian<Mixed>(q), wrench);
  for (int j = 0; j < 6; ++j) {
    Values one{};
    one[j] = 1.0;
    for (int i = 0; i < 6; ++i) {
      const auto effort = [&](const Values& at) { return transpose_times(jacobian<Mixed>(at), wrench)[i]; };
      EXPECT_NEAR(slope(i, j), slope_along(one, effort), 1e-9) << i << " by " << j;
    }
  }
}
