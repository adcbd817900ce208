// The gates of every family, in double and float, by every route; a residual could not see what they see.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <oracle/random_chain.hpp>
#include <stability/ablation.hpp>
#include <stability/rows.hpp>
#include <stability/textbook.hpp>

namespace {

using stability::Route;
using stability::Row;
using stability::Scalar;
using stability::Scenario;

void expect_passed(const std::vector<Row>& rows) {
  ASSERT_FALSE(rows.empty());
  for (const Row& row : rows)
    EXPECT_TRUE(row.pass) << row.scenario << ", " << row.scalar << ", " << row.route << ": forward " << row.forward
                          << " of " << row.gate.forward << ", backward " << row.backward << " of " << row.gate.backward
                          << ", " << row.status;
}

Scenario named(const std::string& name) {
  for (const Scenario& scenario : cases::scenarios())
    if (scenario.name == name) return scenario;
  throw std::out_of_range("no such scenario: " + name);
}

class StabilityFamily : public testing::TestWithParam<const char*> {};

TEST_P(StabilityFamily, IsInsideItsGates) {
  expect_passed(stability::all_rows(GetParam(), [](const std::string&) {}));
}

INSTANTIATE_TEST_SUITE_P(Stability, StabilityFamily,
                         testing::Values("S00", "S01", "S02", "S03", "S04", "S05", "S06", "S07", "S08", "S09", "S10",
                                         "S11", "S12", "S13", "S14", "S15", "S16", "S17"),
                         [](const auto& family) { return std::string(family.param); });

/// Ten links and what composite bodies lose of seven digits.
TEST(Stability, TheResidualDoesNotSeeWhatCompositeBodiesLose) {
  const Scenario rods = named("S01_zigzag_N30");
  const auto reference = stability::reference_of(rods);
  const auto lost = stability::solve(rods, Route::composite_body, Scalar::in_float).qdd;
  const auto kept = stability::solve(rods, Route::articulated_body, Scalar::in_float).qdd;
  EXPECT_GT(forward_error(rods, reference, lost), 1e3 * forward_error(rods, reference, kept));
  EXPECT_LT(backward_error(rods, reference, lost), 1e-6);
}

TEST(Stability, ConditionOfRodsGrowsWithTheFourthPowerOfTheirNumber) {
  for (const int n : {10, 30, 100}) {
    const Scenario rods = named("S01_straight_N" + std::to_string(n));
    EXPECT_NEAR(stability::condition(rods.chain, rods.q) / (4.0 * std::pow(n, 4)), 1.0, 0.12) << n;
  }
}

TEST(Stability, HealthyChainsAreNotFlagged) {
  for (const char* name : {"S00_arm6_nominal", "S06_zyx_massless_eps2^-5", "S07_3R_m101", "S07_3R_m011"})
    for (const Scalar scalar : stability::scalars)
      EXPECT_TRUE(stability::solve(named(name), Route::articulated_body, scalar).status.ok()) << name;
}

// Straight, the massless links leave nothing that resists the first joint; the second is resisted by the cube's
// turning.
TEST(Stability, ASingularJointIsNamed) {
  for (const char* name : {"S07_PP_mA0_mB1(singular)", "S07_3R_m001_straight(sing)"})
    for (const Scalar scalar : stability::scalars)
      EXPECT_EQ(stability::solve(named(name), Route::articulated_body, scalar).status.joint, 0) << name;
}

/// A joint between two massless links leaves nothing across it, exactly. What is left instead is nothing or a last
/// place of the mass, which 0.1 degrees magnify by 3e5; which of the two is luck, and both heaps are large. So the
/// median that ST7 asks for is met by a few instances in a hundred, and the textbook's is not.
TEST(Stability, AlmostHalfOfTheNearlyStraightMasslessElbowsKeepNoDigitsInFloat) {
  oracle::RandomChains random(7);
  constexpr int instances = 2000;
  int lost = 0, lost_by_textbook = 0;
  for (int k = 0; k < instances; ++k) {
    const Scenario elbow = cases::massless_elbow(random.uniform(0.1, 0.4), oracle::right_angle<double>() / 900.0);
    const auto reference = stability::reference_of(elbow, false);
    const auto answer = stability::solve(elbow, Route::articulated_body, Scalar::in_float);
    EXPECT_EQ(answer.status.code, axial::Status::Code::near_singular);
    lost += forward_error(elbow, reference, answer.qdd) > 1e-6;
    lost_by_textbook += forward_error(elbow, reference, stability::textbook<float>(elbow, {})) > 1e-6;
  }
  EXPECT_LT(lost, instances / 2);
  EXPECT_GT(lost, instances * 2 / 5);
  EXPECT_GT(lost_by_textbook, instances / 2);
}

double error_of(const std::vector<stability::AblationRow>& rows, const char* scenario, const char* scalar,
                const char* variant) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) {
    return row.scenario == scenario && row.scalar == scalar && row.variant == variant;
  });
  return found == rows.end() ? std::nan("") : found->forward;
}

/// Leaving one of the improvements out costs digits somewhere; with all of them nothing does.
TEST(Stability, EachImprovementOfArticulatedBodiesIsNeeded) {
  const auto rows = stability::ablation();
  const auto factor = [&](const char* scenario, const char* without) {
    return error_of(rows, scenario, "float", without) / error_of(rows, scenario, "float", "axial");
  };
  EXPECT_GT(factor("S11_farcom_2^10", "2+3"), 1e3);            // 1: bias from angular velocities
  EXPECT_GT(factor("S03_taper_N20", "1+3"), 1e3);              // 2: no product of two U
  EXPECT_GT(factor("S17_zyx_eps2^-14_rot2^-20", "1+2"), 1e3);  // 3: exact row and column
  for (const auto& row : rows)
    if (row.variant == "axial") {
      const double all = error_of(rows, row.scenario.c_str(), row.scalar.c_str(), "1+2+3");
      const double eps = stability::epsilon_of(row.scalar == "double" ? Scalar::in_double : Scalar::in_float);
      EXPECT_LE(row.forward, std::max(4.0 * all, 8.0 * eps)) << row.scenario << " " << row.scalar;
    }
}

}  // namespace
