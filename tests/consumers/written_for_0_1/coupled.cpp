// Joints that share drives: a belt past an elbow and a differential wrist, in values of their drives.
#include <axial/axial.hpp>

#include <cmath>

struct Arm {
  static constexpr auto chain = axial::chain(
      axial::gravity(0, 0, -9.81),
      axial::revolute().alpha_deg(90).mass(2).com(0.2, 0, 0).inertia_com(0.003, 0.02, 0.02).rotor_inertia(2e-5, 80),
      axial::revolute()
          .a(0.4)
          .mass(1)
          .com(0.1, 0, 0)
          .inertia_com(0.001, 0.01, 0.01)
          .rotor_inertia(1e-5, 80)
          .driven_by(0, -1.0),
      axial::revolute().a(0.3).mass(0.4).com(0.03, 0, 0).inertia_com(3e-4, 4e-4, 4e-4).rotor_inertia(4e-6, 30),
      axial::revolute().alpha_deg(90).mass(0.2).com(0, 0, 0.05).inertia_com(2e-4, 2e-4, 1e-4).rotor_inertia(4e-6, 30),
      axial::differential());
};

int main() {
  const axial::Joints<Arm, float> u{0.3F, 0.2F, 0.5F, 0.1F}, ud{1.0F, 0.0F, 0.0F, 0.0F}, udd{};
  const auto tau = axial::inverse_dynamics<Arm>(u, ud, udd);
  const auto acc = axial::forward_dynamics<Arm>(u, ud, tau);
  const auto q = axial::joint_positions<Arm>(u);
  const auto qd = axial::joint_rates<Arm>(ud);
  bool right = acc.status.ok() && std::fabs(q[1] - (u[1] - u[0])) < 1e-6F && std::fabs(qd[1] + 1.0F) < 1e-6F;
  for (int k = 0; k < axial::joint_count<Arm>; ++k)
    right = right && std::fabs(acc[k]) < 1e-2F;
  return right ? 0 : 1;
}
