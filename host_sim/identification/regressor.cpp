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

Regressor::Regressor(const description::Description& robot) : joints_(robot.size()) {
  const description::Description known = known_part(robot);
  known_ = description::to_model<Model>(known);
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    for (int p = 0; p < parameters_per_link; ++p) {
      description::Description one = known;
      one.links[i].parameters = unit_link(robot.links[i].parameters, p);
      units_.push_back(description::to_model<Model>(one));
    }
}

Regressor::Values Regressor::values(const double* numbers) const {
  Values values{};
  for (int i = 0; i < joints_; ++i)
    values[i] = numbers[i];
  return values;
}

void Regressor::evaluate(const double* q, const double* qd, const double* qdd, double* out) const {
  const Values position = values(q), speed = values(qd), acceleration = values(qdd);
  const Values known = axial::inverse_dynamics(known_, position, speed, acceleration);
  const int width = columns() + 1;
  for (int column = 0; column < columns(); ++column) {
    const Values torque =
        axial::inverse_dynamics(units_[static_cast<std::size_t>(column)], position, speed, acceleration);
    for (int i = 0; i < joints_; ++i)
      out[i * width + column] = torque[i] - known[i];
  }
  for (int i = 0; i < joints_; ++i) {
    separate_first_moments(out + i * width);
    out[i * width + columns()] = known[i];
  }
}

// A point mass at 1 m on x has the moments of inertia yy and zz besides: unit_link() says so.
void Regressor::separate_first_moments(double* row) const {
  for (int link = 0; link < joints_; ++link) {
    double* const p = row + link * parameters_per_link;
    p[1] -= p[0] + p[5] + p[6];
    p[2] -= p[0] + p[4] + p[6];
    p[3] -= p[0] + p[4] + p[5];
  }
}

}  // namespace host_sim::identification
