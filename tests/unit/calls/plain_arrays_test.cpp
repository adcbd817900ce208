// Arrays, std::array and pointers with a length give what joint values of the same numbers give.
#include <array>

#include "joint_values.hpp"

namespace {

using namespace every_kernel;

constexpr float q[3] = {0.4F, -0.7F, 0.06F};
constexpr std::array<float, 3> qd{1.1F, -0.3F, 0.2F};
constexpr float far[5] = {9.0F, 2.0F, -1.0F, 9.0F, 9.0F};
const auto u = axial::pointed<3>(&far[1]);

TEST(PlainArrays, EveryKernelTakesThem) {
  expect_same(axial::inverse_dynamics<R>(q, qd, u), axial::inverse_dynamics<R>(joints, rates, loads));
  expect_same(axial::gravity_torque<R>(q), axial::gravity_torque<R>(joints));
  expect_same(axial::bias_torque<R>(q, qd), axial::bias_torque<R>(joints, rates));
  expect_same(axial::forward_dynamics<R>(q, qd, u), axial::forward_dynamics<R>(joints, rates, loads));
  EXPECT_EQ((axial::joint_torque<R, 1>(q, qd, u)), (axial::joint_torque<R, 1>(joints, rates, loads)));
  EXPECT_EQ((axial::gravity_torque<R, 2>(q)), (axial::gravity_torque<R, 2>(joints)));
  EXPECT_EQ(axial::mass_matrix<R>(q)(0, 1), axial::mass_matrix<R>(joints)(0, 1));
  EXPECT_EQ(axial::forward_kinematics<R>(q).tool.position.x, axial::forward_kinematics<R>(joints).tool.position.x);
  EXPECT_EQ(axial::jacobian<R>(q)[1].linear.x, axial::jacobian<R>(joints)[1].linear.x);
  EXPECT_EQ(axial::separate<R>(q).A[0][1], axial::separate<R>(joints).A[0][1]);
}

TEST(PlainArrays, DerivativesTakeThem) {
  const auto momenta = axial::momentum_terms<R>(q, qd);
  expect_same(momenta.momentum, axial::momentum_terms<R>(joints, rates).momentum);
  const auto inverse = axial::inverse_dynamics_derivatives<R>(q, qd, u);
  EXPECT_EQ(inverse.dtau_dq(0, 1), axial::inverse_dynamics_derivatives<R>(joints, rates, loads).dtau_dq(0, 1));
  const auto forward = axial::forward_dynamics_derivatives<R>(q, qd, u);
  EXPECT_EQ(forward.dqdd_dq(0, 1), axial::forward_dynamics_derivatives<R>(joints, rates, loads).dqdd_dq(0, 1));
  const auto y = axial::torque_regressor<R>(q, qd, u), same = axial::torque_regressor<R>(joints, rates, loads);
  EXPECT_EQ(y(0, 1, axial::InertialParameter::mass), same(0, 1, axial::InertialParameter::mass));
  expect_same(axial::torque_rates<R>(q, qd, u, u).taud, axial::torque_rates<R>(joints, rates, loads, loads).taud);
  expect_same(axial::torque_rates<R>(q, qd, u, u, qd).taudd,
              axial::torque_rates<R>(joints, rates, loads, loads, rates).taudd);
}

TEST(PlainArrays, KernelsOverAModelTakeThem) {
  using M = axial::Model<3, axial::Gravity>;
  M model;
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(model.add(axial::revolute().a(0.3 * i).mass(1.0 + i).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01)));
  model.set_gravity(0.0, -9.81, 0.0);
  const axial::Joints<M, float> x{0.4F, -0.7F, 0.06F}, xd{1.1F, -0.3F, 0.2F}, y{2.0F, -1.0F, 9.0F};
  expect_same(axial::inverse_dynamics(model, q, qd, u), axial::inverse_dynamics(model, x, xd, y));
  expect_same(axial::gravity_torque(model, q), axial::gravity_torque(model, x));
  expect_same(axial::bias_torque(model, q, qd), axial::bias_torque(model, x, xd));
  expect_same(axial::forward_dynamics(model, q, qd, u), axial::forward_dynamics(model, x, xd, y));
  EXPECT_EQ(axial::mass_matrix(model, q)(0, 1), axial::mass_matrix(model, x)(0, 1));
  EXPECT_EQ(axial::forward_kinematics(model, q).tool.position.x, axial::forward_kinematics(model, x).tool.position.x);
  EXPECT_EQ(axial::jacobian(model, q)[1].linear.x, axial::jacobian(model, x)[1].linear.x);
  EXPECT_EQ(axial::separate(model, q).A[0][1], axial::separate(model, x).A[0][1]);
  expect_same(axial::momentum_terms(model, q, qd).momentum, axial::momentum_terms(model, x, xd).momentum);
  EXPECT_EQ(axial::torque_regressor(model, q, qd, u)(0, 1, axial::InertialParameter::mass),
            axial::torque_regressor(model, x, xd, y)(0, 1, axial::InertialParameter::mass));
  EXPECT_EQ(axial::inverse_dynamics_derivatives(model, q, qd, u).dtau_dq(0, 1),
            axial::inverse_dynamics_derivatives(model, x, xd, y).dtau_dq(0, 1));
  EXPECT_EQ(axial::forward_dynamics_derivatives(model, q, qd, u).dqdd_dq(0, 1),
            axial::forward_dynamics_derivatives(model, x, xd, y).dqdd_dq(0, 1));
}

TEST(PlainArrays, ElasticFeedforwardTakesThem) {
  const float x[1] = {0.3F};
  const axial::Joints<Elastic, float> same{0.3F};
  using S = axial::Scene<Elastic, axial::Gravity, axial::RotorInertia, axial::ElasticJoints>;
  EXPECT_EQ(axial::elastic_feedforward<S>(x, x, x, x, x).tau_m[0],
            axial::elastic_feedforward<S>(same, same, same, same, same).tau_m[0]);
}

TEST(PlainArrays, ChecksTakeThem) {
  const float beyond[3] = {0.4F, -0.7F, 1e9F};
  EXPECT_EQ(axial::check_position<R>(beyond).joint, 2);
  EXPECT_TRUE(axial::check_position<R>(q).ok());
  EXPECT_EQ(axial::check_request<R>(q, qd, beyond).joint,
            axial::check_request<R>(joints, rates, Q{0.4F, -0.7F, 1e9F}).joint);
  expect_same(axial::clamped_request<R>(beyond, qd, u).q,
              axial::clamped_request<R>(Q{0.4F, -0.7F, 1e9F}, rates, loads).q);
}

TEST(PlainArrays, MixWithJointValuesAndInputs) {
  using Scene = axial::Scene<R, axial::RuntimeGravity>;
  axial::Inputs<Scene, float> in{};
  in.gravity = {0.5F, 0.0F, -9.0F};
  expect_same(axial::inverse_dynamics<Scene>(q, rates, loads, in),
              axial::inverse_dynamics<Scene>(joints, rates, loads, in));
}

TEST(PlainArrays, AreOfDoubleToo) {
  const double values[3] = {0.4, -0.7, 0.06};
  const axial::Joints<R, double> same{0.4, -0.7, 0.06};
  static_assert(std::is_same_v<decltype(axial::gravity_torque<R>(values)), axial::Efforts<R, double>>);
  expect_same(axial::gravity_torque<R>(values), axial::gravity_torque<R>(same));
}

TEST(PlainArrays, StandBesideValuesThatSayWhatTheyAre) {
  const axial::JointPositions<R> said{0.4F, -0.7F, 0.06F};
  expect_same(axial::bias_torque<R>(said, qd), axial::bias_torque<R>(axial::Joints<R, float>(said), rates));
}

TEST(PlainArrays, ControlStepTakesThem) {
  axial::FeedforwardState<R, float> of_arrays{}, of_joints{};
  const Q still{0.1F, 0.1F, 0.1F};
  const auto ours = axial::feedforward<R>(of_arrays, q, qd, still),
             theirs = axial::feedforward<R>(of_joints, joints, rates, still);
  ASSERT_TRUE(theirs.status.ok());
  EXPECT_TRUE(ours.status.ok());
  expect_same(ours.tau, theirs.tau);
  expect_same(of_arrays.last_safe, theirs.tau);
}

// What a length is taken from.
static_assert(axial::detail::plain_length<float[4]> == 4);
static_assert(axial::detail::plain_length<std::array<float, 4>> == 4);
static_assert(axial::detail::plain_length<axial::Pointed<4, float>> == 4);
static_assert(axial::detail::plain_length<const float*> == 0);
static_assert(axial::detail::plain_length<Q> == -1);
static_assert(axial::detail::takes_arrays<R, 2, float[3], Q, axial::Inputs<R, float>>);
static_assert(!axial::detail::takes_arrays<R, 2, float[3], float[4]>);
static_assert(!axial::detail::takes_arrays<R, 2, float[3], double[3]>);
static_assert(!axial::detail::takes_arrays<R, 2, float[3]>);
static_assert(!axial::detail::takes_arrays<R, 1, float[3], float[3]>);
static_assert(!axial::detail::takes_arrays<R, 1, float[3], axial::Inputs<R, float>, axial::Inputs<R, float>>);
static_assert(!axial::detail::takes_arrays<R, 1, int[3]>);
static_assert(!axial::detail::takes_arrays<R, 1, const float*>);
template <class T, class... A>
inline constexpr bool fits_state =
    axial::detail::Call<T, R, axial::detail::OfPosition, axial::detail::First<A...>>::fits;
static_assert(fits_state<double, double[3]> && !fits_state<float, double[3]>);

}  // namespace
