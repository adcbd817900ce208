// What the default route is judged by.
#include <gtest/gtest.h>
#include <algorithm>
#include <axial/dynamics/route.hpp>
#include <axial/robot/chain.hpp>
#include <cmath>
#include <vector>

using namespace axial;

namespace {

constexpr auto rod(double mass) {
  return revolute().a(1).mass(mass).com(0.5, 0, 0).inertia_com(1.0 / 1024, 1.0 / 12, 1.0 / 12);
}

template <int tenths>
struct TwoRods {  // the outer one weighs that many tenths of the inner one
  static constexpr auto chain = axial::chain(rod(0.0625), rod(0.00625 * tenths));
};
struct HeavyTip {  // seven rods of 1 kg, the last of 6 kg: elimination loses 13 bits, though no joint by itself does
  static constexpr auto chain =
      axial::chain(rod(1), rod(1).alpha(1.0 / 1024), rod(1).alpha(1.0 / 1024), rod(1).alpha(1.0 / 1024),
                   rod(1).alpha(1.0 / 1024), rod(1).alpha(1.0 / 1024), rod(6).alpha(1.0 / 1024));
};
struct Hollow {
  static constexpr auto chain = axial::chain(revolute(), revolute().mass(1).inertia_com(1, 1, 1));
};
struct Limited {
  static constexpr auto chain = axial::chain(revolute().mass(1).inertia_com(1, 1, 1).position_limits(0.5, 1.0),
                                             revolute().mass(1).inertia_com(1, 1, 1),
                                             prismatic().a(0.25).d(-0.5).mass(1).position_limits(-0.75, -0.25),
                                             prismatic().a(1).mass(1), axial::payload_limit(1, 0.1, 0.01));
};

template <class R>
double loss() {
  double worst = 0.0;
  for (int sample = 0; sample < detail::loss_samples; ++sample)
    worst = std::max(worst, detail::loss_at<Scene<R>, false>(sample, detail::infinite_loss));
  return worst;
}

double position(int sample, int joint) { return detail::sampled_position(Limited::chain.links, 4, sample, joint); }

double most(int joints, JointType last = JointType::revolute, double twist_deg = 0.0) {
  std::vector<LinkParameters> links(static_cast<std::size_t>(joints));
  links.back().type = last, links.back().alpha = Angle::from_degrees(twist_deg);
  return detail::acceptable_loss(links.data(), joints);
}

}  // namespace

TEST(Samples, LieInsideTheLimitsAndDiffer) {
  for (int joint = 0; joint < 4; ++joint) {
    const auto& link = Limited::chain.links[joint];
    const double low = joint == 1 ? -3.1416 : joint == 3 ? -1.76 : link.position_min;
    const double high = joint == 1 ? 3.1416 : joint == 3 ? 1.76 : link.position_max;
    for (int sample = 0; sample < detail::loss_samples; ++sample) {
      const double q = position(sample, joint);
      EXPECT_GE(q, low) << joint;
      EXPECT_LE(q, high) << joint;
      EXPECT_NE(q, position(sample + 1, joint));
    }
  }
  EXPECT_EQ(position(0, 0), 0.5) << "the first is the arm as drawn, as near as limits allow";
  EXPECT_EQ(position(0, 1), 0.0);
  EXPECT_EQ(position(0, 2), -0.25);
}

TEST(EliminationLoss, GrowsWithWhatALightLinkCarries) {
  EXPECT_LT(loss<TwoRods<10>>(), most(2));
  EXPECT_LT(loss<TwoRods<10>>(), loss<TwoRods<1000>>());
  EXPECT_LT(loss<TwoRods<1000>>(), loss<TwoRods<100000>>());
  EXPECT_GT(loss<TwoRods<100000>>(), most(2));
}

TEST(EliminationLoss, ThatIsAcceptedGrowsToSevenJoints) {
  EXPECT_DOUBLE_EQ(most(7), 64.0);
  EXPECT_DOUBLE_EQ(most(12), 64.0);
  EXPECT_DOUBLE_EQ(most(2), 128.0 / 7.0);
}

TEST(EliminationLoss, ThatIsAcceptedIsHalfWhereSlidesAndTurnsMeet) {
  EXPECT_DOUBLE_EQ(most(7, JointType::prismatic, 90.0), 32.0);
  EXPECT_DOUBLE_EQ(most(2, JointType::prismatic, 30.0), 64.0 / 7.0);
  EXPECT_DOUBLE_EQ(most(7, JointType::prismatic, 180.0), 64.0) << "all axes are parallel";
  EXPECT_DOUBLE_EQ(most(7, JointType::revolute, 90.0), 64.0);
}

TEST(EliminationLoss, IsWithoutBoundWhereAJointHasNoInertiaOfItsOwn) { EXPECT_GE(loss<Hollow>(), 1e300); }

TEST(EliminationLoss, OfAPayloadThatIsNotDeclaredIsUnknown) {
  static_assert(detail::elimination_loses_little<Scene<TwoRods<10>>>);
  static_assert(!detail::elimination_loses_little<Scene<TwoRods<10>, Payload>>);
  SUCCEED();
}

TEST(EliminationLoss, IsNotComputedWhereItIsSeenToBeTooMuch) {
  using Heavy = Scene<TwoRods<100000>>;
  for (int sample = 0; sample < detail::loss_samples; ++sample) {
    const double all = detail::loss_at<Heavy, false>(sample, detail::infinite_loss);
    const double seen = detail::loss_at<Heavy, false>(sample, most(2));
    EXPECT_LE(seen, all);
    EXPECT_EQ(seen > most(2), all > most(2));
  }
}

TEST(EliminationLoss, CompoundsAlongTheChain) { EXPECT_GT(loss<HeavyTip>(), most(7)); }

TEST(Route, OfFewWellConditionedJointsIsEliminationAndOfOthersAba) {
  static_assert(forward_dynamics_route<TwoRods<10>> == Route::composite_body);
  static_assert(forward_dynamics_route<TwoRods<100000>> == Route::articulated_body);
  static_assert(forward_dynamics_route<Hollow> == Route::articulated_body);
  static_assert(forward_dynamics_route<Scene<TwoRods<10>, Gravity, Payload>> == Route::articulated_body);
  static_assert(forward_dynamics_route<Scene<TwoRods<10>, Gravity, Underwater>> == Route::articulated_body);
  SUCCEED();
}
