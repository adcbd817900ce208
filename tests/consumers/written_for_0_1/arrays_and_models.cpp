// Arrays, braces, and a robot that is known at run time.
#include "arm.hpp"

#include <cmath>

int main() {
  const float q[3] = {0.3F, -0.5F, 0.1F}, qd[3] = {1.0F, 0.5F, 0.2F}, qdd[3] = {2.0F, 0.0F, 1.0F};
  const auto from_arrays = axial::inverse_dynamics<Arm>(q, qd, qdd);
  const auto from_braces = axial::inverse_dynamics<Arm>({0.3F, -0.5F, 0.1F}, {1.0F, 0.5F, 0.2F}, {2.0F, 0.0F, 1.0F});

  axial::Model<4> model;
  bool taken = true;
  for (const axial::LinkParameters& link : Arm::chain.links)
    taken = taken && model.add(link);
  model.set_gravity(0.0, 0.0, -9.81);
  const axial::Joints<axial::Model<4>, float> at{0.3F, -0.5F, 0.1F}, rates{1.0F, 0.5F, 0.2F},
      accelerations{2.0F, 0.0F, 1.0F};
  const auto of_model = axial::inverse_dynamics(model, at, rates, accelerations);
  bool right = taken && model.size() == 3;
  for (int i = 0; i < 3; ++i)
    right = right && from_arrays[i] == from_braces[i] && std::fabs(of_model[i] - from_arrays[i]) < 1e-3F;
  return right ? 0 : 1;
}
