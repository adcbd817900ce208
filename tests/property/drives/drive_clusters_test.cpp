// Articulated bodies over clusters of joints that share drives: against constraints with multipliers in 113 bits; which
// joints are a cluster; what it costs.
#include <axial/cost.hpp>

#include "constrained.hpp"

namespace {

using namespace axial;

/// A belt past a joint with a drive of its own, which a branch hangs on; a slide that carries on from there; two joints
/// on the base that share a drive.
struct PastAJoint {
  static constexpr auto link = revolute()
                                   .alpha(0.6)
                                   .a(0.2)
                                   .d(0.05)
                                   .mass(1.5)
                                   .com(0.1, 0.02, 0.03)
                                   .inertia_com(0.03, 0.02, 0.025, 0.001, 0.002, 0.003);
  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(gravity(1.0, -2.0, -9.0),
      link.rotor_inertia(1e-4, 50),
      link.rotor_inertia(1e-4, 60).viscous(0.25),
      link.rotor_inertia(1e-4, 40),
      link.rotor_inertia(1e-4, 30).driven_by(1, -1.0),
      prismatic().alpha_deg(90).mass(1).com(0.02, 0.1, 0).inertia_com(0.02, 0.03, 0.04).spring(50.0, 0.1),
      link.parent(2),
      link.parent(LinkParameters::base).rotor_inertia(1e-4, 50),
      link.parent(LinkParameters::base).driven_by(6, 0.5));
  // clang-format on
};
constexpr Link body(int i) {
  return revolute()
      .alpha(0.4 + 0.2 * i)
      .a(0.2)
      .d(0.1)
      .mass(11.0 - i)
      .com(0.1, 0.02, 0.03)
      .inertia_com(0.03, 0.02, 0.025, 0.001, 0.002, 0.003);
}
/// Ten joints of general twist: a belt past the elbow, a differential wrist.
struct TenJoints {
  static constexpr auto chain =
      axial::chain(gravity(0.5, 1.0, -9.0), body(0), body(1), body(2).driven_by(1, -1.0), body(3), body(4), body(5),
                   body(6), body(7), body(8), body(9), differential());
};

}  // namespace

namespace constrained {

template <>
inline Couplings by_hand<PastAJoint>() {
  auto c = couplings(8, {0, 1, 2, 3, 4, 5, 6, 7}, std::vector<std::vector<double>>(8, std::vector<double>(8)));
  for (int i = 0; i < 8; ++i)
    c.g(i, i) = 1;
  c.g(3, 1) = -1, c.g(7, 6) = quad(0.5);
  return c;
}
template <>
inline Couplings by_hand<TenJoints>() {
  auto c = couplings(10, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, std::vector<std::vector<double>>(10, std::vector<double>(10)));
  for (int i = 0; i < 8; ++i)
    c.g(i, i) = 1;
  c.g(2, 1) = -1;
  c.g(8, 8) = c.g(8, 9) = c.g(9, 8) = quad(0.5), c.g(9, 9) = quad(-0.5);
  return c;
}

}  // namespace constrained

namespace {

using namespace constrained;

template <class R, class T, class... Features>
void expect_accelerations(const oracle::Load<quad>& load, unsigned seed, int states = 40, double bound = tolerance<T>) {
  using S = Scene<R, Features...>;
  const auto exact = Constrained::of<R>(load);
  oracle::RandomChains random(seed);
  Inputs<S, T> in{};
  if constexpr (S::template has<TipWrench>) in.tip_wrench = {{T(0.5), T(-0.25), T(0.75)}, {T(3), T(-2), T(5)}};
  for (int state = 0; state < states; ++state) {
    const auto x = motion<R>(random, exact.owner());
    const auto u = property::joints<R, T>(x.u), ud = property::joints<R, T>(x.ud), udd = property::joints<R, T>(x.udd);
    const auto tau = inverse_dynamics<S>(u, ud, udd, in);
    const auto answer = forward_dynamics<S>(u, ud, tau, in);
    EXPECT_TRUE(answer.status.ok()) << int(answer.status.code) << " of drive " << answer.status.joint;
    Joints<R, T> found{};
    for (int k = 0; k < joint_count<R>; ++k)
      found[k] = answer[k];
    EXPECT_LE(oracle::relative_error(property::vector(found), exact.forward(convert<quad>(x.u), convert<quad>(x.ud),
                                                                            convert<quad>(property::vector(tau)))),
              bound)
        << state;
  }
}
/// In float, of a chain so loose that half a last bit of its positions and efforts moves accelerations by more than the
/// bound of other robots: within what these can do in the same state.
template <class R>
void expect_as_exact_as_inputs(unsigned seed, int states) {
  using S = Scene<R, Gravity, RotorInertia>;
  const auto exact = Constrained::of<R>();
  oracle::RandomChains random(seed);
  double worst = 0.0, ratio = 0.0;
  for (int state = 0; state < states; ++state) {
    const auto x = motion<R>(random, exact.owner());
    const auto u = property::joints<R, float>(x.u), ud = property::joints<R, float>(x.ud);
    const auto tau = inverse_dynamics<S>(u, ud, property::joints<R, float>(x.udd));
    const auto answer = forward_dynamics<S>(u, ud, tau);
    EXPECT_TRUE(answer.status.ok()) << int(answer.status.code);
    Joints<R, float> found{};
    for (int k = 0; k < joint_count<R>; ++k)
      found[k] = answer[k];
    const auto at = convert<quad>(x.u), speed = convert<quad>(x.ud), effort = convert<quad>(property::vector(tau));
    const auto off = [](Vector<quad> values, int k) {
      values[std::size_t(k)] *= quad(1.0 + 0x1p-24);
      return values;
    };
    const auto wanted = exact.forward(at, speed, effort);
    const double size = oracle::largest(wanted);
    double moved = 0.0;
    for (int k = 0; k < joint_count<R>; ++k)
      moved += error_in(wanted, size, exact.forward(off(at, k), speed, effort)) +
               error_in(wanted, size, exact.forward(at, speed, off(effort, k)));
    const double error = error_in(wanted, size, convert<quad>(property::vector(found)));
    EXPECT_LE(error, moved) << state;
    ratio = std::fmax(ratio, error / moved);
    worst = std::fmax(worst, error);
  }
  std::printf("largest error %.2g, %.2f of what half a last bit of each position and effort can do\n", worst, ratio);
  EXPECT_LE(worst, 1e-5);
}
template <class R>
void expect_both(unsigned seed) {
  expect_accelerations<R, double, Gravity, RotorInertia, SplitArticulatedBody>({}, seed);
  expect_accelerations<R, float, Gravity, RotorInertia, SplitArticulatedBody>({}, seed);
}

/// First joints of the clusters that joints belong to.
template <class R>
std::vector<int> first_joints() {
  const auto& first = clusters::layout<R>.first;
  return {first, first + R::chain.size};
}
template <class R, class Form>
int operations() {
  return cost<Scene<R, Gravity, RotorInertia, Form>>(algorithm::forward_dynamics).total();
}

}  // namespace

TEST(DriveClusters, EqualConstraintsWithMultipliers) {
  expect_both<robots::Palletiser>(41);
  expect_both<robots::WristArm>(42);
  expect_both<robots::ScaraQuill>(43);
}
TEST(DriveClusters, OfAChainOfTenAndPastAJointEqualConstraintsWithMultipliers) {
  expect_both<PastAJoint>(46);
  expect_accelerations<TenJoints, double, Gravity, RotorInertia>({}, 47, 20);
  expect_as_exact_as_inputs<TenJoints>(48, 20);
}
TEST(DriveClusters, CarryFrictionSpringsAndAWrench) {
  oracle::Load<quad> load;
  load.friction = load.springs = true;
  load.tip = {{quad(3), quad(-2), quad(5)}, {quad(0.5), quad(-0.25), quad(0.75)}};
  expect_accelerations<Followers, double, Gravity, RotorInertia, Friction, JointSprings, TipWrench,
                       SplitArticulatedBody>(load, 49);
}
TEST(DriveClusters, AreJointsThatShareDrivesAndThoseBetween) {
  using Row = std::vector<int>;
  EXPECT_EQ(first_joints<robots::WristArm>(), (Row{0, 1, 1, 3, 3}));
  EXPECT_EQ(first_joints<robots::Gripper>(), (Row{0, 1, 1}));
  EXPECT_EQ(first_joints<robots::Palletiser>(), (Row{0, 1, 1, 1, 1, 1, 1, 1, 1, 9}));
  EXPECT_EQ(first_joints<PastAJoint>(), (Row{0, 1, 1, 1, 4, 5, 6, 6}));
  constexpr auto& layout = clusters::layout<PastAJoint>;
  EXPECT_EQ(layout.count, 2);
  EXPECT_EQ(layout.carrier[0], 0);
  EXPECT_EQ(layout.carrier[1], LinkParameters::base);
  EXPECT_EQ(layout.drives[0], 3) << "the joint between keeps its drive";
}
TEST(DriveClusters, CostLessThanCompositeBodiesFromTenJoints) {
  EXPECT_LT((operations<TenJoints, SplitArticulatedBody>()), (operations<TenJoints, CompositeBody>()));
  EXPECT_EQ(forward_dynamics_route<TenJoints>, Route::split_articulated_body);
  EXPECT_EQ(forward_dynamics_route<robots::WristArm>, Route::composite_body);
}
TEST(DriveClusters, NameADriveThatNothingResists) {
  using R = robots::Gripper;
  using Free = Scene<R, SplitArticulatedBody>;  // without rotors
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(forward_dynamics<Free>(Joints<R, double>{0.1, 0.02}, {}, {1.0, 2.0}).status.ok());
  EXPECT_EQ(forward_dynamics<Free>(Joints<R, double>{none, 0.02}, {}, {1.0, 2.0}).status.code,
            Status::Code::not_finite);
}
