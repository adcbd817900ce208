// Errors of the kernels in every number system, on the same states.
#include <gtest/gtest.h>

#include <host_sim/figures/errors/errors.hpp>

#include <map>
#include <set>
#include <stdexcept>

namespace {

using errors::Row;

constexpr double last_bit_of_double = 2.3e-16;

// The reference and the states are those of every system, or double would be far from them.
void expect_exact(const Row& in_double) {
  EXPECT_LT(in_double.error, 4 * last_bit_of_double);
  EXPECT_GT(in_double.error, 0.0);
}

void expect_better(const Row& in_fixed, const Row& in_float) {
  const double times = in_fixed.kernel.algorithm == "closed_form" ? 50.0 : 5.0;
  EXPECT_LT(times * in_fixed.error, in_float.error);
}

using Systems = std::map<std::string, Row>;

void check(const Systems& systems) {
  expect_exact(systems.at("double"));
  expect_better(systems.at("fixed32"), systems.at("float"));
  for (const char* name : {"fixed16", "fixed32", "fixed32_down", "fixed32_high"}) {
    SCOPED_TRACE(name);
    const Row& row = systems.at(name);
    ASSERT_TRUE(row.certified.has_value());
    EXPECT_LE(row.error, *row.certified);
    EXPECT_LT(row.error_rms, row.error);
  }
}

/// Bare and unrolled, by robot and number system.
std::map<std::string, Systems> of(const char* algorithm) {
  std::map<std::string, Systems> robots;
  for (const Row& row : errors::rows({"", algorithm, ""}))
    if (row.kernel.scene == "bare" && row.kernel.variant == "unrolled")
      robots[row.kernel.robot].emplace(row.kernel.scalar, row);
  return robots;
}

TEST(Errors, FixedPointIsWithinItsCertifiedErrorAndBetterThanFloat) {
  int checked = 0;
  for (const char* algorithm : {"inverse_dynamics", "closed_form"})
    for (const auto& [robot, systems] : of(algorithm)) {
      SCOPED_TRACE(robot + ", " + algorithm);
      check(systems), ++checked;
    }
  EXPECT_EQ(checked, 4);
}

// What the mass matrix amplifies in an acceleration's error is not the kernel's: as torque, a few last bits on any
// route.
TEST(Errors, AccelerationsAreExactInTheTorqueThatTheyStandFor) {
  std::set<std::string> algorithms;
  for (const Row& row : errors::rows({"scara", "", ""})) {
    if (!row.error_torque) continue;
    SCOPED_TRACE(row.kernel.algorithm + " in " + row.kernel.scalar);
    algorithms.insert(row.kernel.algorithm);
    const double unit = row.kernel.scalar == "double" ? last_bit_of_double : 1.2e-7;
    EXPECT_GT(*row.error_torque, 0.0);
    EXPECT_LT(*row.error_torque, 8 * unit);
    EXPECT_LT(*row.error_torque, row.error);
  }
  EXPECT_EQ(algorithms.size(), 4U);  // the compiler's choice and each route
}

TEST(Errors, OfEveryJobAreThoseOfTheNumberSystem) {
  std::set<std::string> algorithms;
  for (const Row& row : errors::rows({"scara", "", "double"})) {
    SCOPED_TRACE(row.kernel.algorithm);
    algorithms.insert(row.kernel.algorithm);
    const bool solves = row.error_torque || row.kernel.algorithm == "forward_dynamics_derivatives";
    EXPECT_LT(row.error, (solves ? 64 : 4) * last_bit_of_double);
  }
  EXPECT_GE(algorithms.size(), 6U);
}

/// Of a block's largest entry over all states; of that in the same state, in 99 of 100; and of that in every state, but
/// of a hundredth of that over all states where all of a block cancels to less.
struct Bounds {
  double error, in_most_states, in_state;
};
// What the mass matrix amplifies is more on the Panda, whose wrist is light; its accelerations have what
// forward_dynamics() has. Words, which are as fine in every state, have more bits than float where an entry is large
// and fewer where all of a block cancels.
Bounds bounds_of(const Row& row, const std::string& block) {
  const bool in_double = row.kernel.scalar == "double", forward = row.kernel.algorithm[0] == 'f';
  const bool light = forward && row.kernel.robot == "panda";
  if (in_double) return {1e-13, 2e-14, 2e-13};
  if (row.kernel.scalar == "fixed32")
    return {light ? 4e-5 : forward ? 3e-7 : 5e-8, light ? 1e-4 : forward ? 3e-6 : 1e-6, light ? 2e-4 : 3e-5};
  if (light) return {block == "qdd" ? 1e-5 : 5e-6, 8e-6, 2e-5};
  return {block == "qdd" ? 2e-6 : 1e-6, forward ? 4e-6 : 1e-6, 1e-5};
}

class ErrorsOfDerivatives : public testing::TestWithParam<const char*> {};

TEST_P(ErrorsOfDerivatives, OverTwoThousandStates) {
  int checked = 0;
  for (const char* algorithm : {"inverse_dynamics_derivatives", "forward_dynamics_derivatives"})
    for (const Row& row : errors::rows({GetParam(), algorithm, ""})) {
      EXPECT_EQ(row.states, 2000);
      ASSERT_EQ(row.blocks.size(), 4U);
      for (const errors::Block& block : row.blocks) {
        SCOPED_TRACE(row.kernel.robot + ", " + row.kernel.variant + ", " + row.kernel.scalar + ", " + block.name);
        const Bounds most = bounds_of(row, block.name);
        EXPECT_LE(block.error, most.error);
        EXPECT_LE(block.error_in_most_states, most.in_most_states);
        EXPECT_LE(block.error_uncancelled, most.in_state);
        EXPECT_GE(block.error_in_state, block.error_in_most_states);
        EXPECT_GT(block.error, row.kernel.scalar == "double" ? 1e-17 : row.kernel.scalar == "fixed32" ? 1e-9 : 1e-8);
        ++checked;
      }
    }
  EXPECT_EQ(checked, 4 * 2 * 4) << "kernels, algorithms, blocks";
}
INSTANTIATE_TEST_SUITE_P(Robots, ErrorsOfDerivatives, testing::Values("scara", "puma560", "panda"),
                         [](const auto& robot) { return std::string(robot.param); });

// Against Spong's equations: motors of an arm behind harmonic drives.
TEST(Errors, OfMotorsBehindSpringsAreThoseOfTheNumberSystem) {
  std::set<std::string> robots;
  for (const Row& row : errors::rows({"", "elastic_feedforward", ""})) {
    EXPECT_EQ(row.kernel.scene, "elastic");
    EXPECT_EQ(row.states, 2000);
    ASSERT_EQ(row.blocks.size(), 4U);
    robots.insert(row.kernel.robot + ", " + row.kernel.scalar + ", " + row.kernel.variant);
    for (const errors::Block& block : row.blocks) {
      SCOPED_TRACE(row.kernel.robot + ", " + row.kernel.variant + ", " + row.kernel.scalar + ", " + block.name);
      const double unit = row.kernel.scalar == "double" ? last_bit_of_double : 1.2e-7;
      EXPECT_LT(block.error, 8 * unit);
      EXPECT_GT(block.error, 0.01 * unit);
    }
  }
  EXPECT_EQ(robots.size(), 3U * 3U) << "scara, puma560, panda: float in both forms, double";
}

TEST(Errors, UnknownNamesAreListed) {
  const auto error_of = [](const errors::Choice& choice) -> std::string {
    try {
      errors::rows(choice);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of({"puma", "", ""}), "unknown robot 'puma'; there are: panda, puma560, scara");
  EXPECT_NE(error_of({"", "dynamics", ""}).find("unknown algorithm 'dynamics'; there are: bias,"), std::string::npos);
  EXPECT_NE(error_of({"", "", "fixed8"}).find("unknown number system 'fixed8'"), std::string::npos);
}

}  // namespace
