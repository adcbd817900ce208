#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/poses.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace description {
namespace {

axial::Angle angle(double value, bool degrees) {
  return degrees ? axial::Angle::from_degrees(value) : canonical_angle(value);
}

using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

}  // namespace

void set_rotation(axial::FixedPose& pose, double roll, double pitch, double yaw, bool degrees) {
  const auto x = angle(roll, degrees), y = angle(pitch, degrees), z = angle(yaw, degrees);
  Rotation Rx, Ry, Rz;
  Rx << 1, 0, 0, 0, x.cos, -x.sin, 0, x.sin, x.cos;
  Ry << y.cos, 0, y.sin, 0, 1, 0, -y.sin, 0, y.cos;
  Rz << z.cos, -z.sin, 0, z.sin, z.cos, 0, 0, 0, 1;
  Eigen::Map<Rotation>(pose.rotation) = Rz * Ry * Rx + Rotation::Zero();
}

bool is_rotation(const axial::FixedPose& pose) {
  const Eigen::Map<const Rotation> R(pose.rotation);
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!R.allFinite() || !std::all_of(pose.position, pose.position + 3, finite)) return false;
  return (R * R.transpose() - Rotation::Identity()).cwiseAbs().maxCoeff() < 1e-6 && R.determinant() > 0.0;
}

}  // namespace description
