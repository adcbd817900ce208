#include <host_sim/robots/robots/robot.hpp>

#include <host_sim/robots/robots/driven_robot.hpp>
#include <robots/robots.hpp>

#include <cmath>
#include <stdexcept>

namespace host_sim {

namespace {

using oracle::quad;

JointLimits limits_of(const axial::LinkParameters& p) {
  return {p.position_min, p.position_max, p.speed_limit, p.acceleration_limit};
}

/// Whether a value is metres: that of a slide, or of a drive that moves its own slide one to one. A drive of a screw
/// turns.
template <class Type>
bool moves_in_metres(int k) {
  if constexpr (Type::chain.shares_drives()) {
    constexpr auto& g = axial::detail::drive_matrix<Type>;
    const int owner = g.owner[k];
    return Type::chain.links[owner].type == axial::JointType::prismatic && std::abs(g.ratio[owner][k]) == 1.0;
  } else {
    return Type::chain.links[k].type == axial::JointType::prismatic;
  }
}

template <class Type>
Robot described() {
  Robot robot{Type::name, {}, {}, oracle::of_robot<quad, Type>(), driven_robot<quad, Type>()};
  for (const axial::LinkParameters& p : DrivesOf<Type>::chain.links)
    robot.limits.push_back(limits_of(p));
  for (std::size_t k = 0; k < robot.limits.size(); ++k)
    robot.slides.push_back(moves_in_metres<Type>(static_cast<int>(k)));
  if (Type::chain.shares_drives())
    for (const axial::LinkParameters& p : Type::chain.links)
      robot.moved.push_back(limits_of(p));
  return robot;
}

oracle::Vector<quad> widened(const std::vector<double>& values) { return {values.begin(), values.end()}; }
std::vector<double> rounded(const oracle::Vector<quad>& values) {
  std::vector<double> all;
  for (const quad& value : values)
    all.push_back(static_cast<double>(value));
  return all;
}

}  // namespace

std::vector<std::string> robot_names() {
  std::vector<std::string> names;
  robots::for_each([&](auto robot) { names.push_back(robot.name); });
  return names;
}

std::vector<std::string> driven_robot_names() {
  std::vector<std::string> names;
  robots::SharedDrives::for_each([&](auto robot) { names.push_back(robot.name); });
  return names;
}

Robot find_robot(const std::string& name) {
  Robot found;
  const auto take = [&](auto robot) {
    if (name == robot.name) found = described<typename decltype(robot)::Robot>();
  };
  robots::All::for_each(take);
  robots::SharedDrives::for_each(take);
  if (found.joints() > 0) return found;
  std::string all;
  for (const auto& names : {robot_names(), driven_robot_names()})
    for (const std::string& known : names)
      all += (all.empty() ? "" : ", ") + known;
  throw std::runtime_error("unknown robot '" + name + "'; there are: " + all);
}

std::vector<double> exact_torque(const Robot& robot, const SetPoint& point) {
  return rounded(robot.driven.inverse_dynamics(widened(point.q), widened(point.qd), widened(point.qdd)));
}

std::vector<double> joint_positions(const Robot& robot, const std::vector<double>& q) {
  return rounded(robot.driven.positions(widened(q)));
}

}  // namespace host_sim
