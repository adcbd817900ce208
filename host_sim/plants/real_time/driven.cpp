#include <host_sim/plants/real_time/driven.hpp>
#include <host_sim/robots/trajectory/files.hpp>

namespace host_sim::real_time {

Course course_of(const std::string& robot, const std::vector<axial::LinkParameters>& links, int ticks) {
  std::vector<JointLimits> limits;
  for (const auto& p : links)
    limits.push_back({p.position_min, p.position_max, p.speed_limit, p.acceleration_limit});
  const auto points = load_trajectory(AXIAL_ROOT "/host_sim/robots/trajectories/" + robot + ".json", robot, limits);
  Course course;
  for (int k = 0; k < ticks; ++k) {
    const SetPoint& point = points[static_cast<std::size_t>(k)];
    course.q.push_back(point.q), course.qd.push_back(point.qd), course.qdd.push_back(point.qdd);
  }
  return course;
}

}  // namespace host_sim::real_time
