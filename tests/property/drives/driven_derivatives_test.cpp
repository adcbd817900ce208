// Derivatives in values of drives that joints share: of robots, unrolled, looped and at run time; in time; in batches.

#include <property/batches/batched_states.hpp>
#include "driven_slopes.hpp"

namespace {

using namespace constrained;

template <class R, class S>
void expect_rates(unsigned seed) {
  const auto exact = Constrained::of<R>();
  oracle::RandomChains random(seed);
  const auto x = motion<R>(random, exact.owner());
  const int n = exact.drives();
  const At<R, double> at(x.u, x.ud, x.udd);
  const auto jerk = random.vector(n, 20.0), snap = random.vector(n, 100.0);
  const auto third = convert<quad>(jerk), fourth = convert<quad>(snap);
  const auto tau_at = [&](quad t) {
    Vector<quad> u = at.exact_u, ud = at.exact_ud, udd = at.exact_udd;
    for (std::size_t k = 0; k < u.size(); ++k) {
      const quad p = third[k], s = fourth[k];
      u[k] += t * (at.exact_ud[k] + t / 2 * (at.exact_udd[k] + t / 3 * (p + t / 4 * s)));
      ud[k] += t * (at.exact_udd[k] + t / 2 * (p + t / 3 * s)), udd[k] += t * (p + t / 2 * s);
    }
    return exact.inverse(u, ud, udd);
  };
  const quad h = quad(1) / quad(1LL << 26);
  const auto before = tau_at(-h), here = tau_at(quad(0)), after = tau_at(h);
  Vector<quad> rate, curve;
  for (std::size_t k = 0; k < here.size(); ++k) {
    rate.push_back((after[k] - before[k]) / (h + h));
    curve.push_back((after[k] - here[k] - here[k] + before[k]) / (h * h));
  }
  const auto q3 = property::joints<R, double>(jerk), q4 = property::joints<R, double>(snap);
  const auto first = torque_rates<S>(at.u, at.ud, at.udd, q3);
  const auto both = torque_rates<S>(at.u, at.ud, at.udd, q3, q4);
  const auto expect = [&](const Vector<quad>& wanted, const auto& found) {
    EXPECT_LE(error_in(wanted, oracle::largest(wanted), convert<quad>(property::vector(found, n))), 1e-11) << seed;
  };
  expect(here, first.tau), expect(rate, first.taud);
  expect(here, both.tau), expect(rate, both.taud), expect(curve, both.taudd);
}
/// Two slides along one line, the second by half as much again: nothing but friction depends on the speed.
struct Slides {
  static constexpr auto chain = axial::chain(prismatic().mass(2.0).viscous(3.0), prismatic().mass(1.0).mimic(0, 0.5));
};

}  // namespace

TEST(DrivenDerivatives, AreSlopesOfConstraintsInDouble) {
  expect_plain<robots::ScaraQuill, double>(1);
  expect_plain<robots::WristArm, double>(3);
  expect_plain<robots::Gripper, double>(4);
  expect_plain<Followers, double>(5);
}
TEST(DrivenDerivatives, AreSlopesOfConstraintsInFloat) {
  expect_plain<robots::ScaraQuill, float>(11);
  expect_plain<robots::WristArm, float>(13);
  expect_plain<robots::Gripper, float>(14);
  expect_plain<Followers, float>(15);
}
TEST(DrivenDerivatives, CarryFrictionOfDrivesSpringsOfJointsAndWrenches) {
  oracle::Load<quad> load;
  load.friction = load.springs = true;
  load.tip = {{quad(3), quad(-2), quad(5)}, {quad(0.5), quad(-0.25), quad(0.75)}};
  expect_slopes<Followers, double, Gravity, RotorInertia, Friction, JointSprings, TipWrench>(load, 21, 10);
  expect_slopes<Followers, double, Gravity, RotorInertia, Friction, JointSprings, TipWrench, Looped>(load, 22, 10);
  load.springs = false;
  expect_slopes<robots::WristArm, double, Gravity, RotorInertia, Friction, TipWrench>(load, 23, 10);
}
TEST(DrivenDerivatives, LoopedAndWithFullParametersAreTheSame) {
  expect_slopes<Followers, double, Gravity, RotorInertia, Looped>({}, 31, 5);
  expect_slopes<robots::WristArm, double, Gravity, RotorInertia, FullParameters>({}, 33, 5);
}
TEST(DrivenDerivatives, InTimeAreSlopesOfEffortsAlongAMotion) {
  expect_rates<robots::WristArm, robots::WristArm>(71);
  expect_rates<robots::ScaraQuill, robots::ScaraQuill>(72);
  expect_rates<Followers, Scene<Followers, Gravity, RotorInertia, Looped>>(73);
}
TEST(DrivenDerivatives, OfARunTimeModelAreThoseOfTheRobot) {
  using R = Followers;
  using M = Model<6, Gravity, RotorInertia, Friction, JointSprings, SharedDrives>;
  M model;
  model.set_gravity(R::chain.gravity.x, R::chain.gravity.y, R::chain.gravity.z);
  for (int i = 0; i < R::chain.size; ++i) {
    LinkParameters link = R::chain.links[i];
    link.parent = R::chain.parent(i) < 0 ? LinkParameters::base : R::chain.parent(i);
    ASSERT_TRUE(model.add(link));
  }
  oracle::Load<quad> load;
  load.friction = load.springs = true;
  const auto exact = Constrained::of<R>(load);
  oracle::RandomChains random(81);
  const auto x = motion<R>(random, exact.owner());
  const At<M, double> at(x.u, x.ud, x.udd);
  const auto inverse = inverse_dynamics_derivatives(model, at.u, at.ud, at.udd);
  expect_inverse(exact, at, inverse);
  const auto forward = forward_dynamics_derivatives(model, at.u, at.ud, inverse.tau);
  expect_forward(exact, at, inverse.tau, forward);
  const MotionDirection<M, double> by{at.ud, at.udd, at.u};
  expect_along(3, by, inverse, inverse_dynamics_along(model, at.u, at.ud, at.udd, by), forward,
               forward_dynamics_along(model, at.u, at.ud, inverse.tau, {by.dq, by.dqd, by.dqdd}));
}
TEST(DrivenDerivatives, OfDryFrictionAtRestAreThoseOfViscousFriction) {
  using R = Followers;
  const Joints<R, double> u{0.3, -0.5, 0.7}, rest{};
  const auto with = inverse_dynamics_derivatives<Scene<R, Gravity, RotorInertia, Friction>>(u, rest, rest);
  const double viscous[] = {0.5, 0.125, 0.0};
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l)
      EXPECT_NEAR(with.dtau_dqd(k, l), k == l ? viscous[k] : 0.0, 1e-15) << k << l;
}
TEST(DrivenDerivatives, OfFrictionAloneAreSolvedFor) {
  const Joints<Slides, double> u{0.1}, ud{0.2}, tau{4.0};
  const auto d = forward_dynamics_derivatives<Scene<Slides, Friction>>(u, ud, tau);
  EXPECT_DOUBLE_EQ(d.M_inverse(0, 0), 1.0 / 4.25);
  EXPECT_DOUBLE_EQ(d.dqdd_dqd(0, 0), -3.0 / 4.25);
  EXPECT_EQ(d.dqdd_dq(0, 0), 0.0);
}
TEST(DrivenDerivatives, AreKnownToTheCompilerAndWhatIsAskedForAlone) {
  using R = robots::Gripper;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  constexpr Joints<R, double> u{0.2, 0.01}, ud{1.0, -0.05}, udd{2.0, 0.3};
  constexpr auto all = inverse_dynamics_derivatives<S>(u, ud, udd);
  constexpr auto slope = inverse_dynamics_derivatives<S, with_velocity_jacobian>(u, ud, udd);
  static_assert(sizeof(slope) == 4 * sizeof(double));
  const auto again = inverse_dynamics_derivatives<S>(u, ud, udd);
  for (int k = 0; k < 2; ++k)
    for (int l = 0; l < 2; ++l) {
      EXPECT_DOUBLE_EQ(slope.dtau_dqd(k, l), all.dtau_dqd(k, l));
      EXPECT_NEAR(again.dtau_dq(k, l), all.dtau_dq(k, l), 1e-14);
    }
}
TEST(DrivenDerivatives, ABatchHasWhatEachOfItsStatesHas) {
  using R = robots::WristArm;
  const property::BatchedStates<R> states(61);
  const auto& [x, lanes] = states;
  const auto together = inverse_dynamics_derivatives<R>(x[0], x[1], x[2]);
  const auto solved = forward_dynamics_derivatives<R>(x[0], x[1], together.tau);
  for (int lane = 0; lane < 2; ++lane) {
    const auto alone = inverse_dynamics_derivatives<R>(lanes[lane][0], lanes[lane][1], lanes[lane][2]);
    const auto solved_alone = forward_dynamics_derivatives<R>(lanes[lane][0], lanes[lane][1], alone.tau);
    for (int k = 0; k < 5; ++k)
      for (int l = 0; l < 5; ++l) {
        EXPECT_NEAR(solved.dqdd_dq(k, l)[lane], solved_alone.dqdd_dq(k, l), 1e-9);
        EXPECT_NEAR(solved.dqdd_dqd(k, l)[lane], solved_alone.dqdd_dqd(k, l), 1e-9);
        EXPECT_NEAR(together.dtau_dq(k, l)[lane], alone.dtau_dq(k, l), 1e-12);
        EXPECT_NEAR(together.dtau_dqd(k, l)[lane], alone.dtau_dqd(k, l), 1e-12);
        EXPECT_NEAR(together.M(k, l)[lane], alone.M(k, l), 1e-12);
      }
  }
}
