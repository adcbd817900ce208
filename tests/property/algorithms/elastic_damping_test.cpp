// Feed-forward through damped transmissions: closed form of a joint whose torque is a cubic, the equations of the
// model, and the limits without damping and without elasticity.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/elastic/elastic_damping.hpp>
#include <cmath>
#include <robots/puma560.hpp>

using namespace axial;

namespace {

constexpr double inertia = 2.0 * 0.25, K = 640.0, B = 0.75, period = 1e-3;
struct Wheel {  // about the vertical: tau_l = I qdd
  static constexpr auto chain =
      axial::chain(gravity(0, 0, -9.8125), revolute().mass(2.0).com(0.5, 0, 0).rotor_inertia(B).stiffness(K));
};
constexpr double power(int exponent) { return static_cast<double>(1ULL << static_cast<unsigned>(exponent)); }
template <class R, int exponent>
struct Sprung {
  static constexpr auto chain = [] {
    auto chain = R::chain;
    for (auto& link : chain.links)
      link.stiffness = power(exponent);
    return chain;
  }();
};

template <class R, class T>
Joints<R, T> all(double value) {
  Joints<R, T> result{};
  for (int i = 0; i < R::chain.size; ++i)
    result[i] = static_cast<T>(value * (1.0 + 0.25 * i));
  return result;
}
template <class R, class T>
auto moved(ElasticState<R, T>& state, double t) {  // q = sin t
  return elastic_feedforward<R>(state, all<R, T>(std::sin(t)), all<R, T>(std::cos(t)), all<R, T>(-std::sin(t)),
                                all<R, T>(-std::cos(t)), all<R, T>(std::sin(t)));
}
template <class R, class T>
auto undamped(double t) {
  return elastic_feedforward<R>(all<R, T>(std::sin(t)), all<R, T>(std::cos(t)), all<R, T>(-std::sin(t)),
                                all<R, T>(-std::cos(t)), all<R, T>(std::sin(t)));
}

/// q = t^5 / 60 of the wheel, from rest on.
auto wheel(ElasticState<Wheel, double>& state, double t) {
  using V = Joints<Wheel, double>;
  return elastic_feedforward<Wheel>(state, V{std::pow(t, 5) / 60}, V{std::pow(t, 4) / 12}, V{t * t * t / 3}, V{t * t},
                                    V{2 * t});
}

}  // namespace

// d + r d' = y of the cubic y = c t^3 has d = c (t^3 - 3 r t^2 + 6 r^2 t - 6 r^3 (1 - e^(-t/r))), from rest on. Lags of
// nothing, of a part of a period, of many.
TEST(ElasticDamping, IsTheClosedFormOfACubicTorque) {
  for (const double r : {0.0, 1e-6, 1e-4, 1e-3, 2e-2, 5.0}) {
    SCOPED_TRACE(r);
    ElasticState<Wheel, double> state(period, {r * K});
    const double c = inertia / 3.0 / K;
    for (int k = 0; k <= 500; ++k) {
      const double t = k * period, e = r > 0.0 ? std::exp(-t / r) : 0.0;
      const auto motor = wheel(state, t);
      const double d = c * (t * t * t - 3 * r * t * t + 6 * r * r * t - 6 * r * r * r * (1 - e));
      const double dd = c * (3 * t * t - 6 * r * t + 6 * r * r * (1 - e)), ddd = c * (6 * t - 6 * r * (1 - e));
      const double scale = c * (1.0 + 6 * r + 6 * r * r);
      ASSERT_NEAR(motor.theta[0] - std::pow(t, 5) / 60, d, 1e-13 * scale * (1.0 + r)) << k;
      ASSERT_NEAR(motor.thetad[0] - std::pow(t, 4) / 12, dd, 1e-13 * scale) << k;
      ASSERT_NEAR(motor.tau_m[0], inertia * t * t * t / 3 + B * (t * t * t / 3 + ddd), 1e-12) << k;
    }
  }
}

TEST(ElasticDamping, SpringAndDamperCarryTheLinksTorque) {
  using Arm = Sprung<robots::Puma560, 11>;
  const Joints<Arm, double> damping = all<Arm, double>(8.0);
  ElasticState<Arm, double> state(period, damping);
  for (int k = 0; k < 200; ++k) {
    const auto motor = moved(state, k * period);
    for (int i = 0; i < 6; ++i) {
      const double q = all<Arm, double>(std::sin(k * period))[i], qd = all<Arm, double>(std::cos(k * period))[i];
      EXPECT_NEAR(2048.0 * (motor.theta[i] - q) + damping[i] * (motor.thetad[i] - qd), motor.tau_l[i], 1e-10);
    }
  }
}

TEST(ElasticDamping, NoneIsTheFunctionWithoutAState) {
  using Arm = Sprung<robots::Puma560, 11>;
  ElasticState<Arm, float> state(period, {});
  for (int k = 0; k < 50; ++k) {
    const auto with = moved(state, k * period), without = undamped<Arm, float>(k * period);
    for (int i = 0; i < 6; ++i) {
      EXPECT_EQ(with.tau_m[i], without.tau_m[i]);
      EXPECT_EQ(with.theta[i], without.theta[i]);
      EXPECT_EQ(with.thetad[i], without.thetad[i]);
    }
  }
}

template <int exponent>
void expect_nearly_rigid() {
  using Arm = Sprung<robots::Puma560, exponent>;
  ElasticState<Arm, float> state(period, all<Arm, double>(8.0));
  for (int k = 0; k < 20; ++k) {
    const double t = k * period;
    const auto motor = moved(state, t);
    const auto q = all<Arm, float>(std::sin(t));
    const auto rigid = inverse_dynamics<Arm>(q, all<Arm, float>(std::cos(t)), all<Arm, float>(-std::sin(t)));
    for (int i = 0; i < 6; ++i) {
      const double bound = 4e3 / power(exponent);  // efforts and their rates over K
      EXPECT_NEAR(motor.tau_m[i], rigid[i], 100.0 * bound + 1e-4) << exponent;
      EXPECT_NEAR(motor.theta[i], q[i], bound + 1e-6) << exponent;
    }
  }
}
TEST(ElasticDamping, TendsToRigidJointsOver40BinaryOrders) {
  expect_nearly_rigid<12>();
  expect_nearly_rigid<22>();
  expect_nearly_rigid<32>();
  expect_nearly_rigid<42>();
  expect_nearly_rigid<52>();
}

TEST(ElasticDamping, ANumberThatIsNoneDoesNotStay) {
  ElasticState<Wheel, double> state(period, {5.0}), clean = state;
  for (int k = 0; k < 10; ++k) {
    if (k == 5) {
      EXPECT_TRUE(std::isnan(wheel(state, std::nan("")).tau_m[0]));
    }
    EXPECT_EQ(wheel(state, k * period).tau_m[0], wheel(clean, k * period).tau_m[0]);
  }
}
