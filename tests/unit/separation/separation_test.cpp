// Against closed forms: two point masses on a planar arm, and a bead that slides on a turning rod.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>

using namespace axial;

namespace {

constexpr double g = 9.8125, m1 = 2.0, m2 = 1.5, l1 = 0.5, l2 = 0.75;

struct Planar {
  static constexpr auto chain =
      axial::chain(gravity(0, -g, 0), revolute().mass(m1).com(l1, 0, 0), revolute().a(l1).mass(m2).com(l2, 0, 0));
};
struct Bead {
  static constexpr auto chain = axial::chain(revolute(), prismatic().alpha_deg(90).mass(m2));
};

// Every kind of coupling: turns and slides at right and general angles, bodies without symmetry.
struct Crooked {
  static constexpr auto chain = axial::chain(
      gravity(1, 2, -9), revolute().mass(3).com(0.1, 0.2, 0.3).inertia_com(0.5, 0.6, 0.7, 0.1, 0.05, -0.1),
      prismatic().alpha_deg(90).a(0.3).mass(2).com(0.2, -0.1, 0.15).inertia_com(0.3, 0.4, 0.5, 0.1, -0.05, 0.02),
      revolute().alpha(0.5).a(0.2).d(0.1).mass(1.5).com(-0.1, 0.3, 0.2).inertia_com(0.4, 0.3, 0.3, -0.05, 0.05, 0.03),
      revolute().alpha_deg(-90).a(-0.1).mass(1).com(0.1, 0.1, 0.4).inertia_com(0.1, 0.2, 0.15, 0.02, 0.03, 0.01));
};

}  // namespace

TEST(Separated, TermsOfTwoMassesAreTheClosedForm) {
  const double q1 = 0.4, q2 = -1.1;
  const auto t = separate<Planar>(Joints<Planar, double>{q1, q2});
  const double c = m2 * l1 * l2 * std::cos(q2), s = m2 * l1 * l2 * std::sin(q2), m22 = m2 * l2 * l2;
  const double g2 = m2 * g * l2 * std::cos(q1 + q2);
  EXPECT_NEAR(t.A[0][0], (m1 + m2) * l1 * l1 + m22 + 2 * c, 1e-14);
  EXPECT_NEAR(t.A[0][1], m22 + c, 1e-14);
  EXPECT_NEAR(t.A[1][0], m22 + c, 1e-14);
  EXPECT_NEAR(t.A[1][1], m22, 1e-14);
  EXPECT_NEAR(t.B[0][0], -2 * s, 1e-14) << "qd1 qd2 about the first axis";
  EXPECT_EQ(t.B[1][0], 0.0);
  EXPECT_EQ(t.C[0][0], 0.0);
  EXPECT_NEAR(t.C[0][1], -s, 1e-14);
  EXPECT_NEAR(t.C[1][0], s, 1e-14);
  EXPECT_EQ(t.C[1][1], 0.0);
  EXPECT_NEAR(t.G[0], (m1 + m2) * g * l1 * std::cos(q1) + g2, 1e-13);
  EXPECT_NEAR(t.G[1], g2, 1e-13);
}

TEST(Separated, TermsOfABeadOnATurningRodAreTheClosedForm) {
  const double r = 0.6;
  const auto t = separate<Scene<Bead>>(Joints<Bead, double>{0.4, r});
  EXPECT_NEAR(t.A[0][0], m2 * r * r, 1e-14);
  EXPECT_EQ(t.A[0][1], 0.0);
  EXPECT_NEAR(t.A[1][1], m2, 1e-14);
  EXPECT_NEAR(t.B[0][0], 2 * m2 * r, 1e-14) << "Coriolis";
  EXPECT_EQ(t.B[1][0], 0.0);
  EXPECT_NEAR(t.C[1][0], -m2 * r, 1e-14) << "centrifugal";
  EXPECT_EQ(t.C[0][1], 0.0);
}

// A state that is not at rest in one joint alone would hide terms: every pair of joints moves in some state.
TEST(Separated, TermsSumToTheTorque) {
  using J = Joints<Crooked, double>;
  const J q{0.4, 0.25, -1.1, 2.0};
  const auto terms = separate<Crooked>(q);
  for (int i = 0; i < J::size; ++i)
    for (int j = 0; j <= i; ++j) {
      J qd{}, qdd{};
      qd[i] = 1.5, qd[j] = -2.0, qdd[i] = 3.0;
      const auto tau = torque(terms, qd, qdd), exact = inverse_dynamics<Crooked>(q, qd, qdd);
      for (int k = 0; k < J::size; ++k)
        EXPECT_NEAR(tau[k], exact[k], 1e-12) << "joints " << i << " and " << j << " move, effort of joint " << k;
    }
}

// Each kind of coefficient by itself: the others would show most of what is not finite too, but not all of it.
TEST(Separated, EveryKindOfCoefficientIsLookedAt) {
  using Terms = Separated<Crooked, double>;
  const auto judged = [](const auto& give, double value) {
    Terms terms{};
    Soundness<double> all;
    give(Collected<Crooked, double, double, Terms, double>{terms, {all}}, value);
    return all.status().code;
  };
  const auto expect_seen = [&](const auto& give, const char* what) {
    EXPECT_EQ(judged(give, 1.0), Status::Code::ok) << what;
    EXPECT_EQ(judged(give, std::nan("")), Status::Code::not_finite) << what;
  };
  expect_seen([](const auto& terms, double x) { terms.inertia(0, 0, x); }, "A");
  expect_seen([](const auto& terms, double x) { terms.product(0, 0, 1, x); }, "B");
  expect_seen([](const auto& terms, double x) { terms.square(0, 1, x); }, "C");
  expect_seen([](const auto& terms, double x) { terms.rest(0, x); }, "G");
}
