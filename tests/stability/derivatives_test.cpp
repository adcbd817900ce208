// Derivatives on stiff and extreme chains: inside their gates, block by block, and the reference is exact enough for
// them.
#include <gtest/gtest.h>
#include <oracle/compare.hpp>
#include <stability/derivatives.hpp>

namespace {

TEST(StabilityOfDerivatives, IsInsideItsGates) {
  const auto rows = stability::derivative_rows("", [](const std::string&) {});
  EXPECT_GE(rows.size(), 60 * 2 * stability::blocks);
  for (const auto& row : rows)
    EXPECT_TRUE(row.pass) << row.scenario << ", " << row.scalar << ", " << row.block << ": " << row.error << " of "
                          << row.gate << ", " << row.status;
}

// Twice ten links that grow or shrink by two each: what the differences are off by is magnified 1e28 times.
TEST(StabilityOfDerivatives, TheReferenceDoesNotDependOnItsStep) {
  for (const auto& scenario : stability::derived_scenarios()) {
    const auto wide = stability::derivative_reference(scenario), narrow = stability::derivative_reference(scenario, 1);
    const bool extreme = scenario.family == "ST3" && scenario.size() == 20;
    for (std::size_t b = 0; b < stability::blocks; ++b)
      EXPECT_LE(oracle::relative_error(narrow.exact[b], wide.exact[b]), extreme ? 1e-9 : 1e-18)
          << scenario.name << ", " << name_of(static_cast<stability::Block>(b));
  }
}

}  // namespace
