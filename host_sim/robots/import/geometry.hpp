// Lines and frames in extended precision: what a conversion to MDH frames is made of.
#pragma once

#include <axial/robot/chain.hpp>

#include <Eigen/Dense>

namespace importer {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;

/// A rigid displacement.
struct Pose {
  Matrix rotation = Matrix::Identity();
  Vector position = Vector::Zero();

  Pose operator*(const Pose& right) const { return {rotation * right.rotation, rotation * right.position + position}; }
  Pose inverse() const { return {rotation.transpose(), -(rotation.transpose() * position)}; }
};

/// A joint's axis: a point and a unit direction.
struct Line {
  Vector point = Vector::Zero(), direction = Vector::UnitZ();
};

/// The common normal of two lines: its feet and its direction, a unit vector across both.
struct Normal {
  Vector first_foot, second_foot, direction;
};

/// The common normal nearest to a preferred foot on the first line and a preferred unit direction across it: these are
/// taken where lines are parallel (to 1e-13) and where they meet; elsewhere the sign is the preferred direction's.
Normal common_normal(const Line& first, const Line& second, const Vector& foot, const Vector& direction);

/// Angle about a unit axis that turns one unit vector across it into another, in (-pi, pi].
Real angle_about(const Vector& axis, const Vector& from, const Vector& to);

/// The frame with this origin, x and z.
Pose frame(const Vector& origin, const Vector& x, const Vector& z);

/// The shortest decimal within `noise` of a value, where ten digits are enough for it; else the nearest double.
double near_decimal(Real value, Real noise);
/// The same for metres, where noise is 2e-15; 0 below 1e-14, which is rounding.
double rounded(Real value);
/// An angle, in degrees or radians of few digits where one is within 2e-15 rad of it.
axial::Angle near_angle(Real radians);
axial::FixedPose rounded(const Pose& pose);

/// The nearest rotation to nine entries in double.
Matrix orthonormal(const double* rows);

}  // namespace importer
