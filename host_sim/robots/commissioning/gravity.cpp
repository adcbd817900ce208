#include <host_sim/robots/commissioning/gravity.hpp>

#include <algorithm>
#include <string>

namespace host_sim::commissioning {

namespace {

using description::Description;

void refuse(const Description& robot) {
  const std::string most = std::to_string(GravityParts::most_joints);
  if (robot.size() > GravityParts::most_joints)
    throw description::Refused(robot.name + " has " + std::to_string(robot.size()) + " joints; commissioning takes " +
                               most + " at most");
}

// The links alone: the drives' matrix is applied to what they make.
Description without_drives(Description robot) {
  for (auto& link : robot.links)
    link.parameters.drives = {};
  return robot;
}

Description without_springs(Description robot) {
  for (auto& link : robot.links)
    link.parameters.spring_stiffness = 0.0;
  return robot;
}

void remove_masses(Description& robot) {
  for (auto& link : robot.links) {
    link.parameters.mass = 0.0;
    std::fill(link.parameters.com, link.parameters.com + 3, 0.0);
    std::fill(link.parameters.inertia_com, link.parameters.inertia_com + 6, 0.0);
  }
}

// One kilogram at the tool, and nothing else.
Description point_mass(Description robot, const std::array<double, 3>& at) {
  remove_masses(robot);
  auto& last = robot.links.back().parameters;
  last.mass = 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    last.com[i] = robot.tool.position[i];
    for (std::size_t k = 0; k < 3; ++k)
      last.com[i] += robot.tool.rotation[3 * i + k] * at[k];
  }
  return robot;
}

GravityParts::Model along(Description robot, std::size_t axis) {
  double g[3] = {};
  if (axis < 3) g[axis] = 1.0;
  robot.gravity = {g[0], g[1], g[2]};
  return description::to_model<GravityParts::Model>(robot);
}

}  // namespace

GravityParts::GravityParts(const Description& given, const std::array<double, 3>& at)
    : joints_(given.size()), drives_(description::drive_matrix(given)) {
  refuse(given);
  const Description robot = without_drives(given);
  Description springs = robot;
  remove_masses(springs);
  for (std::size_t k = 0; k < 3; ++k) {
    models_[k] = along(without_springs(robot), k);
    models_[3 + k] = along(point_mass(without_springs(robot), at), k);
  }
  models_[6] = along(springs, 3);
}

void GravityParts::evaluate(const double* q, double* out) const {
  axial::Joints<Model, double> position{}, rest{};
  for (int i = 0; i < joints_; ++i) {
    position[i] = drives_.offset[i];
    for (int k = 0; k < drives_.drives; ++k)
      position[i] += drives_.ratio[i][k] * q[k];
  }
  for (std::size_t part = 0; part < parts; ++part) {
    const auto effort = axial::inverse_dynamics(models_[part], position, rest, rest);
    for (int k = 0; k < drives_.drives; ++k) {
      double felt = 0.0;
      for (int i = 0; i < joints_; ++i)
        felt += drives_.ratio[i][k] * effort[i];
      out[static_cast<std::size_t>(k) * parts + part] = felt;
    }
  }
}

}  // namespace host_sim::commissioning
