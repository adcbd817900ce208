// What holds a robot still, part by part: linear in gravity's three components and in the mass at the tool.
#pragma once

#include <host_sim/robots/description/description.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/model.hpp>

#include <array>

namespace host_sim::commissioning {

/// tau = sum_k g_k (bare_k + mass mass_k) + spring, k = x y z, of every joint, or of every drive that joints share:
/// positions are the drives' then, q = G u + q0, and efforts G^T those of the joints.
class GravityParts {
 public:
  static constexpr int most_joints = 16;
  static constexpr int parts = 7;  ///< bare x y z, mass x y z, spring
  using Model = axial::Model<most_joints, axial::Gravity, axial::JointSprings>;

  /// `at`: where the mass is, in the tool's axes. Throws description::Refused for more than most_joints.
  GravityParts(const description::Description& robot, const std::array<double, 3>& at);

  /// Joints, or drives that they share.
  int values() const { return drives_.drives; }
  /// Writes values() times `parts` numbers, N m or N (by m/s^2, and by kg).
  void evaluate(const double* q, double* out) const;

 private:
  int joints_;
  axial::DriveMatrix<description::most_links> drives_;  ///< each joint its own, where they share none
  std::array<Model, parts> models_;
};

}  // namespace host_sim::commissioning
