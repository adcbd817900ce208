// Numbers in braces give what joint values of the same numbers give.
#include "joint_values.hpp"

namespace {

using namespace every_kernel;

TEST(Braces, EveryKernelTakesThem) {
  expect_same(axial::inverse_dynamics<R>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F}),
              axial::inverse_dynamics<R>(joints, rates, loads));
  expect_same(axial::gravity_torque<R>({0.4F, -0.7F, 0.06F}), axial::gravity_torque<R>(joints));
  expect_same(axial::bias_torque<R>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}), axial::bias_torque<R>(joints, rates));
  expect_same(axial::forward_dynamics<R>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F}),
              axial::forward_dynamics<R>(joints, rates, loads));
  EXPECT_EQ((axial::joint_torque<R, 1>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F})),
            (axial::joint_torque<R, 1>(joints, rates, loads)));
  EXPECT_EQ((axial::gravity_torque<R, 2>({0.4F, -0.7F, 0.06F})), (axial::gravity_torque<R, 2>(joints)));
  EXPECT_EQ(axial::mass_matrix<R>({0.4F, -0.7F, 0.06F})(0, 1), axial::mass_matrix<R>(joints)(0, 1));
  EXPECT_EQ(axial::forward_kinematics<R>({0.4F, -0.7F, 0.06F}).tool.position.x,
            axial::forward_kinematics<R>(joints).tool.position.x);
  EXPECT_EQ(axial::jacobian<R>({0.4F, -0.7F, 0.06F})[1].linear.x, axial::jacobian<R>(joints)[1].linear.x);
  EXPECT_EQ(axial::separate<R>({0.4F, -0.7F, 0.06F}).A[0][1], axial::separate<R>(joints).A[0][1]);
  expect_same(axial::momentum_terms<R>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}).momentum,
              axial::momentum_terms<R>(joints, rates).momentum);
}

TEST(Braces, DerivativesTakeThem) {
  EXPECT_EQ(axial::inverse_dynamics_derivatives<R>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, loads).dtau_dq(0, 1),
            axial::inverse_dynamics_derivatives<R>(joints, rates, loads).dtau_dq(0, 1));
  EXPECT_EQ(axial::forward_dynamics_derivatives<R>(joints, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F}).dqdd_dq(0, 1),
            axial::forward_dynamics_derivatives<R>(joints, rates, loads).dqdd_dq(0, 1));
  const auto y = axial::torque_regressor<R>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F});
  EXPECT_EQ(y(0, 1, axial::InertialParameter::mass),
            axial::torque_regressor<R>(joints, rates, loads)(0, 1, axial::InertialParameter::mass));
  expect_same(axial::torque_rates<R>({0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, loads, {0.0F, 1.0F, 2.0F}).taud,
              axial::torque_rates<R>(joints, rates, loads, Q{0.0F, 1.0F, 2.0F}).taud);
  expect_same(axial::torque_rates<R>(joints, {1.1F, -0.3F, 0.2F}, loads, joints, {0.0F, 1.0F, 2.0F}).taudd,
              axial::torque_rates<R>(joints, rates, loads, joints, Q{0.0F, 1.0F, 2.0F}).taudd);
}

TEST(Braces, ElasticFeedforwardOfOneJointTakesThem) {
  const axial::Joints<Elastic, float> x{0.3F};
  using S = axial::Scene<Elastic, axial::Gravity, axial::RotorInertia, axial::ElasticJoints>;
  EXPECT_EQ(axial::elastic_feedforward<S>({0.3F}, {0.3F}, {0.3F}, {0.3F}, {0.3F}).tau_m[0],
            axial::elastic_feedforward<S>(x, x, x, x, x).tau_m[0]);
}

TEST(Braces, KernelsOverAModelTakeThem) {
  using M = axial::Model<3, axial::Gravity>;
  M model;
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(model.add(axial::revolute().a(0.3 * i).mass(1.0 + i).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01)));
  model.set_gravity(0.0, -9.81, 0.0);
  const axial::Joints<M, float> x{0.4F, -0.7F, 0.06F}, xd{1.1F, -0.3F, 0.2F}, y{2.0F, -1.0F, 9.0F};
  expect_same(axial::inverse_dynamics(model, {0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F}),
              axial::inverse_dynamics(model, x, xd, y));
  expect_same(axial::gravity_torque(model, {0.4F, -0.7F, 0.06F}), axial::gravity_torque(model, x));
  expect_same(axial::bias_torque(model, {0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}), axial::bias_torque(model, x, xd));
  expect_same(axial::forward_dynamics(model, {0.4F, -0.7F, 0.06F}, {1.1F, -0.3F, 0.2F}, {2.0F, -1.0F, 9.0F}),
              axial::forward_dynamics(model, x, xd, y));
  EXPECT_EQ(axial::mass_matrix(model, {0.4F, -0.7F, 0.06F})(0, 1), axial::mass_matrix(model, x)(0, 1));
  EXPECT_EQ(axial::jacobian(model, {0.4F, -0.7F, 0.06F})[1].linear.x, axial::jacobian(model, x)[1].linear.x);
  EXPECT_EQ(axial::forward_dynamics_derivatives(model, {0.4F, -0.7F, 0.06F}, xd, y).dqdd_dq(0, 1),
            axial::forward_dynamics_derivatives(model, x, xd, y).dqdd_dq(0, 1));
}

TEST(Braces, MixWithJointValuesArraysAndInputs) {
  using Scene = axial::Scene<R, axial::RuntimeGravity>;
  axial::Inputs<Scene, float> in{};
  in.gravity = {0.5F, 0.0F, -9.0F};
  const float qd[3] = {1.1F, -0.3F, 0.2F};
  expect_same(axial::inverse_dynamics<Scene>({0.4F, -0.7F, 0.06F}, qd, loads, in),
              axial::inverse_dynamics<Scene>(joints, rates, loads, in));
}

// Constants that float holds near enough, whole numbers too; a scalar that is named is that of all braces.
TEST(Braces, AreOfFloatUnlessAnotherScalarIsNamed) {
  const auto of_float = axial::gravity_torque<R>({0.4F, 1, 0});
  static_assert(std::is_same_v<decltype(of_float), const axial::Efforts<R, float>>);
  expect_same(of_float, axial::gravity_torque<R>(Q{0.4F, 1.0F, 0.0F}));
  const auto of_double = axial::gravity_torque<R, double>({0.4, -0.7, 0.06});
  static_assert(std::is_same_v<decltype(of_double), const axial::Efforts<R, double>>);
}

TEST(Braces, ControlStepAndChecksTakeThem) {
  axial::FeedforwardState<R, double> of_braces{}, of_joints{};
  const axial::Joints<R, double> x{0.4, -0.7, 0.06}, xd{0.1, -0.3, 0.2}, still{0.1, 0.1, 0.1};
  const auto ours = axial::feedforward<R>(of_braces, {0.4, -0.7, 0.06}, {0.1, -0.3, 0.2}, {0.1, 0.1, 0.1});
  const auto theirs = axial::feedforward<R>(of_joints, x, xd, still);
  ASSERT_TRUE(theirs.status.ok());
  EXPECT_TRUE(ours.status.ok());
  expect_same(ours.tau, theirs.tau);
  EXPECT_EQ(axial::check_position<R>({0.4F, -0.7F, 1e9F}).joint, 2);
  EXPECT_EQ(axial::check_request<R>({0.4F, -0.7F, 0.06F}, {0, 0, 0}, {0, 1e9F, 0}).joint, 1);
  expect_same(axial::clamped_request<R>({0.4F, -0.7F, 1e9F}, rates, loads).q,
              axial::clamped_request<R>(Q{0.4F, -0.7F, 1e9F}, rates, loads).q);
}

}  // namespace
