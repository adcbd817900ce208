// Torque of joints, or of the drives that they share, as a linear function of the standard parameters.
#pragma once

#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/identification/parameters.hpp>

#include <axial/derivatives/torque_regressor.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/model.hpp>
#include <axial/transmissions/shared_drives.hpp>

namespace host_sim::identification {

/// tau = Y(q, qd, qdd) theta + known(q, qd): Y has parameters_per_link columns a link, those of the library's
/// torque_regressor(); `known` is what springs and static friction of the description add. Where joints share drives,
/// q = G u + q0, states and torques are those of the drives: tau_u = G^T Y(G u + q0, G ud, G udd) theta, with rotor and
/// friction of each drive in the columns of the link that owns it.
class Regressor {
 public:
  static constexpr int most_joints = 16;

  /// Throws description::Refused for more than most_joints joints.
  explicit Regressor(const description::Description& robot);

  int drives() const { return g_.drives; }  ///< rows of Y: joints, or the drives that they share
  int columns() const { return links_ * parameters_per_link; }
  /// Writes [Y, known], row by row, drives() times columns() + 1 numbers; q, qd, qdd hold drives() numbers each.
  void evaluate(const double* q, const double* qd, const double* qdd, double* out) const;

 private:
  using Joints = axial::Model<most_joints, axial::Gravity, axial::RotorInertia>;
  using Drives = axial::Model<most_joints, axial::Gravity, axial::RotorInertia, axial::Friction, axial::JointSprings,
                              axial::SharedDrives>;
  using JointValues = axial::Joints<Joints, double>;
  using DriveValues = axial::Joints<Drives, double>;

  JointValues of_joints(const double* values, bool positions) const;

  int links_;
  axial::DriveMatrix<description::most_links> g_;
  Joints tree_;   // without what is identified, and without drives
  Drives known_;  // without what is identified
};

}  // namespace host_sim::identification
