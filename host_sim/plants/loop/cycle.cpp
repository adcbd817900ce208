#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/simulation/models.hpp>
#include <host_sim/robots/trajectory/files.hpp>

#include <algorithm>
#include <stdexcept>

namespace host_sim::loop {

namespace {

// Effort limits that allow the declared accelerations without rotors allow half of them with rotors as heavy as the
// links.
constexpr double share_of_acceleration = 0.5;

const std::string folder = AXIAL_ROOT "/host_sim/robots/trajectories/";

Trajectory cycle_of_drives(const std::string& robot, const Cycle& cycle) {
  using Values = axial::Joints<simulation::DrivenModel, double>;
  const auto parameters = simulation::robot_links(robot);
  const auto model = simulation::driven_model(robot);
  const auto links = model.links<double>();
  axial::LinkParameters all[12] = {};
  std::copy(parameters.begin(), parameters.end(), all);
  const auto g = axial::drive_matrix_of(all);
  std::vector<JointLimits> drives, joints;
  for (int k = 0; k < model.size(); ++k) {
    const auto p = axial::detail::drive_by_itself(all[g.owner[k]], g.is_alone(g.owner[k]));
    drives.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  }
  for (const auto& p : parameters)
    joints.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  return plan_of_drives(cycle, drives, joints, [&](const std::vector<double>& position) {
    Values u{};
    std::copy(position.begin(), position.end(), u.values);
    const auto q = links.positions(u);
    return std::vector<double>(q.values, q.values + model.link_count());
  });
}

}  // namespace

Trajectory cycle_of(const std::string& robot, bool smooth) {
  const bool shares = simulation::shares_drives(robot);
  const std::string path = folder + (shares ? "shared_drives/" : "") + robot + ".json";
  if (shares) {
    if (smooth) throw std::runtime_error("joints of '" + robot + "' share drives, and none of them is elastic");
    return cycle_of_drives(robot, read_cycle(path));
  }
  std::vector<JointLimits> limits;
  for (const auto& p : simulation::robot_links(robot))
    limits.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  if (!smooth) return load_trajectory(path, robot, limits);
  Cycle cycle = read_cycle(path);
  cycle.smooth = true;
  cycle.utilisation *= share_of_acceleration;
  return plan(cycle, limits);
}

}  // namespace host_sim::loop
