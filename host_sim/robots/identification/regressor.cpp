#include <host_sim/robots/identification/regressor.hpp>

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

description::Description without_drives(description::Description robot) {
  for (description::Link& link : robot.links) {
    link.parameters.drives = {};
    link.parameters.static_friction = 0.0;
  }
  return robot;
}

}  // namespace

Regressor::Regressor(const description::Description& robot)
    : links_(robot.size()),
      g_(description::drive_matrix(robot)),
      tree_(description::to_model<Joints>(without_drives(known_part(robot)))),
      known_(description::to_model<Drives>(known_part(robot))) {}

Regressor::JointValues Regressor::of_joints(const double* values, bool positions) const {
  JointValues q{};
  for (int i = 0; i < links_; ++i) {
    q[i] = positions ? g_.offset[i] : 0.0;
    for (int k = 0; k < g_.drives; ++k)
      if (g_.is_moved(i, k)) q[i] += g_.ratio[i][k] * values[k];
  }
  return q;
}

void Regressor::evaluate(const double* q, const double* qd, const double* qdd, double* out) const {
  DriveValues position{}, speed{}, acceleration{};
  for (int k = 0; k < g_.drives; ++k)
    position[k] = q[k], speed[k] = qd[k], acceleration[k] = qdd[k];
  const DriveValues known = axial::inverse_dynamics(known_, position, speed, acceleration);
  const auto y = axial::torque_regressor(tree_, of_joints(q, true), of_joints(qd, false), of_joints(qdd, false));
  const auto links = known_.links<double>();
  for (int k = 0; k < g_.drives; ++k) {
    for (int link = 0; link < links_; ++link) {
      for (int p = 0; p < inertial_parameters; ++p) {
        double felt = 0.0;
        for (int i = 0; i < links_; ++i)
          if (g_.is_moved(i, k)) felt += g_.ratio[i][k] * y(i, inertial_parameters * link + p);
        *out++ = felt;
      }
      const auto drive = links.drives().link(k);
      for (const double of_drive :
           {acceleration[k], speed[k], axial::regressor::coulomb_column(drive, speed[k], axial::One{}, axial::Zero{}),
            axial::regressor::coulomb_column(drive, speed[k], axial::Zero{}, axial::One{})})
        *out++ = g_.owner[k] == link ? of_drive : 0.0;
    }
    *out++ = known[k];
  }
}

}  // namespace host_sim::identification
