// doc/observer.md: a collision in a control loop.
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
