// Torques of the two-link arm, held against Craig's closed form (Introduction to Robotics, section 6.7).
#ifdef AXIAL_SINGLE_HEADER
#include "axial.hpp"
#else
#include <axial/axial.hpp>
#include <robots/planar2r.hpp>
#endif

#include <cmath>
#include <cstdio>

int main() {
  using Arm = robots::Planar2r;
  const double l1 = 0.5, l2 = 0.75, m1 = 4.6, m2 = 2.3, g = 9.81, q1 = 0.5, q2 = -1.25;
  const double wanted = m2 * l2 * g * std::cos(q1 + q2) + (m1 + m2) * l1 * g * std::cos(q1);

  const axial::Joints<Arm, float> q{0.5F, -1.25F};
  const auto tau = axial::gravity_torque<Arm>(q);
  std::printf("torque of the first joint: %.6f N m, Craig's: %.6f N m\n", static_cast<double>(tau[0]), wanted);
  return std::fabs(static_cast<double>(tau[0]) - wanted) < 1e-6 * wanted ? 0 : 1;
}
