// Against closed forms: two point masses on a planar arm, and a bead that slides on a turning rod.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>

using namespace axial;

namespace {

constexpr double g = 9.8125, m1 = 2.0, m2 = 1.5, l1 = 0.5, l2 = 0.75, rotor = 0.0625;

struct Planar {  // in a vertical plane, y upwards
  static constexpr auto chain = axial::chain(gravity(0, -g, 0), revolute().mass(m1).com(l1, 0, 0),
                                             revolute().a(l1).mass(m2).com(l2, 0, 0).rotor_inertia(rotor, 2));
};
struct Bead {  // joint 2 points along the rod that joint 1 turns, in a vertical plane
  static constexpr auto chain = axial::chain(gravity(0, 0, -g), revolute().alpha_deg(90).rotor_inertia(rotor),
                                             prismatic().alpha_deg(90).mass(m2));
};

template <class S>
void expect_two_masses() {
  const double q1 = 0.4, q2 = -1.1, w1 = 0.7, w2 = -0.9;
  const auto t = momentum_terms<S>(Joints<Planar, double>{q1, q2}, Joints<Planar, double>{w1, w2});
  const double c = m2 * l1 * l2 * std::cos(q2), s = m2 * l1 * l2 * std::sin(q2);
  const double m22 = m2 * l2 * l2, m12 = m22 + c, m11 = m1 * l1 * l1 + m2 * l1 * l1 + m22 + 2 * c;
  const double g2 = m2 * g * l2 * std::cos(q1 + q2), g1 = (m1 + m2) * g * l1 * std::cos(q1) + g2;
  EXPECT_NEAR(t.momentum[0], m11 * w1 + m12 * w2, 1e-14);
  EXPECT_NEAR(t.momentum[1], m12 * w1 + (m22 + 4 * rotor) * w2, 1e-14);
  EXPECT_NEAR(t.drift[0], -g1, 1e-13) << "nothing depends on the first angle but gravity";
  EXPECT_NEAR(t.drift[1], -s * w1 * (w1 + w2) - g2, 1e-13) << "half of qd^T dM/dq2 qd";
}

}  // namespace

TEST(MomentumTerms, OfTwoMassesAreTheClosedForm) { expect_two_masses<Planar>(); }
TEST(MomentumTerms, OfTwoMassesInTheLoopedFormToo) {
  expect_two_masses<Scene<Planar, Gravity, RotorInertia, Looped>>();
}

TEST(MomentumTerms, OfABeadOnATurningRodAreTheClosedForm) {
  const double q = 0.4, r = 0.6, w = 1.25, v = -0.5;
  const auto t = momentum_terms<Bead>(Joints<Bead, double>{q, r}, Joints<Bead, double>{w, v});
  // Rod and bead hang at angle q from where the first MDH axis points; gravity's share is that of inverse dynamics.
  const auto hold = gravity_torque<Bead>(Joints<Bead, double>{q, r});
  EXPECT_NEAR(t.momentum[0], (m2 * r * r + rotor) * w, 1e-14);
  EXPECT_NEAR(t.momentum[1], m2 * v, 1e-14);
  EXPECT_NEAR(t.drift[0], -hold[0], 1e-13);
  EXPECT_NEAR(t.drift[1], m2 * r * w * w - hold[1], 1e-13) << "the centrifugal force";
  EXPECT_NEAR(std::hypot(hold[0] / r, hold[1]), m2 * g, 1e-13);
}
