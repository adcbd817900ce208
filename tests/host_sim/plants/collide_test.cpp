// Contacts of 5 % of a joint's effort limit are found within 10 ms and nothing else is; `./axial collide` runs 10
// minutes.
#include <gtest/gtest.h>
#include <host_sim/plants/collide/collide.hpp>
#include <host_sim/plants/collide/payload.hpp>

#include <cmath>

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

// Errors are of encoders, of torque noise, of wrong parameters (1 %) and of the inertia that is left out.
TEST(Collide, PayloadsAreWeighedTo25GramsAnd10GramMetres) {
  const auto rows = host_sim::collide::weigh(20.0, 5);
  EXPECT_EQ(rows.size(), 7U);
  for (const auto& row : rows) {
    SCOPED_TRACE(testing::Message() << row.robot << ' ' << row.mass << " kg");
    EXPECT_TRUE(row.sure);
    EXPECT_EQ(row.refused, 0);
    EXPECT_LT(std::fabs(row.mass_error), 0.025);
    EXPECT_LT(row.moment_error, 0.010);
    EXPECT_GT(row.moment_error, 1e-5);  // noise is there
    EXPECT_GT(row.ready, 0.1);
    EXPECT_LT(row.ready, 10.0);
  }
}
