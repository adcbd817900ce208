// Wrenches on every link of robots whose joints share drives, against constraints with multipliers in 113 bits: of
// robots and of couplings that numbers alone describe; power.

#include <property/batches/batched_states.hpp>
#include "drawn_couplings.hpp"
#include "driven_slopes.hpp"

namespace {

using namespace constrained;

template <class R>
Constrained exact_of(const oracle::Load<quad>& load, const R*) {
  return Constrained::of<R>(load);
}
template <int Number>
Constrained exact_of(const oracle::Load<quad>& load, const property::Coupled<Number>*) {
  return Constrained::of<property::Coupled<Number>>(drawn_couplings<Number>(), load);
}
template <class R>
Constrained loaded() {
  return exact_of(load_on_links(R::chain.size), static_cast<const R*>(nullptr));
}

template <class T, class Found>
void expect_close(const Found& found, int n, const Vector<quad>& wanted, double size) {
  EXPECT_LE(error_in(wanted, size, convert<quad>(Vector<T>(found.values, found.values + n))), tolerance<T>);
}

template <class R, class T, class... Features>
void expect_wrenches(unsigned seed, int states) {
  using S = Scene<R, Gravity, RotorInertia, TipWrench, ExternalWrenches, Features...>;
  const auto exact = loaded<R>();
  const int m = exact.drives();
  oracle::RandomChains random(seed);
  const auto in = inputs<S, T>();
  for (int state = 0; state < states; ++state) {
    SCOPED_TRACE(state);
    const auto x = motion<R>(random, exact.owner());
    const At<R, T> at(x.u, x.ud, x.udd);
    const Vector<quad> rest(std::size_t(m), quad(0));
    const auto efforts = exact.inverse(at.exact_u, at.exact_ud, at.exact_udd);
    const double size = oracle::largest(efforts);
    const auto tau = inverse_dynamics<S>(at.u, at.ud, at.udd, in);
    expect_close<T>(tau, m, efforts, size);
    expect_close<T>(bias_torque<S>(at.u, at.ud, in), m, exact.inverse(at.exact_u, at.exact_ud, rest), size);
    expect_close<T>(gravity_torque<S>(at.u, in), m, exact.inverse(at.exact_u, rest, rest), size);
    const auto answer = forward_dynamics<S>(at.u, at.ud, tau, in);
    EXPECT_TRUE(answer.status.ok()) << int(answer.status.code);
    const auto wanted = exact.forward(at.exact_u, at.exact_ud, convert<quad>(property::vector(tau)));
    expect_close<T>(answer, m, wanted, oracle::largest(wanted));
  }
}
template <class R, class T>
void expect_by_composites_and_clusters(unsigned seed, int states) {
  expect_wrenches<R, T, CompositeBody>(seed, states);
  expect_wrenches<R, T, SplitArticulatedBody>(seed + 1, states);
}
template <class T>
void expect_of_robots(unsigned seed) {
  expect_by_composites_and_clusters<robots::ScaraQuill, T>(seed, 20);
  expect_by_composites_and_clusters<robots::Palletiser, T>(seed + 2, 20);
  expect_by_composites_and_clusters<robots::WristArm, T>(seed + 4, 20);
  expect_by_composites_and_clusters<robots::Gripper, T>(seed + 6, 20);
}
template <int... Number>
void expect_of_random_couplings(std::integer_sequence<int, Number...>) {
  (expect_wrenches<property::Coupled<Number>, double>(100U + unsigned(Number), 5), ...);
}

/// What wrenches on the links change of the efforts: the power of drives is that of joints.
template <class R>
void expect_power(unsigned seed) {
  using S = Scene<R, ExternalWrenches>;
  using OfJoints = Scene<JointCoordinates<R>, ExternalWrenches>;
  oracle::RandomChains random(seed);
  const auto in = inputs<S, double>();
  const auto at_joints = inputs<OfJoints, double>();
  for (int state = 0; state < 20; ++state) {
    const auto u = property::joints<R, double>(random.vector(joint_count<R>, 2)),
               ud = property::joints<R, double>(random.vector(joint_count<R>, 3));
    const auto q = joint_positions<R>(u), qd = joint_rates<R>(ud);
    const auto of_drives = gravity_torque<S>(u, in);
    const auto of_joints = gravity_torque<OfJoints>(q, at_joints);
    double power = 0.0, size = 0.0;
    for (int k = 0; k < joint_count<R>; ++k)
      power += ud[k] * of_drives[k], size += std::abs(ud[k] * of_drives[k]);
    for (int i = 0; i < link_count<R>; ++i)
      power -= qd[i] * of_joints[i], size += std::abs(qd[i] * of_joints[i]);
    EXPECT_GT(size, 0.1);
    EXPECT_LE(std::abs(power), 1e-14 * size) << state;
  }
}

using LoadedModel = Model<6, Gravity, RotorInertia, TipWrench, ExternalWrenches, SharedDrives>;

}  // namespace

TEST(DrivenWrenches, AreThoseOfConstraintsInDouble) { expect_of_robots<double>(1); }
TEST(DrivenWrenches, AreThoseOfConstraintsInFloat) { expect_of_robots<float>(11); }
TEST(DrivenWrenches, OnRandomCouplingsAreThoseOfConstraints) {
  expect_of_random_couplings(std::make_integer_sequence<int, 12>{});
}
TEST(DrivenWrenches, LoopedAreTheSame) {
  expect_wrenches<Followers, double, Looped>(31, 20);
  expect_wrenches<robots::Palletiser, double, Looped>(32, 10);
}
TEST(DrivenWrenches, ChangeDerivativesAsTheyDoConstraints) {
  oracle::Load<quad> load = load_on_links(Followers::chain.size);
  expect_slopes<Followers, double, Gravity, RotorInertia, TipWrench, ExternalWrenches>(load, 41, 5);
  expect_slopes<Followers, double, Gravity, RotorInertia, TipWrench, ExternalWrenches, Looped>(load, 42, 5);
  expect_slopes<Followers, float, Gravity, RotorInertia, TipWrench, ExternalWrenches>(load, 43, 5);
  load = load_on_links(robots::ScaraQuill::chain.size);
  expect_slopes<robots::ScaraQuill, double, Gravity, RotorInertia, TipWrench, ExternalWrenches>(load, 44, 5);
}
TEST(DrivenWrenches, KeepPower) {
  expect_power<robots::ScaraQuill>(51);
  expect_power<robots::Palletiser>(52);
  expect_power<robots::WristArm>(53);
  expect_power<robots::Gripper>(54);
  expect_power<Followers>(55);
}
TEST(DrivenWrenches, OfARunTimeModelAreThoseOfTheRobot) {
  using R = Followers;
  LoadedModel model;
  model.set_gravity(R::chain.gravity.x, R::chain.gravity.y, R::chain.gravity.z);
  for (const LinkParameters& link : R::chain.links)
    ASSERT_TRUE(model.add(link));
  const auto exact = loaded<R>();
  oracle::RandomChains random(61);
  const auto x = motion<R>(random, exact.owner());
  const At<LoadedModel, double> at(x.u, x.ud, x.udd);
  const auto in = inputs<LoadedModel::Scene, double>(model.link_count());
  Inputs<LoadedModel, double> given{};
  given.tip_wrench = in.tip_wrench, given.wrenches = in.wrenches;
  const auto tau = inverse_dynamics(model, at.u, at.ud, at.udd, given);
  const auto efforts = exact.inverse(at.exact_u, at.exact_ud, at.exact_udd);
  expect_close<double>(tau, 3, efforts, oracle::largest(efforts));
  const auto answer = forward_dynamics(model, at.u, at.ud, tau, given);
  EXPECT_TRUE(answer.status.ok());
  expect_close<double>(answer, 3, at.exact_udd, oracle::largest(at.exact_udd));
  const auto slopes = inverse_dynamics_derivatives(model, at.u, at.ud, at.udd, given);
  expect_inverse(exact, at, slopes);
}
TEST(DrivenWrenches, OfABatchAreThoseOfEachState) {
  using R = robots::WristArm;
  using S = Scene<R, Gravity, RotorInertia, ExternalWrenches>;
  using V = Batch<double, 2>;
  const property::BatchedStates<R> states(71);
  const auto& [x, lanes] = states;
  const auto in = inputs<S, V>();
  const auto tau = inverse_dynamics<S>(x[0], x[1], x[2], in);
  const auto back = forward_dynamics<S>(x[0], x[1], tau, in);
  for (int lane = 0; lane < 2; ++lane) {
    const auto alone = inverse_dynamics<S>(lanes[lane][0], lanes[lane][1], lanes[lane][2], inputs<S, double>());
    for (int k = 0; k < 5; ++k) {
      EXPECT_NEAR(tau[k][lane], alone[k], 1e-12);
      EXPECT_NEAR(back[k][lane], lanes[lane][2][k], 1e-10);
    }
  }
}
TEST(DrivenWrenches, ThatAreNoNumbersAreSeen) {
  using R = robots::WristArm;
  using S = Scene<R, Gravity, RotorInertia, ExternalWrenches>;
  const Joints<R, double> u{0.1, 0.2, 0.3, 0.4, 0.5}, ud{}, tau{1, 2, 3, 4, 5};
  auto in = inputs<S, double>();
  EXPECT_TRUE(forward_dynamics<S>(u, ud, tau, in).status.ok());
  in.wrenches[link_count<R> - 1].moment.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(forward_dynamics<S>(u, ud, tau, in).status.code, Status::Code::not_finite);
}
