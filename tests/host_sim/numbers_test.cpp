// Errors of the number systems, on the same states.
#include <gtest/gtest.h>

#include <host_sim/numbers/errors.hpp>

#include <map>
#include <stdexcept>

namespace {

// The reference and the states are those of every system, or double would be far from them.
void expect_exact(const numbers::Row& in_double) {
  EXPECT_LT(in_double.error, 4 * 2.3e-16);
  EXPECT_GT(in_double.error, 0.0);
}

void expect_better(const numbers::Row& in_fixed, const numbers::Row& in_float) {
  const double times = in_fixed.algorithm == "closed_form" ? 50.0 : 5.0;
  EXPECT_LT(times * in_fixed.error, in_float.error);
}

using Systems = std::map<std::string, numbers::Row>;

void check(const Systems& systems) {
  expect_exact(systems.at("double"));
  expect_better(systems.at("fixed32"), systems.at("float"));
  for (const char* name : {"fixed16", "fixed32", "fixed32_down", "fixed32_high"}) {
    SCOPED_TRACE(name);
    const numbers::Row& row = systems.at(name);
    ASSERT_TRUE(row.certified.has_value());
    EXPECT_LE(row.error, *row.certified);
    EXPECT_LT(row.error_rms, row.error);
  }
}

TEST(Numbers, FixedPointIsWithinItsCertifiedErrorAndBetterThanFloat) {
  int checked = 0;
  for (const std::string& robot : numbers::robots()) {
    std::map<std::string, Systems> algorithms;
    for (const numbers::Row& row : numbers::rows(robot))
      algorithms[row.algorithm].emplace(row.scalar, row);
    for (const auto& [algorithm, systems] : algorithms) {
      SCOPED_TRACE(robot + ", " + algorithm);
      check(systems), ++checked;
    }
  }
  EXPECT_EQ(checked, 4);
}

TEST(Numbers, UnknownRobotsAreNamed) {
  try {
    numbers::rows("puma");
    FAIL() << "no robot is called so";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "unknown robot 'puma'; there are: scara, puma560, panda");
  }
}

}  // namespace
