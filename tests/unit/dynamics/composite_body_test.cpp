// Forward dynamics by composite bodies: what the elimination leaves out, and what it says of singular joints.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <robots/robots.hpp>

using namespace axial;

namespace {

constexpr Link arm(double x) { return revolute().a(x).mass(1.0).com(0.1, 0.05, 0.02).inertia_com(0.01, 0.02, 0.03); }

// Two branches of two joints on a common link; nothing couples the branches but that link.
struct Branched {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, -9.81), arm(0.0), arm(0.3).alpha_deg(90.0), arm(0.2),
                                             arm(0.4).alpha_deg(-90.0).parent(0), arm(0.25));
};
// A gantry: the axes are perpendicular, so M is diagonal.
struct Gantry {
  static constexpr auto chain =
      axial::chain(gravity(0.0, 0.0, -9.81), prismatic().mass(3.0),
                   prismatic().alpha_deg(90.0).theta_deg(90.0).mass(2.0), prismatic().alpha_deg(90.0).mass(1.0));
};

template <class R>
constexpr auto& present = crba::structure<StaticLinks<scene_of<R>, double, BaseParameters>>.present;

template <class S>
auto solved(double first) {
  Joints<robot_of<S>, double> q{}, qd{}, tau{};
  for (int i = 0; i < q.size; ++i)
    q[i] = 0.3 + 0.4 * i, qd[i] = 0.5 - 0.2 * i, tau[i] = first + i;
  return forward_dynamics<S>(q, qd, tau);
}

}  // namespace

TEST(CompositeBody, BranchesDoNotMeetInTheElimination) {
  for (int i : {3, 4})
    for (int j : {1, 2})
      EXPECT_FALSE(present<Branched>[i][j]) << i << " " << j;
  for (int i = 0; i < 5; ++i)
    EXPECT_TRUE(present<Branched>[i][0] && present<Branched>[i][i]) << i;
}

template <class R>
void expect_limbs_apart() {
  using Full = StaticLinks<scene_of<R>, double, BaseParametersAndRotors>;
  const auto moves = [](int j, int i) {
    while (i > j)
      i = R::chain.parent(i);
    return i == j;
  };
  for (int i = 0; i < R::chain.size; ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_TRUE(moves(j, i) || !crba::structure<Full>.present[i][j]) << i << ' ' << j;
}
TEST(CompositeBody, LimbsOfTheTreesAreApart) {
  expect_limbs_apart<robots::TwoArm>();
  expect_limbs_apart<robots::Torso>();
}

TEST(CompositeBody, PerpendicularAxesDoNotMeetEither) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_FALSE(present<Gantry>[i][j]) << i << " " << j;
}

TEST(CompositeBody, AgreesWithArticulatedBodiesOnATree) {
  const auto composite = solved<Scene<Branched, Gravity, CompositeBody>>(1.0),
             looped = solved<Scene<Branched, Gravity, CompositeBody, Looped>>(1.0),
             articulated = solved<Scene<Branched, Gravity, ArticulatedBody>>(1.0);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(composite[i], articulated[i], 1e-10);
    EXPECT_NEAR(looped[i], articulated[i], 1e-10);
  }
  EXPECT_TRUE(composite.status.ok());
}

// Two coaxial joints and nothing between them: the inner one has no inertia of its own.
TEST(CompositeBody, NamesASingularJointAndStaysFinite) {
  using M = Model<2, Gravity, CompositeBody>;
  M model;
  ASSERT_TRUE(model.add(revolute()));
  ASSERT_TRUE(model.add(revolute().mass(1.0).inertia_com(0.1, 0.1, 0.1)));
  const auto qdd = forward_dynamics(model, Joints<M, float>{}, Joints<M, float>{}, Joints<M, float>{1.0F, 2.0F});
  EXPECT_EQ(qdd.status.code, Status::Code::near_singular);
  EXPECT_EQ(qdd.status.joint, 0);
  EXPECT_EQ(qdd[0], 0.0F);
  EXPECT_FLOAT_EQ(qdd[1], 20.0F);
}

TEST(Route, IsTheOneThatTheSceneNames) {
  static_assert(forward_dynamics_route<Scene<Gantry, ArticulatedBody>> == Route::articulated_body);
  static_assert(forward_dynamics_route<Scene<Gantry, SplitArticulatedBody>> == Route::split_articulated_body);
  static_assert(forward_dynamics_route<Scene<Gantry, CompositeBody>> == Route::composite_body);
  static_assert(forward_dynamics_route<Gantry> == Route::composite_body, "three joints: the elimination is cheaper");
}
