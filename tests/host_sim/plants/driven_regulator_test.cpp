// The regulator and the filter of an arm whose joints share drives, in the loop on the host.
#include <host_sim/plants/loop/observers.hpp>
#include <host_sim/plants/loop/pushes.hpp>
#include <host_sim/plants/loop/regulators.hpp>

#include <gtest/gtest.h>
#include <cmath>

using namespace host_sim::loop;

namespace {

Case around_wrist_arm(double seconds) {
  Case situation;
  situation.robot = "wrist_arm", situation.seconds = seconds;
  return situation;
}

}  // namespace

TEST(DrivenRegulator, BringsAllDrivesBackFromAPush) {
  auto situation = around_wrist_arm(1.0);
  situation.push = push_of("wrist_arm", -1);
  ASSERT_EQ(situation.push.size(), 5U);
  const auto controller = regulator_on_host("wrist_arm");
  const Recovery r = recover(situation, *controller);
  EXPECT_EQ(r.tracking.refused, 0);
  EXPECT_LT(r.seconds, 0.5);
  EXPECT_LE(r.effort, 1.0 + 1e-6);
}
TEST(DrivenRegulator, FollowsTheMotionMoreCloselyThanTheTrackingImage) {
  const auto regulated = regulator_on_host("wrist_arm");
  const auto plain = on_host("wrist_arm", "float");
  const auto situation = around_wrist_arm(2.0);
  const Tracking by_gains = follow(situation, *regulated), by_pd = follow(situation, *plain);
  EXPECT_EQ(by_gains.refused, 0);
  EXPECT_LT(by_gains.tool_largest, by_pd.tool_largest);
}
TEST(DrivenFilter, KnowsSpeedsBetterThanDifferencesOfOneTickAndOfTen) {
  auto situation = around_wrist_arm(1.0);
  situation.encoder_bits = 14;
  const auto filter = observer_on_host("wrist_arm");
  const VelocityErrors errors = observe(situation, *filter);
  EXPECT_EQ(errors.tracking.refused, 0);
  ASSERT_EQ(errors.filter.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_LT(errors.filter[k], 0.5 * std::fmin(errors.difference[k], errors.slow[k])) << k;
}
