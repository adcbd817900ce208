// Joint torque as a linear function of the standard parameters.
#pragma once

#include <host_sim/description/description.hpp>
#include <host_sim/identification/parameters.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/torque_regressor.hpp>
#include <axial/links/model.hpp>

namespace host_sim::identification {

/// tau = Y(q, qd, qdd) theta + known(q, qd): Y has parameters_per_link columns a link, those of the library's
/// torque_regressor(); `known` is what springs and static friction of the description add.
class Regressor {
 public:
  static constexpr int most_joints = 16;

  /// Throws description::Refused for more than most_joints joints.
  explicit Regressor(const description::Description& robot);

  int joints() const { return joints_; }
  int columns() const { return joints_ * parameters_per_link; }
  /// Writes [Y, known], row by row, joints() times columns() + 1 numbers; q, qd, qdd hold joints() numbers each.
  void evaluate(const double* q, const double* qd, const double* qdd, double* out) const;

 private:
  using Model = axial::Model<most_joints, axial::Gravity, axial::RotorInertia, axial::Friction, axial::JointSprings>;
  using Values = axial::Joints<Model, double>;

  Values values(const double* numbers) const;

  int joints_;
  Model known_;  // without what is identified
};

}  // namespace host_sim::identification
