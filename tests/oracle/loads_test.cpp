// What acts on a chain besides gravity and motors, by physics: friction, springs, wrenches, a moving base.
#include <gtest/gtest.h>

#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/moving_base.hpp>
#include <oracle/random_chain.hpp>

namespace {

using oracle::quad;
using oracle::Vector;

constexpr double rounding = 2e-31;  // a thousand roundings of quad

oracle::Chain<quad> drive() {
  oracle::Link<quad> link;
  link.viscous = 0.5, link.coulomb_forward = 2, link.coulomb_backward = -1;
  oracle::Chain<quad> chain;
  chain.links = {link};
  return chain;
}
double friction(const oracle::Chain<quad>& chain, double speed) {
  return static_cast<double>(oracle::friction_torque(chain, {quad(speed)})[0]);
}

struct Sample {
  explicit Sample(unsigned seed) : random(seed) {
    chain = oracle::convert<quad>(random.chain(5));
    q = vector(3.0), qd = vector(2.0), qdd = vector(4.0);
  }
  Vector<quad> vector(double size) { return oracle::convert<quad>(random.vector(5, size)); }

  oracle::RandomChains random;
  oracle::Chain<quad> chain;
  Vector<quad> q, qd, qdd;
};

}  // namespace

TEST(Loads, StribeckFrictionFallsToHalfOfItsExcess) {
  auto chain = drive();
  chain.links[0].static_friction = 4, chain.links[0].stribeck_speed = 0.25;
  EXPECT_NEAR(friction(chain, 1e-15), 4.0, 1e-14);
  EXPECT_NEAR(friction(chain, -1e-15), -4.0, 1e-14);
  EXPECT_NEAR(friction(chain, 0.25), 3.0 + 0.125, 1e-15);
  EXPECT_NEAR(friction(chain, -0.25), -2.5 - 0.125, 1e-15);
  EXPECT_EQ(friction(chain, 0.0), 0.0);
}

TEST(Loads, SmoothFrictionIsContinuousThroughRest) {
  auto chain = drive();
  chain.links[0].smooth_speed = 0.5;
  EXPECT_NEAR(friction(chain, 1e-15), 0.0, 1e-14);
  EXPECT_NEAR(friction(chain, 0.25), 2.0 * 0.6875 + 0.125, 1e-15);
  EXPECT_EQ(friction(chain, 0.5), 2.25);
  EXPECT_EQ(friction(chain, -2.0), -2.0);
}

TEST(Loads, ASpringIsTheSlopeOfItsEnergy) {
  auto chain = drive();
  chain.links[0].spring_stiffness = 8, chain.links[0].spring_rest = 0.5;
  EXPECT_EQ(static_cast<double>(oracle::spring_torque(chain, {quad(0.75)})[0]), 2.0);
}

// Weight as a force on every centre of mass, instead of as gravity.
TEST(Loads, WrenchesOnTheLinksCanStandForGravity) {
  Sample s(7);
  auto weightless = s.chain;
  weightless.gravity = {};
  oracle::Load<quad> weight;
  const auto poses = oracle::link_poses(s.chain, s.q);
  for (int k = 0; k < 5; ++k) {
    const auto f = oracle::transpose(poses[std::size_t(k)].rotation) * (s.chain[k].mass * s.chain.gravity);
    weight.links.push_back({f, cross(s.chain[k].com, f)});
  }
  EXPECT_LE(oracle::relative_error(oracle::inverse_dynamics(weightless, s.q, s.qd, s.qdd, weight),
                                   oracle::inverse_dynamics(s.chain, s.q, s.qd, s.qdd)),
            rounding);
}

TEST(Loads, ABaseAtRestChangesNothing) {
  Sample s(8);
  EXPECT_LE(oracle::relative_error(oracle::inverse_dynamics_on_moving_base(s.chain, {}, s.q, s.qd, s.qdd),
                                   oracle::inverse_dynamics(s.chain, s.q, s.qd, s.qdd)),
            rounding);
}

TEST(Loads, ABaseThatFallsFreelyIsWeightless) {
  Sample s(9);
  oracle::BaseMotion<quad> fall;
  fall.linear_acceleration = s.chain.gravity;
  auto weightless = s.chain;
  weightless.gravity = {};
  EXPECT_LE(oracle::relative_error(oracle::inverse_dynamics_on_moving_base(s.chain, fall, s.q, s.qd, s.qdd),
                                   oracle::inverse_dynamics(weightless, s.q, s.qd, s.qdd)),
            rounding);
}

// A base that turns as the first joint would, about that joint's axis through the base's origin.
TEST(Loads, ABaseThatTurnsAboutTheFirstAxisIsThatJointTurning) {
  Sample s(10);
  s.chain.links[0].type = oracle::Joint::revolute, s.chain.links[0].alpha = 0, s.chain.links[0].a = 0;
  s.chain.links[0].rotor_inertia = 0;
  oracle::BaseMotion<quad> turn;
  turn.angular_velocity = {0, 0, quad(1.5)}, turn.angular_acceleration = {0, 0, quad(-2.5)};
  auto qd = s.qd, qdd = s.qdd;
  qd[0] += quad(1.5), qdd[0] -= quad(2.5);
  EXPECT_LE(oracle::relative_error(oracle::inverse_dynamics_on_moving_base(s.chain, turn, s.q, s.qd, s.qdd),
                                   oracle::inverse_dynamics(s.chain, s.q, qd, qdd)),
            rounding);
}
