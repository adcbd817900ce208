// doc/guides/guide.md: an arm by hand, its tick, its cost.
#include <gtest/gtest.h>
#include <axial/cost.hpp>
#include <limits>

#include "guide-1.inc"

namespace {

#include "guide-2.inc"
#include "guide-3.inc"

TEST(Guide, ATickIsSafe) {
  const axial::Joints<MyArm, float> q{0.1F, -0.5F, 0.4F}, qd{0.5F, 0.2F, -0.3F}, qdd{1.0F, 2.0F, -1.0F};
  const auto good = tick(q, qd, qdd);
  ASSERT_TRUE(good.status.ok());
  auto spoilt = q;
  spoilt[1] = std::numeric_limits<float>::quiet_NaN();
  const auto held = tick(spoilt, qd, qdd);
  EXPECT_FALSE(held.status.ok());
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(held.tau[i], good.tau[i]);
}

}  // namespace
