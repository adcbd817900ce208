// doc/guides/observer.md: a collision in a control loop. doc/guides/safety.md: a fall-back in one.
#include <gtest/gtest.h>

namespace {

#include "observer-1.inc"

TEST(Observer, AnArmAtRestThatDoesWhatItsEffortsSayTouchesNothing) {
  const axial::Joints<Robot, float> q{0.1F, -0.4F, 0.3F, -1.2F, 0.5F, 1.6F, 0.2F}, still{};
  const auto hold = axial::gravity_torque<Robot>(q);
  for (int k = 0; k < 100; ++k)
    EXPECT_FALSE(tick(q, still, hold));
}

TEST(Observer, AnEffortThatMovesNothingIsAContact) {
  const axial::Joints<Robot, float> q{0.1F, -0.4F, 0.3F, -1.2F, 0.5F, 1.6F, 0.2F}, still{};
  auto pushed = axial::gravity_torque<Robot>(q);
  pushed[1] += 20.0F;
  bool felt = false;
  for (int k = 0; k < 100; ++k)
    felt = tick(q, still, pushed) || felt;
  EXPECT_TRUE(felt);
}

}  // namespace

namespace {
namespace fall_back {

using Robot = robots::Panda;
using Joints = axial::Joints<Robot, float>;
#include "safety-1.inc"

TEST(Safety, DrivesAreHeldThenDisabled) {
  Drives drives;
  bool enable = true;
  drives.tick(enable);
  EXPECT_FALSE(enable) << "nothing was asked for";
  const Joints q{0.1F, -0.4F, 0.3F, -1.2F, 0.5F, 1.6F, 0.2F}, still{}, fast{100.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F};
  drives.request(q, fast, still);
  const Joints held = drives.tick(enable), weight = axial::gravity_torque<Robot>(q);
  EXPECT_TRUE(enable) << "the arm does not fall";
  EXPECT_EQ(held[1], weight[1]);
  drives.request(q, still, still);
  for (int k = 0; k < 20 + 50 + 1000; ++k) {
    EXPECT_TRUE(enable);
    drives.tick(enable);
  }
  EXPECT_FALSE(enable);
}

#include "safety-2.inc"

TEST(Safety, AControlledStopBrakesThenHolds) {
  axial::Request<Robot, float> wanted{
      {0.1F, -0.4F, 0.3F, -1.2F, 0.5F, 1.6F, 0.2F}, {1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F}, {}, {}};
  EXPECT_TRUE(request_or_brake(wanted, axial::inverse_dynamics<Robot>(wanted.q, wanted.qd, wanted.qdd)));
  brake.advance(20);
  EXPECT_EQ(brake.phase(), axial::DrivePhase::fading);
  brake.advance(500);
  EXPECT_EQ(brake.phase(), axial::DrivePhase::holding);
  EXPECT_EQ(brake.wanted().qd[0], 0.0F);
  EXPECT_GT(brake.wanted().q[0], 0.1F);
}

}  // namespace fall_back
}  // namespace
