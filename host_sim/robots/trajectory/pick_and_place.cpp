#include <host_sim/robots/trajectory/pick_and_place.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace host_sim {

namespace {

/// Limits of the path parameter: those of the joint that needs longest.
PathLimits path_limits(const std::vector<double>& from, const std::vector<double>& to,
                       const std::vector<JointLimits>& limits, const Cycle& cycle) {
  constexpr double none = std::numeric_limits<double>::infinity();
  PathLimits path{none, none, none};
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double way = std::abs(to[i] - from[i]);
    path.speed = std::min(path.speed, cycle.utilisation * limits[i].speed / way);
    path.acceleration = std::min(path.acceleration, cycle.utilisation * limits[i].acceleration / way);
  }
  path.jerk = path.acceleration / cycle.jerk_time;
  return path;
}

void check_limits(const Cycle& cycle, const std::vector<JointLimits>& limits) {
  for (std::size_t i = 0; i < limits.size(); ++i)
    if (!std::isfinite(limits[i].speed) || !std::isfinite(limits[i].acceleration))
      throw std::runtime_error("joint " + std::to_string(i + 1) + " of " + cycle.robot +
                               " declares no speed or acceleration limit to plan a trajectory with");
}

void check_way_point(const WayPoint& point, const std::vector<JointLimits>& limits) {
  const std::string where = "way-point '" + point.name + "'";
  if (point.q.size() != limits.size())
    throw std::runtime_error(where + " has " + std::to_string(point.q.size()) + " joints, the robot has " +
                             std::to_string(limits.size()));
  for (std::size_t i = 0; i < limits.size(); ++i)
    if (!(point.q[i] >= limits[i].position_min && point.q[i] <= limits[i].position_max))
      throw std::runtime_error(where + ": joint " + std::to_string(i + 1) + " is outside its position limits");
}

void check_way_points(const Cycle& cycle, const std::vector<JointLimits>& limits) {
  if (cycle.way_points.size() < 2) throw std::runtime_error("a cycle needs at least two way-points");
  for (const WayPoint& point : cycle.way_points)
    check_way_point(point, limits);
  for (std::size_t i = 1; i < cycle.way_points.size(); ++i)
    if (cycle.way_points[i].q == cycle.way_points[i - 1].q)
      throw std::runtime_error("way-point '" + cycle.way_points[i].name +
                               "' repeats the one before; give that a dwell");
}

/// Appends the set-points of a time span; each span begins on the tick after the last, so every way-point is met
/// exactly.
template <class State>
void append(Trajectory& trajectory, double duration, double tick, State state) {
  const std::size_t begin = trajectory.size();
  for (std::size_t i = 0; static_cast<double>(i) * tick < duration; ++i) {
    trajectory.push_back(state(static_cast<double>(i) * tick));
    trajectory.back().time = static_cast<double>(begin + i) * tick;
  }
}

SetPoint at_rest(const WayPoint& point, bool smooth) {
  const std::vector<double> zero(point.q.size(), 0.0), more(smooth ? point.q.size() : 0, 0.0);
  return {0.0, point.q, zero, zero, more, more};
}

std::variant<SCurve, SmoothCurve> time_law(const PathLimits& limits, bool smooth) {
  if (smooth) return SmoothCurve(limits);
  return SCurve(limits);
}

}  // namespace

Move::Move(const std::vector<double>& from, const std::vector<double>& to, const std::vector<JointLimits>& limits,
           const Cycle& cycle)
    : from_(from), to_(to), time_law_(time_law(path_limits(from, to, limits, cycle), cycle.smooth)) {}

double Move::duration() const {
  return std::visit([](const auto& law) { return law.duration(); }, time_law_);
}

SetPoint Move::at(double time) const {
  const PathState path = std::visit([&](const auto& law) { return law.at(time); }, time_law_);
  const bool smooth = std::holds_alternative<SmoothCurve>(time_law_);
  SetPoint point;
  point.time = time;
  for (std::size_t i = 0; i < from_.size(); ++i) {
    const double way = to_[i] - from_[i];
    point.q.push_back(path.s < 0.5 ? from_[i] + way * path.s : to_[i] - way * (1.0 - path.s));
    point.qd.push_back(way * path.speed);
    point.qdd.push_back(way * path.acceleration);
    if (smooth) point.q3.push_back(way * path.jerk), point.q4.push_back(way * path.snap);
  }
  return point;
}

Trajectory plan(const Cycle& cycle, const std::vector<JointLimits>& limits) {
  check_limits(cycle, limits);
  check_way_points(cycle, limits);
  Trajectory trajectory;
  const auto rest = [&](const WayPoint& point, double duration) {
    append(trajectory, duration, cycle.tick, [&](double) { return at_rest(point, cycle.smooth); });
  };
  for (std::size_t i = 0; i + 1 < cycle.way_points.size(); ++i) {
    const WayPoint &here = cycle.way_points[i], &next = cycle.way_points[i + 1];
    rest(here, here.dwell);
    const Move move(here.q, next.q, limits, cycle);
    append(trajectory, move.duration(), cycle.tick, [&](double time) { return move.at(time); });
  }
  rest(cycle.way_points.back(), std::max(cycle.way_points.back().dwell, cycle.tick));
  return trajectory;
}

Trajectory plan_of_drives(Cycle cycle, std::vector<JointLimits> drives, const std::vector<JointLimits>& joints,
                          const std::function<std::vector<double>(const std::vector<double>&)>& positions) {
  constexpr double most = 1e9;  // a second, or its square: where a joint has no limit of its own
  const std::size_t count = drives.size();
  for (WayPoint& point : cycle.way_points) {
    if (point.q.size() != count)
      throw std::runtime_error("way-point '" + point.name + "': give the position of each of the " +
                               std::to_string(count) + " drives");
    const auto q = positions(point.q);
    point.q.insert(point.q.end(), q.begin(), q.end());
  }
  for (const JointLimits& p : joints)
    drives.push_back({p.position_min, p.position_max, std::min(p.speed, most), std::min(p.acceleration, most)});
  Trajectory trajectory = plan(cycle, drives);
  for (SetPoint& point : trajectory)
    for (auto* values : {&point.q, &point.qd, &point.qdd})
      values->resize(count);
  return trajectory;
}

}  // namespace host_sim
