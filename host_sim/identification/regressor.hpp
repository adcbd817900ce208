// Joint torque as a linear function of the standard parameters.
#pragma once

#include <host_sim/description/description.hpp>
#include <host_sim/identification/parameters.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/links/model.hpp>

#include <vector>

namespace host_sim::identification {

/// tau = Y(q, qd, qdd) theta + known(q, qd): Y has parameters_per_link columns a link, each the library's own inverse
/// dynamics of an arm of which one parameter is 1 and all others are 0; `known` is what springs and static friction
/// of the description add. Exact to rounding: torque is linear in theta.
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
  void separate_first_moments(double* row) const;

  int joints_;
  Model known_;
  std::vector<Model> units_;
};

}  // namespace host_sim::identification
