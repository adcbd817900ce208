// A move from 0 to 1 with four continuous derivatives: the time law of a robot whose joints are elastic.
#pragma once

#include <host_sim/robots/trajectory/s_curve.hpp>

namespace host_sim {

/// The fastest rest-to-rest profile from s = 0 to s = 1 inside the limits whose speed rises, stays and falls along a
/// polynomial of degree 7: v (35 x^4 - 84 x^5 + 70 x^6 - 20 x^7), x from 0 to 1. Its first three derivatives are 0 at
/// both ends, so position to fourth derivative are continuous; the acceleration is at most 35/16 v/t of a ramp of t
/// seconds, the jerk 84/(5 sqrt 5) v/t^2.
/// Source: L. Biagiotti, C. Melchiorri, Trajectory Planning for Automatic Machines and Robots, Springer 2008,
/// section 2.1.7 (polynomials of degree seven).
class SmoothCurve {
 public:
  explicit SmoothCurve(const PathLimits& limits);

  /// Seconds from start to standstill.
  double duration() const { return 2.0 * ramp_ + cruise_; }
  /// State at a time, with all four derivatives; before the start it rests at 0, after the end at 1, exactly.
  PathState at(double time) const;

 private:
  PathState first_half(double time) const;

  double speed_ = 0.0;   // of the cruise, 1/s
  double ramp_ = 0.0;    // s, from rest to that speed
  double cruise_ = 0.0;  // s, at it
};

}  // namespace host_sim
