// The main job: a feed-forward that a loop can trust, and what its status says.
#include "arm.hpp"

#include <cmath>
#include <cstring>

int main() {
  const axial::Joints<Arm, float> q{0.3F, -0.5F, 0.1F}, qd{1.0F, 0.5F, 0.2F}, qdd{2.0F, 0.0F, 1.0F};
  const auto tau = axial::inverse_dynamics<Arm>(q, qd, qdd);
  const auto acc = axial::forward_dynamics<Arm>(q, qd, tau);
  const axial::MassMatrix<Arm, float> m = axial::mass_matrix<Arm>(q);
  const auto c = axial::bias_torque<Arm>(q, qd), g = axial::gravity_torque<Arm>(q);
  bool right = acc.status.ok() && m(0, 1) == m(1, 0) && std::isfinite(c[0]) && g[1] == axial::gravity_torque<Arm>(q)[1];
  for (int i = 0; i < axial::joint_count<Arm>; ++i)
    right = right && std::fabs(acc[i] - qdd[i]) < 1e-3F;

  axial::FeedforwardState<Arm, float> state{};
  const auto safe = axial::feedforward<Arm>(state, q, qd, qdd);
  const auto refused = axial::feedforward<Arm>(state, q, axial::Joints<Arm, float>{9.0F, 0.0F, 0.0F}, qdd);
  right = right && safe.status.ok() && safe.tau[0] == tau[0];
  right = right && refused.status.code == axial::Status::Code::speed_limit && refused.status.joint == 0 &&
          refused.tau[0] == tau[0];
  right = right && std::strlen(axial::status_text(refused.status)) > 0;

  const auto frames = axial::forward_kinematics<Arm>(q);
  const auto jacobian = axial::jacobian<Arm>(q);
  const auto held = axial::transpose_times(jacobian, {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 10.0F}});
  return right && frames.status.ok() && std::isfinite(frames.tool.position.z) && std::isfinite(held[2]) ? 0 : 1;
}
