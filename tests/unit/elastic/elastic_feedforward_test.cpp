// Feed-forward of elastic joints: closed form of a pendulum, the rigid limit, and what it answers to no number.
#include <gtest/gtest.h>
#include <axial/batch.hpp>
#include <cmath>
#include <robots/puma560.hpp>

using namespace axial;

namespace {

constexpr double g = 9.8125, m = 2.0, l = 0.5, K = 640.0, B = 0.75, viscous = 1.5;

struct Pendulum {  // a point mass, x along the arm, y upwards
  static constexpr auto chain = axial::chain(
      gravity(0, -g, 0), revolute().mass(m).com(l, 0, 0).rotor_inertia(B / 2500, 50).viscous(viscous).stiffness(K));
};
struct HalfRigid {
  static constexpr auto chain = axial::chain(gravity(0, -g, 0), revolute().mass(1).com(0.5, 0, 0),
                                             revolute().a(0.5).mass(1).com(0.25, 0, 0).stiffness(100));
};
template <class T>
using State = Joints<Pendulum, T>;
constexpr double q = 0.4, qd = 1.25, qdd = -2.5, q3 = 6.0, q4 = -20.0;

struct Torque {  // of the link, with its rates
  double tau = m * l * l * qdd + m * g * l * std::cos(q);
  double taud = m * l * l * q3 - m * g * l * std::sin(q) * qd;
  double taudd = m * l * l * q4 - m * g * l * (std::cos(q) * qd * qd + std::sin(q) * qdd);
};
template <class S, class T = double>
auto of_pendulum() {
  return elastic_feedforward<S>(State<T>{T(q)}, State<T>{T(qd)}, State<T>{T(qdd)}, State<T>{T(q3)}, State<T>{T(q4)});
}

// A Puma 560 whose joints are all as stiff as Exponent says: K = 1e3 2^Exponent.
template <int Exponent>
struct Stiff {
  static constexpr auto chain = [] {
    auto chain = robots::Puma560::chain;
    for (auto& link : chain.links)
      link.stiffness = 1e3 * static_cast<double>(1LL << Exponent);
    return chain;
  }();
};
// Largest differences from what rigid joints need: position in rad times K, so that it is a torque; torque in N m.
template <class T, int Exponent>
void expect_rigid_limit() {
  using R = Stiff<Exponent>;
  const Joints<R, T> at{T(0.3), T(-0.8), T(0.5), T(1.2), T(-0.4), T(0.9)},
      v{T(1.0), T(-0.5), T(0.75), T(-2.0), T(1.5), T(0.25)}, a{T(2.0), T(1.0), T(-3.0), T(4.0), T(0.5), T(-1.0)},
      j{T(9.0), T(-7.0), T(5.0), T(3.0), T(-8.0), T(6.0)}, s{T(50), T(-40), T(30), T(-20), T(10), T(60)};
  const auto elastic = elastic_feedforward<R>(at, v, a, j, s);
  const auto rigid = inverse_dynamics<R>(at, v, a);
  const auto rates = torque_rates<Scene<R, Gravity>>(at, v, a, j, s);
  const T eps = std::numeric_limits<T>::epsilon(), c = T(1e-3) / T(1LL << Exponent);
  for (int i = 0; i < 6; ++i) {
    const T inertia = T(R::chain.links[i].rotor_inertia * R::chain.links[i].gear * R::chain.links[i].gear);
    EXPECT_NEAR(elastic.theta[i], at[i] + c * rates.tau[i], 2 * eps * std::abs(at[i])) << Exponent << ", " << i;
    EXPECT_NEAR(elastic.thetad[i], v[i] + c * rates.taud[i], 2 * eps * std::abs(v[i])) << Exponent << ", " << i;
    EXPECT_NEAR(elastic.tau_m[i], rigid[i] + inertia * c * rates.taudd[i], 16 * eps * std::abs(rigid[1]))
        << Exponent << ", " << i;
  }
}
template <class T, int... Exponent>
void expect_rigid_limits(std::integer_sequence<int, Exponent...>) {
  (expect_rigid_limit<T, 4 * Exponent>(), ...);
}

}  // namespace

TEST(ElasticFeedforward, OfAPendulumIsTheClosedForm) {
  const Torque link;
  const auto motor = of_pendulum<Pendulum>();
  EXPECT_NEAR(motor.tau_l[0], link.tau, 1e-14);
  EXPECT_NEAR(motor.theta[0], q + link.tau / K, 1e-15);
  EXPECT_NEAR(motor.thetad[0], qd + link.taud / K, 1e-15);
  EXPECT_NEAR(motor.tau_m[0], B * (qdd + link.taudd / K) + link.tau, 1e-14);
}
TEST(ElasticFeedforward, NamedScenesHoldWhatTheyName) {
  const Torque link;
  EXPECT_NEAR((of_pendulum<Scene<Pendulum, Gravity, ElasticJoints>>().tau_m[0]), link.tau, 1e-14) << "no rotor";
  const auto rubbed = of_pendulum<Scene<Pendulum, Gravity, Friction, ElasticJoints>>();
  EXPECT_NEAR(rubbed.tau_l[0], link.tau, 1e-14) << "friction is the motor's";
  EXPECT_NEAR(rubbed.tau_m[0], link.tau + viscous * rubbed.thetad[0], 1e-14) << "at the motor's speed";
  const auto floating = of_pendulum<Scene<Pendulum, ElasticJoints>>();
  EXPECT_NEAR(floating.tau_l[0], m * l * l * qdd, 1e-15) << "no gravity";
}
TEST(ElasticFeedforward, TendsToRigidJointsOverFortyBinaryOrders) {
  expect_rigid_limits<double>(std::make_integer_sequence<int, 11>{});
  expect_rigid_limits<float>(std::make_integer_sequence<int, 11>{});
}
TEST(ElasticFeedforward, AJointWithoutStiffnessIsRigid) {
  const Joints<HalfRigid, double> x{0.5, 0.25};
  const auto motor = elastic_feedforward<HalfRigid>(x, x, x, x, x);
  EXPECT_EQ(motor.theta[0], 0.5);
  EXPECT_EQ(motor.thetad[0], 0.5);
  EXPECT_EQ(motor.theta[1], 0.25 + motor.tau_l[1] / 100);
}
TEST(ElasticFeedforward, WhatIsNoNumberIsSeen) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const State<double> fine{0.5}, none{nan};
  const auto check = [](const auto& r) { return check_finite(r.tau_m, r.theta, r.thetad, r.tau_l); };
  EXPECT_TRUE(check(elastic_feedforward<Pendulum>(fine, fine, fine, fine, fine)).ok());
  EXPECT_EQ(check(elastic_feedforward<Pendulum>(none, fine, fine, fine, fine)).code, Status::Code::not_finite);
  EXPECT_EQ(check(elastic_feedforward<Pendulum>(fine, none, fine, fine, fine)).code, Status::Code::not_finite);
  EXPECT_EQ(check(elastic_feedforward<Pendulum>(fine, fine, none, fine, fine)).code, Status::Code::not_finite);
  EXPECT_EQ(check(elastic_feedforward<Pendulum>(fine, fine, fine, none, fine)).code, Status::Code::not_finite);
  EXPECT_EQ(check(elastic_feedforward<Pendulum>(fine, fine, fine, fine, none)).code, Status::Code::not_finite);
}
TEST(ElasticFeedforward, ABatchHasWhatEachOfItsStatesHas) {
  using V = Batch<double, 2>;
  const auto lanes = [](double first, double second) {
    return State<V>{V::of([&](int lane) { return lane == 0 ? first : second; })};
  };
  const auto both =
      elastic_feedforward<Pendulum>(lanes(q, -1.0), lanes(qd, 0.5), lanes(qdd, 2.0), lanes(q3, 3.0), lanes(q4, 4.0));
  const auto other = elastic_feedforward<Pendulum>(State<double>{-1.0}, State<double>{0.5}, State<double>{2.0},
                                                   State<double>{3.0}, State<double>{4.0});
  EXPECT_NEAR(both.tau_m[0][0], of_pendulum<Pendulum>().tau_m[0], 1e-13);
  EXPECT_NEAR(both.tau_m[0][1], other.tau_m[0], 1e-13);
  EXPECT_NEAR(both.theta[0][1], other.theta[0], 1e-15);
}
TEST(ElasticFeedforward, IsAConstantOfConstantsToo) {
  constexpr State<double> x{0.5};
  constexpr auto motor = elastic_feedforward<Pendulum>(x, x, x, x, x);
  static_assert(motor.tau_l[0] > 0.0);
}
