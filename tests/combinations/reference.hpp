// What every combination is compared with: one run-time model in double that knows every feature, compiled once.
#pragma once

#include <axial/links/model.hpp>
#include <axial/spatial/pose.hpp>

namespace combinations {

constexpr int most_joints = 4;

/// A robot with what a scene puts on it, and one state; SI units, axes as in doc/guides/scenes.md. What a scene does
/// not name is zero, and taken out of the links.
struct Situation {
  int joints = 0;
  axial::LinkParameters links[most_joints];
  axial::FixedPose base, tool;
  axial::Vec3<double> gravity{};
  axial::GivenMotion<double> base_motion{};
  axial::Vec3<double> through_water{};
  axial::ForceVector<axial::Vec3<double>, axial::Vec3<double>> wrenches[most_joints] = {};
  axial::PayloadBody<double> payload{};
  double q[most_joints] = {}, qd[most_joints] = {}, qdd[most_joints] = {};
};

/// One number per joint: rad or m, N m or N, ... as the name of the function says.
struct Numbers {
  double of[most_joints] = {};
  bool near_singular = false;  ///< of forward dynamics
};
/// Frames of the links and of the tool.
struct Poses {
  axial::Pose<axial::Mat3<axial::Vec3<double>>, axial::Vec3<double>> frames[most_joints], tool;
};
/// Columns of the tool's Jacobian: angular, then linear.
struct Columns {
  axial::MotionVector<axial::Vec3<double>, axial::Vec3<double>> of[most_joints];
};

Numbers efforts(const Situation&);                                ///< for q, qd, qdd
Numbers momenta(const Situation&);                                ///< M(q) qd
double inertia(const Situation&, int i, int j);                   ///< M(i, j)
Numbers accelerations(const Situation&, const Numbers& efforts);  ///< of a base that moves as it is told
Poses poses(const Situation&);
Columns jacobian(const Situation&);

}  // namespace combinations
