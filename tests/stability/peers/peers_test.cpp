// Few instances of the short scenarios; ./axial stability --compare runs all of them.
#include <gtest/gtest.h>
#include <stability/peers/compare.hpp>

namespace {

using stability::Comparison;
using stability::Scalar;

/// A model of ours in an engine's terms that were wrong would make us look good.
TEST(StabilityPeers, AgreeWithTheReferenceWhereNothingIsExtreme) {
  const auto peers = stability::all_peers();
  int compared = 0;
  for (const auto& scenario : cases::scenarios())
    for (const char* gentle : {"S00_arm6_nominal", "S02_3d_alternating_N12", "S10_speed_2^5", "S15_telescope_N10"})
      if (scenario.name == gentle)
        for (const Comparison& row : stability::compare(scenario, peers, 3)) {
          const double digits = row.scalar == "double" ? 1e-13 : 1e-4;
          EXPECT_LE(row.nominal_error, digits) << gentle << " " << row.engine << " " << row.scalar;
          EXPECT_LE(row.engine_error, digits) << gentle << " " << row.engine << " " << row.scalar;
          ++compared;
        }
  EXPECT_EQ(compared, 4 * static_cast<int>(peers.size()));
}

TEST(StabilityPeers, NoneIsTenTimesMoreExactThanOurArticulatedBodies) {
  const auto peers = stability::all_peers();
  for (const auto& scenario : cases::scenarios()) {
    if (scenario.size() > 12) continue;
    for (const Comparison& row : stability::compare(scenario, peers, 9))
      EXPECT_TRUE(row.pass) << row.scenario << " " << row.engine << " " << row.scalar << ": " << row.engine_error
                            << ", ours " << row.our_error;
  }
}

}  // namespace
