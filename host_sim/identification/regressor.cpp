#include <host_sim/identification/regressor.hpp>

#include <string>

namespace host_sim::identification {

namespace {

description::Description known_part(description::Description robot) {
  if (robot.size() > Regressor::most_joints)
    throw description::Refused(robot.name + " has " + std::to_string(robot.size()) + " joints; identification takes " +
                               std::to_string(Regressor::most_joints) + " at most");
  for (description::Link& link : robot.links)
    link.parameters = without_parameters(link.parameters);
  return robot;
}

}  // namespace

Regressor::Regressor(const description::Description& robot)
    : joints_(robot.size()), known_(description::to_model<Model>(known_part(robot))) {}

Regressor::Values Regressor::values(const double* numbers) const {
  Values values{};
  for (int i = 0; i < joints_; ++i)
    values[i] = numbers[i];
  return values;
}

void Regressor::evaluate(const double* q, const double* qd, const double* qdd, double* out) const {
  const Values position = values(q), speed = values(qd), acceleration = values(qdd);
  const Values known = axial::inverse_dynamics(known_, position, speed, acceleration);
  const auto y = axial::torque_regressor(known_, position, speed, acceleration);
  for (int i = 0; i < joints_; ++i) {
    for (int k = 0; k < joints_; ++k) {
      for (int p = 0; p < inertial_parameters; ++p)
        *out++ = y(i, inertial_parameters * k + p);
      for (const double of_drive : {y.rotor[k], y.viscous[k], y.coulomb_forward[k], y.coulomb_backward[k]})
        *out++ = k == i ? of_drive : 0.0;
    }
    *out++ = known[i];
  }
}

}  // namespace host_sim::identification
