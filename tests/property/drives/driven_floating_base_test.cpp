// Robots whose joints share drives on a body that floats: efforts, what carries the robot and accelerations, against
// constraints with multipliers in 113 bits, the body's six degrees of freedom among the joints.

#include <property/batches/batched_states.hpp>
#include "constrained.hpp"

namespace {

using namespace constrained;

template <class T, class Found>
void expect_close(const Found& found, int n, const Vector<quad>& wanted, double size, double bound = tolerance<T>) {
  EXPECT_LE(error_in(wanted, size, convert<quad>(Vector<T>(found.values, found.values + n))), bound);
}
/// A robot whose joints share drives, on a body.
template <class R>
struct Afloat {
  static constexpr auto chain = [] {
    auto chain = R::chain;
    chain.base_body =
        axial::chain(base_body().mass(20).com(0.1, -0.2, -0.1).inertia_com(1, 1.25, 1.5), revolute().mass(1)).base_body;
    chain.has_base_body = true;
    return chain;
  }();
};
template <class R, class T, class... Features>
void expect_afloat(unsigned seed) {
  using S = Scene<Afloat<R>, RuntimeGravity, RotorInertia, FloatingBase, Features...>;
  const auto exact = Constrained::of<R>();
  const int m = exact.drives();
  auto tree = exact.chain();
  tree.gravity = {quad(-3), quad(2.5), quad(8)};
  const oracle::BaseMotion<quad> base{
      {quad(0.75), quad(-1.25), quad(0.5)}, {quad(-2), quad(1.5), quad(3)}, {quad(4), quad(-1), quad(2.5)}};
  Inputs<S, T> in{};
  in.gravity = {T(-3), T(2.5), T(8)};
  in.base_motion = {{T(0.75), T(-1.25), T(0.5)}, {T(-2), T(1.5), T(3)}, {T(4), T(-1), T(2.5)}};
  oracle::RandomChains random(seed);
  for (int state = 0; state < 10; ++state) {
    SCOPED_TRACE(state);
    const auto x = motion<R>(random, exact.owner());
    const auto u = property::joints<R, T>(x.u), ud = property::joints<R, T>(x.ud), udd = property::joints<R, T>(x.udd);
    const auto at = convert<quad>(property::vector(u)), speed = convert<quad>(property::vector(ud)),
               turn = convert<quad>(property::vector(udd));
    const auto of_joints =
        oracle::inverse_dynamics_on_moving_base(tree, base, exact.positions(at), exact.g() * speed, exact.g() * turn);
    Vector<quad> wanted;
    for (int k = 0; k < m; ++k) {
      const LinkParameters& drive = R::chain.links[exact.owner()[std::size_t(k)]];
      wanted.push_back(quad(drive.gear) * quad(drive.gear) * quad(drive.rotor_inertia) * turn[std::size_t(k)]);
      for (int i = 0; i < exact.joints(); ++i)
        wanted.back() += exact.g()(i, k) * of_joints[std::size_t(i)];
    }
    Joints<Afloat<R>, T> position{}, velocity{}, acceleration{};
    for (int k = 0; k < m; ++k)
      position[k] = u[k], velocity[k] = ud[k], acceleration[k] = udd[k];
    const auto tau = inverse_dynamics<S>(position, velocity, acceleration, in);
    expect_close<T>(tau, m, wanted, oracle::largest(wanted));
    // What carries the robot: that of the joints, which the drives move.
    using OfJoints = Scene<JointCoordinates<Afloat<R>>, RuntimeGravity, FloatingBase>;
    Inputs<OfJoints, T> same{};
    same.gravity = in.gravity, same.base_motion = in.base_motion;
    const auto carried = base_wrench<S>(position, velocity, acceleration, in);
    const auto by_joints = base_wrench<OfJoints>(joint_positions<Afloat<R>>(position), joint_rates<Afloat<R>>(velocity),
                                                 joint_rates<Afloat<R>>(acceleration), same);
    const double size = std::abs(double(by_joints.force.x)) + std::abs(double(by_joints.force.y)) +
                        std::abs(double(by_joints.force.z)) + std::abs(double(by_joints.moment.z));
    EXPECT_NEAR(carried.force.x, by_joints.force.x, tolerance<T> * size);
    EXPECT_NEAR(carried.force.y, by_joints.force.y, tolerance<T> * size);
    EXPECT_NEAR(carried.moment.z, by_joints.moment.z, tolerance<T> * size);
  }
}

/// Accelerations of drives and base, and that inverse dynamics has them back with nothing left to carry.
template <class R, class T, class... Features>
void expect_free(unsigned seed, double bound) {
  using F = Afloat<R>;
  using S = Scene<F, RuntimeGravity, RotorInertia, FloatingBase, BaseWrench, Features...>;
  auto tree = oracle::of_robot<quad, R>();
  tree.gravity = {quad(-3), quad(2.5), quad(8)};
  const oracle::FloatingChain<quad> floating(tree, oracle::link_from_axial<quad>(F::chain.base_body, -1));
  const auto exact = Constrained::afloat<R>(by_hand<R>(), floating);
  const int m = joint_count<F>;
  const oracle::BaseTwist<quad> velocity{{quad(0.75), quad(-1.25), quad(0.5)}, {}};
  Inputs<S, T> in{};
  in.gravity = {T(-3), T(2.5), T(8)}, in.base_motion.angular_velocity = {T(0.75), T(-1.25), T(0.5)};
  in.base_wrench = {{T(5), T(-2), T(3)}, {T(10), T(20), T(-15)}};
  oracle::RandomChains random(seed);
  for (int state = 0; state < 10; ++state) {
    SCOPED_TRACE(state);
    const auto x = motion<R>(random, by_hand<R>().owner);
    const auto u = property::joints<F, T>(x.u), ud = property::joints<F, T>(x.ud), udd = property::joints<F, T>(x.udd);
    const auto tau = inverse_dynamics<S>(u, ud, udd, in);
    const auto answer = forward_dynamics<S>(u, ud, tau, in);
    EXPECT_TRUE(answer.status.ok()) << int(answer.status.code) << " of " << answer.status.joint;
    // The push on the body as generalised forces of its six joints: those at frame 0 whose wrench it is.
    const auto push = floating.rates({{quad(5), quad(-2), quad(3)}, {quad(10), quad(20), quad(-15)}},
                                     convert<quad>(property::vector(tau)));
    const auto all = exact.forward(floating.positions(convert<quad>(property::vector(u))),
                                   floating.rates(velocity, convert<quad>(property::vector(ud))), push);
    const Vector<quad> wanted(all.begin() + 6, all.end());
    expect_close<T>(answer, m, wanted, oracle::largest(wanted), bound);
    const auto base = floating.acceleration(velocity, all);
    const auto near = [&](const T& found, const quad& exactly, double size) {
      EXPECT_NEAR(double(found), double(exactly), bound * size);
    };
    const double turn = std::sqrt(double(dot(base.angular, base.angular))) + 1.0,
                 shift = std::sqrt(double(dot(base.linear, base.linear))) + 1.0;
    near(answer.base_acceleration.angular.x, base.angular.x, turn);
    near(answer.base_acceleration.angular.y, base.angular.y, turn);
    near(answer.base_acceleration.angular.z, base.angular.z, turn);
    near(answer.base_acceleration.linear.x, base.linear.x, shift);
    near(answer.base_acceleration.linear.y, base.linear.y, shift);
    near(answer.base_acceleration.linear.z, base.linear.z, shift);
    Inputs<S, T> moved = in;
    moved.base_motion.angular_acceleration = answer.base_acceleration.angular;
    moved.base_motion.linear_acceleration = answer.base_acceleration.linear;
    const Joints<F, T> found = answer;
    const auto again = inverse_dynamics<S>(u, ud, found, moved);
    const auto given = convert<quad>(property::vector(tau));
    expect_close<T>(again, m, given, oracle::largest(given), bound);
    const auto left = base_wrench<S>(u, ud, found, moved);
    EXPECT_NEAR(left.force.x, 0.0, bound * 1e4);
    EXPECT_NEAR(left.moment.y, 0.0, bound * 1e4);
  }
}

}  // namespace

TEST(DrivenFloatingBase, EffortsAreThoseOfAMovingBase) {
  expect_afloat<robots::ScaraQuill, double>(31);
  expect_afloat<robots::WristArm, double>(32);
  expect_afloat<robots::Gripper, double>(33);
  expect_afloat<Followers, double>(34);
  expect_afloat<Followers, double, Looped>(35);
  expect_afloat<robots::WristArm, float>(36);
}
TEST(DrivenFloatingBase, AcceleratesAsConstraintsWithMultipliersInDouble) {
  expect_free<robots::ScaraQuill, double>(41, 1e-12);
  expect_free<robots::Palletiser, double>(42, 1e-12);
  expect_free<robots::WristArm, double>(43, 1e-12);
  expect_free<robots::Gripper, double>(44, 1e-12);
  expect_free<Followers, double>(45, 1e-12);
  expect_free<Followers, double, Looped>(46, 1e-12);
}
TEST(DrivenFloatingBase, AcceleratesAsConstraintsWithMultipliersInFloat) {
  expect_free<robots::WristArm, float>(51, 5e-6);
  expect_free<robots::Gripper, float>(52, 5e-6);
  expect_free<Followers, float>(53, 5e-6);
}
TEST(DrivenFloatingBase, OfARunTimeModelAcceleratesAsTheRobot) {
  using R = Afloat<Followers>;
  using S = Scene<R, RuntimeGravity, RotorInertia, FloatingBase>;
  using M = Model<6, RuntimeGravity, RotorInertia, FloatingBase, SharedDrives>;
  M model;
  for (const LinkParameters& link : R::chain.links)
    ASSERT_TRUE(model.add(link));
  model.set_base_body(R::chain.base_body);
  Inputs<S, double> in{};
  Inputs<M, double> given{};
  in.gravity = given.gravity = {1, 2, -9};
  in.base_motion.angular_velocity = given.base_motion.angular_velocity = {0.5, -1, 2};
  const Joints<R, double> u{0.3, -0.5, 0.7}, ud{1, 2, -3}, tau{5, -20, 3};
  Joints<M, double> q{}, qd{}, efforts{};
  for (int k = 0; k < 3; ++k)
    q[k] = u[k], qd[k] = ud[k], efforts[k] = tau[k];
  const auto answer = forward_dynamics<S>(u, ud, tau, in);
  const auto found = forward_dynamics(model, q, qd, efforts, given);
  EXPECT_TRUE(answer.status.ok() && found.status.ok());
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(found[k], answer[k], 1e-12 * (1.0 + std::abs(answer[k])));
  EXPECT_NEAR(found.base_acceleration.angular.x, answer.base_acceleration.angular.x, 1e-11);
  EXPECT_NEAR(found.base_acceleration.linear.z, answer.base_acceleration.linear.z, 1e-11);
}
TEST(DrivenFloatingBase, OfABatchAcceleratesAsEachState) {
  using R = Afloat<robots::WristArm>;
  using S = Scene<R, RuntimeGravity, RotorInertia, FloatingBase>;
  using V = Batch<double, 2>;
  const property::BatchedStates<R> states(71);
  const auto& [x, lanes] = states;
  Inputs<S, V> in{};
  in.base_motion.angular_velocity = {V(0.5), V(-1.0), V(2.0)};
  Inputs<S, double> one{};
  one.base_motion.angular_velocity = {0.5, -1, 2};
  const auto together = forward_dynamics<S>(x[0], x[1], x[2], in);
  for (int lane = 0; lane < 2; ++lane) {
    const auto alone = forward_dynamics<S>(lanes[lane][0], lanes[lane][1], lanes[lane][2], one);
    EXPECT_TRUE(alone.status.ok());
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(together[k][lane], alone[k], 1e-11 * (1.0 + std::abs(alone[k])));
    EXPECT_NEAR(together.base_acceleration.angular.y[lane], alone.base_acceleration.angular.y, 1e-11);
  }
}
/// A body that weighs next to nothing: what its drive moves is a difference, of all links that hardly move each other.
struct Light {
  static constexpr auto chain =
      axial::chain(base_body().mass(1e-6).inertia_com(1e-9, 1e-9, 1e-9),
                   revolute().mass(5).com(0.3, 0.1, 0).inertia_com(0.1, 0.2, 0.3),
                   revolute().alpha_deg(90).a(0.2).mass(3).com(0.1, 0, 0).inertia_com(0.1, 0.2, 0.3).mimic(0, 1e-4));
};
TEST(DrivenFloatingBase, ThatWeighsNothingIsNamed) {
  using S = Scene<Light, FloatingBase>;
  using R = Afloat<Light>;
  using Heavy = Scene<R, FloatingBase>;
  EXPECT_EQ(forward_dynamics<S>(Joints<Light, double>{0.3}, {1}, {2}, Inputs<S, double>{}).status.code,
            Status::Code::inaccurate);
  EXPECT_TRUE(forward_dynamics<Heavy>(Joints<R, double>{0.3}, {1}, {2}, Inputs<Heavy, double>{}).status.ok());
  Inputs<Heavy, double> in{};
  in.base_motion.angular_velocity.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(forward_dynamics<Heavy>(Joints<R, double>{0.3}, {1}, {2}, in).status.code, Status::Code::not_finite);
}
