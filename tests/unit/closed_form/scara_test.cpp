#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/scalar/counting.hpp>
#include <random>
#include <robots/scara.hpp>

using namespace axial;

namespace {

// Everything that the closed form allows at once: axis 2 against axis 1, offsets, rotors, arms of unequal sense.
struct Twisted {
  static constexpr auto chain = axial::chain(gravity(0, 0, -9.81),
                                             revolute()
                                                 .alpha_deg(180)
                                                 .d(0.4)
                                                 .theta_deg(90)
                                                 .mass(3)
                                                 .com(0.2, 0, 0.05)
                                                 .inertia_com(0.01, 0.05, 0.06)
                                                 .rotor_inertia(1e-4, 80),
                                             revolute()
                                                 .a(0.35)
                                                 .alpha_deg(180)
                                                 .theta(0.3)
                                                 .mass(2)
                                                 .com(0.12, 0, -0.03)
                                                 .inertia_com(0.01, 0.03, 0.04)
                                                 .rotor_inertia(2e-5, 50),
                                             prismatic()
                                                 .a(0.3)
                                                 .alpha_deg(180)
                                                 .theta_deg(180)
                                                 .d(0.1)
                                                 .mass(1.2)
                                                 .com(0.04, 0, -0.1)
                                                 .inertia_com(0.004, 0.005, 0.002)
                                                 .rotor_inertia(1e-5, 60));
};

template <class S, class T, class F>
void for_random_states(const F& f) {
  std::mt19937 engine(7);
  const auto random = [&](double size) {
    return static_cast<T>(size * (static_cast<double>(engine()) / 2147483648.0 - 1.0));
  };
  for (int i = 0; i < 500; ++i) {
    const Joints<robot_of<S>, T> q{random(3), random(3), random(1)}, qd{random(5), random(5), random(2)},
        qdd{random(20), random(20), random(10)};
    f(q, qd, qdd);
  }
}

template <class S>
void expect_equals_rnea() {
  for_random_states<S, double>([](const auto& q, const auto& qd, const auto& qdd) {
    const auto closed = closed_form::scara_torque<S>(q, qd, qdd), rnea = inverse_dynamics<S>(q, qd, qdd);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(closed[i], rnea[i], 1e-12) << i;
  });
}

}  // namespace

TEST(Scara, ClosedFormEqualsRnea) {
  expect_equals_rnea<robots::Scara>();
  expect_equals_rnea<Twisted>();
  expect_equals_rnea<Scene<Twisted, Gravity>>();
  expect_equals_rnea<Scene<Twisted, RotorInertia>>();
}

TEST(Scara, SeparatedTermsSumToTheTorque) {
  for_random_states<Twisted, double>([](const auto& q, const auto& qd, const auto& qdd) {
    const auto s = closed_form::scara<Twisted>(q);
    const auto tau = closed_form::scara_torque<Twisted>(q, qd, qdd);
    const double products[] = {qd[0] * qd[1], qd[0] * qd[2], qd[1] * qd[2]};
    for (int i = 0; i < 3; ++i) {
      double sum = s.G[i];
      for (int j = 0; j < 3; ++j)
        sum += s.A[i][j] * qdd[j] + s.B[i][j] * products[j] + s.C[i][j] * qd[j] * qd[j];
      EXPECT_NEAR(sum, tau[i], 1e-12) << i;
    }
  });
}

TEST(Scara, AIsTheMassMatrixAndGTheGravityTorque) {
  for_random_states<Twisted, double>([](const auto& q, const auto&, const auto&) {
    const auto s = closed_form::scara<Twisted>(q);
    const auto m = mass_matrix<Twisted>(q);
    const auto g = gravity_torque<Twisted>(q);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(s.G[i], g[i], 1e-12);
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(s.A[i][j], m(i, j), 1e-13);
    }
  });
}

// With Christoffel symbols from B and C, dA/dt - 2 C(q, qd) is skew-symmetric.
TEST(Scara, RateOfAMinusTwiceCIsSkew) {
  for_random_states<Twisted, double>([](const auto& q, const auto& qd, const auto&) {
    constexpr double h = 1e-6;
    auto ahead = q, behind = q;
    for (int i = 0; i < 3; ++i)
      ahead[i] += h * qd[i], behind[i] -= h * qd[i];
    const auto s = closed_form::scara<Twisted>(q), plus = closed_form::scara<Twisted>(ahead),
               minus = closed_form::scara<Twisted>(behind);
    constexpr int pair[3][3] = {{-1, 0, 1}, {0, -1, 2}, {1, 2, -1}};
    double skew[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        double coriolis = s.C[i][j] * qd[j];
        for (int k = 0; k < 3; ++k)
          if (k != j) coriolis += 0.5 * s.B[i][pair[j][k]] * qd[k];
        skew[i][j] = (plus.A[i][j] - minus.A[i][j]) / (2 * h) - 2 * coriolis;
      }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(skew[i][j], -skew[j][i], 1e-8);
  });
}

TEST(Scara, TorqueCostsNoMoreThanThePaper) {
  static Trace trace;
  Joints<robots::Scara, Counting> q{}, qd{}, qdd{};
  for (auto* values : {&q, &qd, &qdd})
    for (auto& x : values->values)
      x = Counting(trace);
  const auto tau = closed_form::scara_torque<robots::Scara>(q, qd, qdd);
  for (const auto& x : tau.values)
    x.need();
  EXPECT_EQ(trace.operations(), (Operations{11, 10, 0, 1}));  // 13M 10A can be read off the paper
}
