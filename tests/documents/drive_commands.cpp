// doc/guides/drive_commands.md: servos that are told positions, motors that get hot.
#include <gtest/gtest.h>

#include <cmath>

#include <axial/axial.hpp>
#include <robots/puma560.hpp>

namespace {

#include "drive_commands-1.inc"
#include "drive_commands-2.inc"

using Values = axial::Joints<Robot, float>;
const Values q{0.1F, -0.4F, 0.3F, 0.2F, 0.5F, 0.6F};

TEST(DriveCommandsPage, ServosAreToldWhatMakesThemExertTheTorque) {
  told.last = q;
  Values positions{};
  ASSERT_TRUE(command(q, {}, {}, positions));
  const auto tau = axial::inverse_dynamics<Arm>(q, Values{}, Values{});
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(servos.stiffness[i] * (positions[i] - q[i]), tau[i], 1e-3F);
  Values bad = q;
  bad[2] = NAN;
  EXPECT_FALSE(command(bad, {}, {}, positions));
  EXPECT_EQ(positions[1], told.last[1]);
}

TEST(DriveCommandsPage, AShareOfTheSagIsLeft) {
  for (const double share : {0.5, 0.8, 0.9, 1.0, 1.1, 1.25, 2.0}) {
    const double k = 100.0 * share, tau = 10.0, sag = tau / 100.0;
    const double held = tau / k - tau / 100.0;
    EXPECT_NEAR(held / sag, 1.0 / share - 1.0, 1e-12);
  }
}

TEST(DriveCommandsPage, WindingsStandWhatIsLetThrough) {
  Values torque{};
  const axial::TrackingGains<Arm, float> gains{{3000, 3000, 3000, 100, 100, 100}, {}};
  Values ahead = q;
  ahead[0] += 1.0F;
  for (int n = 0; n < 100; ++n)
    ASSERT_TRUE(drive({ahead, {}, {}, {}}, {q, {}, {}}, gains, torque).met());
  EXPECT_LE(std::fabs(torque[0]), 3.0F * 0.25F * 100.0F * 0.8F) << "hot, so no more than the continuous effort";
  EXPECT_NEAR(torque[0], 3.0F * 0.25F * 100.0F * 0.8F, 1e-3F);
}

}  // namespace
