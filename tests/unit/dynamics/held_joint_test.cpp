// A joint of whose inertia nothing is left keeps acceleration 0 and the rest moves as if it were locked: by every
// route, unrolled, looped and of a run-time model.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>

using namespace axial;

namespace {

constexpr Link body(double a) { return revolute().a(a).mass(2.0).com(0.5, 0.1, 0.05).inertia_com(0.02, 0.03, 0.04); }

// The same arms with a joint that is lost and with that joint locked (its link, massless, welded to the one before).
template <class T, class... Route>
struct Arm {
  using M = Model<4, Gravity, RotorInertia, Route...>;
  M model;
  Joints<M, T> q{}, qd{}, tau{};
  int size = 0;

  Arm() { model.set_gravity(1.0, -9.81, 2.0); }
  void add(const Link& link, double position, double speed, double effort) {
    EXPECT_TRUE(model.add(link));
    q[size] = T(position), qd[size] = T(speed), tau[size++] = T(effort);
  }
  auto solved() const { return forward_dynamics(model, q, qd, tau); }
};

template <class T, class... Route>
void expect_massless_tip_held() {
  Arm<T, Route...> lost, locked;
  lost.add(body(0.0), 0.3, 0.0, 1.0), locked.add(body(0.0), 0.3, 0.0, 1.0);
  lost.add(body(0.4).alpha(0.5), 0.2, 0.0, -2.0), locked.add(body(0.4).alpha(0.5), 0.2, 0.0, -2.0);
  lost.add(revolute().a(1.0).alpha(0.7), 0.1, 0.0, 3.0);
  const auto x = lost.solved(), y = locked.solved();
  EXPECT_EQ(x.status.code, Status::Code::near_singular);
  EXPECT_EQ(x.status.joint, 2);
  EXPECT_EQ(x[2], T(0));
  for (int i : {0, 1})
    EXPECT_NEAR(static_cast<double>(x[i]), static_cast<double>(y[i]),
                1e-5 * (1.0 + std::abs(static_cast<double>(y[i]))));
}

template <class T, class... Route>
void expect_massless_slide_held() {
  Arm<T, Route...> lost, locked;
  for (auto* arm : {&lost, &locked})
    arm->add(body(0.0), 0.3, 0.4, 1.0);
  lost.add(prismatic().a(0.3).alpha_deg(90.0), 0.25, 0.0, 5.0);  // nothing between two slides along one line
  lost.add(prismatic().mass(1.5).com(0.1, 0.2, 0.3), 0.5, 0.0, -1.0);
  locked.add(prismatic().a(0.3).alpha_deg(90.0).mass(1.5).com(0.1, 0.2, 0.3), 0.75, 0.0, -1.0);
  const auto x = lost.solved(), y = locked.solved();
  EXPECT_EQ(x.status.code, Status::Code::near_singular);
  EXPECT_EQ(x.status.joint, 1);
  EXPECT_EQ(x[1], T(0));
  EXPECT_NEAR(static_cast<double>(x[0]), static_cast<double>(y[0]), 1e-5 * (1.0 + std::abs(static_cast<double>(y[0]))));
  EXPECT_NEAR(static_cast<double>(x[2]), static_cast<double>(y[1]), 1e-5 * (1.0 + std::abs(static_cast<double>(y[1]))));
}

template <class T, class... Route>
void expect_held() {
  expect_massless_tip_held<T, Route...>();
  expect_massless_slide_held<T, Route...>();
}

// Slides along one line with the mass on the last: the compiler knows that nothing resists the first.
struct Rail {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, -9.8125), prismatic(), prismatic().mass(2.0));
};
template <class... Features>
void expect_rail_held() {
  using S = Scene<Rail, Gravity, Features...>;
  const Joints<Rail, double> q{0.1, 0.2}, qd{0.3, 0.4}, tau{1.0, 4.0};
  const auto x = forward_dynamics<S>(q, qd, tau);
  EXPECT_EQ(x.status.code, Status::Code::near_singular);
  EXPECT_EQ(x.status.joint, 0);
  EXPECT_EQ(x[0], 0.0);
  EXPECT_DOUBLE_EQ(x[1], -7.8125);
  // Along a direction the status and the joint that is held are the same: 2 kg under 6 N more.
  const auto along = forward_dynamics_along<S>(q, qd, tau, {qd, qd, Joints<Rail, double>{5.0, 6.0}});
  EXPECT_EQ(along.qdd.status.code, Status::Code::near_singular);
  EXPECT_EQ(along.qdd.status.joint, 0);
  EXPECT_EQ(along.dqdd[0], 0.0);
  EXPECT_DOUBLE_EQ(along.dqdd[1], 3.0);
}

}  // namespace

TEST(HeldJoint, MovesWithItsParentByEveryRoute) {
  expect_held<double, ArticulatedBody>();
  expect_held<double, SplitArticulatedBody>();
  expect_held<double, CompositeBody>();
  expect_held<float, ArticulatedBody>();
  expect_held<float, SplitArticulatedBody>();
  expect_held<float, CompositeBody>();
}

TEST(HeldJoint, IsKnownToTheCompiler) {
  expect_rail_held<>();
  expect_rail_held<ArticulatedBody>();
  expect_rail_held<SplitArticulatedBody>();
  expect_rail_held<CompositeBody>();
  expect_rail_held<ArticulatedBody, Looped>();
  expect_rail_held<CompositeBody, Looped>();
}

// The rotor of a joint without any other inertia resists it: nothing is held, and nothing is said.
TEST(HeldJoint, NeedsNoMassWhereThereIsARotor) {
  Arm<double, ArticulatedBody> arm;
  arm.add(body(0.0), 0.3, 0.0, 1.0);
  arm.add(revolute().a(1.0).rotor_inertia(1e-6, 10.0), 0.1, 0.0, 3e-3);
  const auto x = arm.solved();
  EXPECT_TRUE(x.status.ok());
  EXPECT_NEAR(x[1], 30.0, 1e-9);
}
