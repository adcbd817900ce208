// Eigen sees the library's values in place, and its algebra agrees with the dynamics.
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/eigen.hpp>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <robots/scara.hpp>

namespace {

using robots::Scara;
using Values = axial::Joints<Scara, double>;
constexpr double tolerance = 1e-13;  // some hundred roundings of 2^-53, values of at most 10

const Values q{0.7, -1.1, 0.125}, rest{};

TEST(Eigen, JointsAreTheSameMemory) {
  Values tau{1.0, 2.0, 3.0};
  auto map = axial::as_eigen(tau);
  map *= 2.0;
  EXPECT_EQ(map.data(), &tau[0]);
  EXPECT_EQ(tau[2], 6.0);
  EXPECT_EQ(axial::as_eigen(q).data(), &q[0]);
}

TEST(Eigen, MassMatrixTimesAccelerationIsTorque) {
  const Values qdd{3.0, -2.0, 1.0};
  const auto m = axial::mass_matrix<Scara>(q);
  auto tau = axial::inverse_dynamics<Scara>(q, rest, qdd);
  const auto gravity = axial::gravity_torque<Scara>(q);
  const Eigen::Vector3d inertial = axial::as_eigen(m) * axial::as_eigen(qdd);
  EXPECT_LT((inertial - (axial::as_eigen(tau) - axial::as_eigen(gravity))).cwiseAbs().maxCoeff(), tolerance);
  const Eigen::Matrix3d dense = axial::as_eigen(m);
  EXPECT_EQ(dense, dense.transpose());
  const Eigen::Vector3d back = dense.llt().solve(inertial);
  EXPECT_LT((back - axial::as_eigen(qdd)).cwiseAbs().maxCoeff(), tolerance);
}

TEST(Eigen, RotationIsProperAndInRows) {
  const auto tool = axial::forward_kinematics<Scara>(q).tool;
  const auto rotation = axial::as_eigen(tool.rotation);
  EXPECT_EQ(rotation(0, 1), tool.rotation.x.y);
  EXPECT_EQ(rotation(2, 0), tool.rotation.z.x);
  EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_NEAR(Eigen::Matrix3d(rotation).determinant(), 1.0, tolerance);
  EXPECT_EQ(axial::as_eigen(tool.position).data(), &tool.position.x);
}

// The closed form of the SCARA's reach: x = a1 cos q1 + a2 cos(q1 + q2).
TEST(Eigen, JacobianIsTheDerivativeOfTheToolsPlace) {
  const auto result = axial::jacobian<Scara>(q);
  const auto jacobian = axial::as_eigen(result);
  ASSERT_EQ(jacobian.cols(), 3);
  const double s1 = std::sin(q[0]), s12 = std::sin(q[0] + q[1]);
  EXPECT_NEAR(jacobian(3, 0), -Scara::a1 * s1 - Scara::a2 * s12, tolerance);
  EXPECT_NEAR(jacobian(3, 1), -Scara::a2 * s12, tolerance);
  EXPECT_NEAR(jacobian(2, 1), 1.0, tolerance);
  EXPECT_NEAR(jacobian(5, 2), -1.0, tolerance);
}

}  // namespace
