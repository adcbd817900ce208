// A jerk-limited move from 0 to 1: the time law that every joint of a move shares.
#pragma once

namespace host_sim {

/// Bounds of the path parameter s: its speed in 1/s, acceleration in 1/s^2, jerk in 1/s^3; all > 0.
struct PathLimits {
  double speed = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

/// Path parameter and its derivatives by time.
struct PathState {
  double s = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0, snap = 0.0;  ///< the third and fourth, of a SmoothCurve alone
};

/// The fastest rest-to-rest double S profile from s = 0 to s = 1 inside the limits: seven segments of constant jerk
/// (+ 0 - 0 - 0 +), of which some may be empty. Position, speed and acceleration are continuous.
/// Source: L. Biagiotti, C. Melchiorri, Trajectory Planning for Automatic Machines and Robots, Springer 2008,
/// section 3.4.
class SCurve {
 public:
  explicit SCurve(const PathLimits& limits);

  /// Seconds from start to standstill.
  double duration() const { return 2.0 * ramp_ + cruise_; }
  /// State at a time; before the start it rests at 0, after the end at 1, exactly.
  PathState at(double time) const;

 private:
  PathState first_half(double time) const;

  double jerk_ = 0.0;       // of the path parameter, 1/s^3
  double jerk_time_ = 0.0;  // length of a segment with jerk
  double ramp_ = 0.0;       // from rest to cruising speed
  double cruise_ = 0.0;     // at constant speed
};

}  // namespace host_sim
