// A cycle of jerk-limited moves in joint space through way-points, as a pick-and-place robot runs it.
#pragma once

#include <host_sim/robots/trajectory/set_point.hpp>
#include <host_sim/robots/trajectory/smooth_curve.hpp>

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace host_sim {

/// A posture where the robot comes to rest, and for how long it stays.
struct WayPoint {
  std::string name;
  std::vector<double> q;  ///< rad or m
  double dwell = 0.0;     ///< s
};

/// A cycle as its file describes it.
struct Cycle {
  std::string robot;
  double tick = 0.001;       ///< s between set-points
  double jerk_time = 0.05;   ///< s from zero to full acceleration
  double utilisation = 1.0;  ///< share of the speed and acceleration limits that is used, 0 to 1
  std::vector<WayPoint> way_points;
  bool smooth = false;  ///< moves with four continuous derivatives, which set-points then hold
};

/// All joints start and stop together on a straight line in joint space. Every joint stays inside its speed and
/// acceleration limits, and one of them is at its limit.
class Move {
 public:
  Move(const std::vector<double>& from, const std::vector<double>& to, const std::vector<JointLimits>& limits,
       const Cycle& cycle);

  double duration() const;
  SetPoint at(double time) const;

 private:
  std::vector<double> from_, to_;
  std::variant<SCurve, SmoothCurve> time_law_;
};

/// Set-points of the whole cycle, from rest at the first way-point to rest at the last.
/// Throws std::runtime_error when a way-point lies outside the joints' limits or a joint declares none.
Trajectory plan(const Cycle& cycle, const std::vector<JointLimits>& limits);

/// A cycle of drives that joints share: way-points and set-points are the drives', which keep their limits; so do the
/// joints, which stand at `positions` of them and are linear in them.
Trajectory plan_of_drives(Cycle cycle, std::vector<JointLimits> drives, const std::vector<JointLimits>& joints,
                          const std::function<std::vector<double>(const std::vector<double>&)>& positions);

}  // namespace host_sim
