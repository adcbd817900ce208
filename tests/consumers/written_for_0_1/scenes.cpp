// Scenes: what a robot carries, stands on and rubs against; derivatives, separated terms, operations, integrators.
#include "arm.hpp"

#include <axial/cost.hpp>
#include <axial/simulation/integrators.hpp>

#include <cmath>

using Loaded =
    axial::Scene<Arm, axial::Gravity, axial::RotorInertia, axial::Friction, axial::Payload, axial::TipWrench>;
using Tilted = axial::Scene<Arm, axial::RuntimeGravity, axial::RotorInertia>;
using Small = axial::Scene<Arm, axial::Gravity, axial::RotorInertia, axial::Looped>;

static_assert(axial::cost<Arm>(axial::algorithm::inverse_dynamics).mul > 0);

int main() {
  const axial::Joints<Arm, double> q{0.3, -0.5, 0.1}, qd{1.0, 0.5, 0.2}, qdd{2.0, 0.0, 1.0};
  axial::Inputs<Loaded, double> load{};
  load.payload.mass = 1.5;
  load.payload.com = {0.0, 0.0, 0.1};
  load.tip_wrench.force.z = 4.0;
  axial::Inputs<Tilted, double> tilt{};
  tilt.gravity = {0.0, -9.81, 0.0};
  const auto loaded = axial::inverse_dynamics<Loaded>(q, qd, qdd, load);
  const auto tilted = axial::inverse_dynamics<Tilted>(q, qd, qdd, tilt);
  const auto plain = axial::inverse_dynamics<Arm>(q, qd, qdd);
  const auto looped = axial::inverse_dynamics<Small>(q, qd, qdd);
  const auto slopes = axial::inverse_dynamics_derivatives<Arm>(q, qd, qdd);
  const auto separated = axial::separate<Arm>(q);
  const auto again = axial::torque<Arm>(separated, qd, qdd);
  bool right = loaded[2] != plain[2] && tilted[1] != plain[1] && separated.status.ok();
  for (int i = 0; i < 3; ++i)
    right = right && std::fabs(looped[i] - plain[i]) < 1e-9 && std::fabs(again[i] - plain[i]) < 1e-9 &&
            std::isfinite(slopes.dtau_dq(i, i));
  return right ? 0 : 1;
}
