#include <host_sim/loop/cycle.hpp>
#include <host_sim/simulation/models.hpp>
#include <host_sim/trajectory/files.hpp>

namespace host_sim::loop {

Trajectory cycle_of(const std::string& robot) {
  std::vector<JointLimits> limits;
  for (const auto& p : simulation::robot_links(robot))
    limits.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  return load_trajectory(AXIAL_ROOT "/host_sim/trajectories/" + robot + ".json", robot, limits);
}

}  // namespace host_sim::loop
