// Derivatives in values of drives, over robots that numbers alone describe, and the largest that anybody described.
#include "drawn_couplings.hpp"
#include "driven_slopes.hpp"

namespace {

using namespace constrained;

using DrawnModel = Model<4, Gravity, RotorInertia, Friction, SharedDrives>;
/// A drawn robot, in both descriptions, and a motion of its drives.
struct Drawn {
  Constrained exact;
  DrawnModel model;
  Motion x;
};
template <int Number>
Drawn drawn() {
  using R = property::Coupled<Number>;
  oracle::Load<quad> load;
  load.friction = true;
  Drawn robot{Constrained::of<R>(drawn_couplings<Number>(), load), {}, {}};
  robot.model.set_gravity(R::chain.gravity.x, R::chain.gravity.y, R::chain.gravity.z);
  for (const LinkParameters& link : R::chain.links)
    EXPECT_TRUE(robot.model.add(link));
  oracle::RandomChains random(1000U + unsigned(Number));
  robot.x = motion<R>(random, robot.exact.owner());
  return robot;
}
/// One looped kernel for all of them.
void expect_at_run_time(int number, const Drawn& robot) {
  SCOPED_TRACE(number);
  const At<DrawnModel, double> at(robot.x.u, robot.x.ud, robot.x.udd);
  const auto inverse = inverse_dynamics_derivatives(robot.model, at.u, at.ud, at.udd);
  expect_inverse(robot.exact, at, inverse);
  const auto forward = forward_dynamics_derivatives(robot.model, at.u, at.ud, inverse.tau);
  expect_forward(robot.exact, at, inverse.tau, forward);
  const MotionDirection<DrawnModel, double> by{at.ud, at.udd, at.u};
  expect_along(robot.exact.drives(), by, inverse, inverse_dynamics_along(robot.model, at.u, at.ud, at.udd, by), forward,
               forward_dynamics_along(robot.model, at.u, at.ud, inverse.tau, {by.dq, by.dqd, by.dqdd}));
}
template <int Number>
void expect_drawn_unrolled() {
  SCOPED_TRACE(Number);
  using R = property::Coupled<Number>;
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  const auto robot = drawn<Number>();
  const At<R, double> at(robot.x.u, robot.x.ud, robot.x.udd);
  const auto inverse = inverse_dynamics_derivatives<S>(at.u, at.ud, at.udd);
  expect_inverse(robot.exact, at, inverse);
  expect_forward(robot.exact, at, inverse.tau, forward_dynamics_derivatives<S>(at.u, at.ud, inverse.tau));
}
template <int... Number>
void expect_all_drawn_at_run_time(std::integer_sequence<int, Number...>) {
  (expect_at_run_time(Number, drawn<Number>()), ...);
}
template <int... Number>
void expect_all_drawn_unrolled(std::integer_sequence<int, Number...>) {
  (expect_drawn_unrolled<Number>(), ...);
}

}  // namespace

TEST(DrawnDerivatives, AreThoseOfTwoHundredDrawnRobotsAtRunTime) {
  expect_all_drawn_at_run_time(std::make_integer_sequence<int, 200>{});
}
TEST(DrawnDerivatives, AreThoseOfDrawnRobotsUnrolled) {
  expect_all_drawn_unrolled(std::make_integer_sequence<int, 8>{});
}
TEST(DrawnDerivatives, OfThePalletiserAreSlopesOfConstraints) {
  expect_plain<robots::Palletiser, double>(2, 3);
  expect_plain<robots::Palletiser, float>(12, 3);
  expect_slopes<robots::Palletiser, double, Gravity, RotorInertia, Looped>({}, 32, 2);
}
