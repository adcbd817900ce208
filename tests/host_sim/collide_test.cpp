// Contacts of 5 % of a joint's effort limit are found within 10 ms and nothing else is; `./axial collide` runs 10
// minutes.
#include <gtest/gtest.h>
#include <host_sim/collide/collide.hpp>

namespace {

void expect_found(const char* scalar) {
  const auto row = host_sim::collide::run(scalar, 60.0, 11);
  EXPECT_EQ(row.contacts, 40);
  EXPECT_EQ(row.delays.size(), 40U);
  EXPECT_EQ(row.missed, 0);
  EXPECT_EQ(row.false_alarms, 0);
  EXPECT_EQ(row.refused, 0);
  EXPECT_LE(row.longest(), 0.010);
  EXPECT_GT(row.longest(),
            0.003);  // a lag of 1/gain and a confirmation: sooner would be an alarm that was there before
  EXPECT_LT(row.headroom, 1.0);
  EXPECT_GT(row.headroom, 0.2);
}

}  // namespace

TEST(Collide, FloatFindsContactsAndNothingElse) { expect_found("float"); }
TEST(Collide, FixedPointFindsContactsAndNothingElse) { expect_found("fixed32"); }
