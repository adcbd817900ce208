#include <host_sim/robots/robot.hpp>

#include <oracle/from_axial.hpp>
#include <oracle/recursive.hpp>
#include <robots/robots.hpp>

#include <stdexcept>

namespace host_sim {

namespace {

using oracle::quad;

template <class Type>
Robot described() {
  Robot robot{Type::name, {}, oracle::of_robot<quad, Type>()};
  for (const axial::LinkParameters& p : Type::chain.links)
    robot.limits.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  return robot;
}

oracle::Vector<quad> widened(const std::vector<double>& values) { return {values.begin(), values.end()}; }

}  // namespace

std::vector<std::string> robot_names() {
  std::vector<std::string> names;
  robots::for_each([&](auto robot) { names.push_back(robot.name); });
  return names;
}

Robot find_robot(const std::string& name) {
  Robot found;
  if (robots::visit_named(name.c_str(), [&](auto robot) { found = described<typename decltype(robot)::Robot>(); }))
    return found;
  std::string all;
  for (const std::string& known : robot_names())
    all += (all.empty() ? "" : ", ") + known;
  throw std::runtime_error("unknown robot '" + name + "'; there are: " + all);
}

std::vector<double> exact_torque(const Robot& robot, const SetPoint& point) {
  std::vector<double> torque;
  for (const quad& value :
       oracle::recursive_inverse_dynamics(robot.chain, widened(point.q), widened(point.qd), widened(point.qdd)))
    torque.push_back(static_cast<double>(value));
  return torque;
}

}  // namespace host_sim
