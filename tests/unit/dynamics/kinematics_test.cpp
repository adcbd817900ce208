#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <robots/planar2r.hpp>
#include <robots/robots.hpp>

using namespace axial;

namespace {

struct Mounted {
  static constexpr auto chain =
      axial::chain(base({{0, -1, 0, 1, 0, 0, 0, 0, 1}, {1.0, 2.0, 3.0}}), revolute().mass(1), tool(0.5, 0.0, 0.25));
};

struct Branched {  // the tool is on link 2, whose path leads past link 1
  static constexpr auto chain =
      axial::chain(revolute().mass(1), revolute().a(0.3).mass(1), revolute().a(0.5).mass(1).parent(0), tool(0.2, 0, 0));
};

struct Bare {
  static constexpr auto chain = axial::chain(revolute(), prismatic().a(0.2).alpha_deg(90));
};

}  // namespace

TEST(Kinematics, BaseAndToolFrameTheChain) {
  const Joints<Mounted, double> q{0.0};
  const auto pose = forward_kinematics<Mounted>(q).tool.position;
  EXPECT_EQ(pose.x, 1.0);
  EXPECT_EQ(pose.y, 2.5);  // the base turns x into y
  EXPECT_EQ(pose.z, 3.25);
}

TEST(Kinematics, AMasslessChainCompiles) {
  const Joints<Bare, float> q{0.0F, 0.5F};
  EXPECT_NEAR(forward_kinematics<Bare>(q).tool.position.y, -0.5F, 1e-6F);
}

TEST(Jacobian, OfALinkIsThatOfItsOrigin) {
  const Joints<Branched, double> q{0.3, 0.4, 0.5};
  const auto j = jacobian<Branched, 1>(q);
  const auto origin = forward_kinematics<Branched>(q).frames[1].position;
  EXPECT_EQ(j[0].linear.x, -origin.y);
  EXPECT_EQ(j[0].linear.y, origin.x);
  EXPECT_EQ(j[1].angular.z, 1.0);
  EXPECT_EQ(j[1].linear.x, 0.0);   // its origin lies on its axis
  EXPECT_EQ(j[2].angular.z, 0.0);  // the other branch
  EXPECT_EQ((jacobian<Scene<Branched, Looped>, 1>(q)[0].linear.y), origin.x);
}

TEST(Jacobian, HasNoColumnForJointsThatDoNotCarryTheTool) {
  const Joints<Branched, double> q{0.3, 0.4, 0.5};
  const auto j = jacobian<Branched>(q);
  EXPECT_EQ(j[1].angular.z, 0.0);
  EXPECT_EQ(j[1].linear.x, 0.0);
  EXPECT_EQ(j[0].angular.z, 1.0);
  EXPECT_EQ(j[2].angular.z, 1.0);
}

// Positions that are numbers each may add up to one that is none.
TEST(Kinematics, OfAModelSayWhatOverflows) {
  using M = Model<2>;
  M model;
  ASSERT_TRUE(model.add(prismatic().mass(1)));
  ASSERT_TRUE(model.add(prismatic().mass(1)));
  const Joints<M, float> near_by{0.5F, 0.25F}, far_out{2e38F, 3e38F};
  EXPECT_TRUE(forward_kinematics(model, near_by).status.ok());
  EXPECT_EQ(forward_kinematics(model, far_out).status.code, Status::Code::not_finite);
}
