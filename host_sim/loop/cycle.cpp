#include <host_sim/loop/cycle.hpp>
#include <host_sim/simulation/models.hpp>
#include <host_sim/trajectory/files.hpp>

namespace host_sim::loop {

namespace {

// Effort limits that allow the declared accelerations without rotors allow half of them with rotors as heavy as the
// links.
constexpr double share_of_acceleration = 0.5;

}  // namespace

Trajectory cycle_of(const std::string& robot, bool smooth) {
  std::vector<JointLimits> limits;
  for (const auto& p : simulation::robot_links(robot))
    limits.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  const std::string path = AXIAL_ROOT "/host_sim/trajectories/" + robot + ".json";
  if (!smooth) return load_trajectory(path, robot, limits);
  Cycle cycle = read_cycle(path);
  cycle.smooth = true;
  cycle.utilisation *= share_of_acceleration;
  return plan(cycle, limits);
}

}  // namespace host_sim::loop
