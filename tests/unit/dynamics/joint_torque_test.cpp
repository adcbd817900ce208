#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <robots/puma560.hpp>

using namespace axial;

namespace {

constexpr Link body(const Link& link, double k) {
  return link.mass(2.0 + k).com(0.1 * k, 0.05, -0.07).inertia_com(0.1, 0.2, 0.15, 0.01, 0.005 * k, 0.03).viscous(k);
}
// A trunk with two branches.
struct Tree {
  static constexpr auto chain = axial::chain(
      axial::gravity(0, 0, -9.81), body(revolute().alpha(0.3), 1.0), body(prismatic().alpha_deg(90).a(0.2), 2.0),
      body(revolute().alpha_deg(-90).d(0.1).parent(0), 3.0), body(revolute().alpha(0.7).a(0.3).parent(1), 4.0),
      body(prismatic().alpha(1.1).a(0.3).parent(2), 5.0));
};
constexpr double rounding = 1e-14;  // relative to torques of some 100 N m

template <class S, int I, class J>
void expect_part_of_the_whole(const J& q, const J& qd, const J& qdd) {
  EXPECT_NEAR((joint_torque<S, I>(q, qd, qdd)), inverse_dynamics<S>(q, qd, qdd)[I], 100 * rounding) << I;
  EXPECT_NEAR((gravity_torque<S, I>(q)), gravity_torque<S>(q)[I], 100 * rounding) << I;
}
template <class S, int... I>
void expect_parts_of_the_whole(std::integer_sequence<int, I...>) {
  using R = robot_of<S>;
  Joints<R, double> q{}, qd{}, qdd{};
  for (int i = 0; i < joint_count<R>; ++i)
    q[i] = 0.3 - 0.4 * i, qd[i] = 0.5 + 0.3 * i, qdd[i] = 1.0 - i;
  (expect_part_of_the_whole<S, I>(q, qd, qdd), ...);
}

}  // namespace

TEST(JointTorque, IsOneOfInverseDynamics) {
  using Five = std::make_integer_sequence<int, 5>;
  expect_parts_of_the_whole<Tree>(Five{});
  expect_parts_of_the_whole<Scene<Tree, Gravity, Friction>>(Five{});
  expect_parts_of_the_whole<Scene<Tree, Gravity, Friction, Looped>>(Five{});
  expect_parts_of_the_whole<robots::Puma560>(std::integer_sequence<int, 0, 2, 5>{});
}

TEST(JointTorque, OfARunTimeModel) {
  Model<6, Gravity, RotorInertia> model;
  for (const auto& link : Tree::chain.links)
    ASSERT_TRUE(model.add(link));
  const Joints<decltype(model), double> q{0.1, 0.2, 0.3, 0.4, 0.5}, qd{1, 2, 3, 4, 5}, qdd{5, 4, 3, 2, 1};
  const auto tau = inverse_dynamics(model, q, qd, qdd), g = gravity_torque(model, q);
  for (int i = 0; i < model.size(); ++i) {
    EXPECT_NEAR(joint_torque(model, i, q, qd, qdd), tau[i], 1000 * rounding) << i;
    EXPECT_NEAR(gravity_torque(model, i, q), g[i], 1000 * rounding) << i;
  }
}
