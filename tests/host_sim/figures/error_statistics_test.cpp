#include <host_sim/tools/analysis/error_statistics.hpp>
#include <host_sim/tools/analysis/joint_scales.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using host_sim::ErrorStatistics;

TEST(ErrorStatistics, LargestAndRootMeanSquare) {
  ErrorStatistics errors;
  errors.add(1.0, 1.5);
  errors.add(-2.0, -1.0);
  errors.add(0.0, 0.0);
  EXPECT_DOUBLE_EQ(errors.largest(), 1.0);
  EXPECT_DOUBLE_EQ(errors.rms(), std::sqrt(1.25 / 3.0));
}

TEST(ErrorStatistics, ScaleIsTheReferencesLargestMagnitude) {
  ErrorStatistics errors;
  errors.add(3.9, -4.0);
  errors.add(20.0, 2.0);
  EXPECT_DOUBLE_EQ(errors.scale(), 4.0);
}

TEST(ErrorStatistics, NotFiniteCanNotBeMissed) {
  ErrorStatistics errors;
  errors.add(1.0, 1.0);
  errors.add(std::nan(""), 1.0);
  EXPECT_TRUE(std::isinf(errors.largest()));
  EXPECT_TRUE(std::isinf(errors.rms()));
}

TEST(Largest, IsOfMagnitudes) {
  double largest = 0.0;
  for (const double value : {0.5, -2.0, 1.0})
    host_sim::note_size(largest, value);
  EXPECT_EQ(largest, 2.0);
  host_sim::note_size(largest, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(largest, std::numeric_limits<double>::infinity());
}

// What is no number is not passed over, and what comes after it does not hide it.
TEST(Largest, WhatIsNoNumberStays) {
  double largest = 3.0;
  for (const double value : {1.0, std::numeric_limits<double>::quiet_NaN(), 5.0, 0.0}) {
    host_sim::note_size(largest, value);
    EXPECT_EQ(std::isnan(largest), value != 1.0);
  }
}

TEST(Range, KeepsSmallestAndLargest) {
  host_sim::Range range;
  for (const unsigned value : {5u, 3u, 9u})
    range.add(value);
  EXPECT_EQ(range.min, 3u);
  EXPECT_EQ(range.max, 9u);
}

TEST(JointScales, EveryLoadedJointHasItsOwn) {
  EXPECT_EQ(host_sim::joint_scales({40.0, 1e-3, 7.0}), (std::vector<double>{40.0, 1e-3, 7.0}));
}

TEST(JointScales, AnIdleJointTakesTheMostLoadedOnes) {
  EXPECT_EQ(host_sim::joint_scales({0.0, 40.0, 1e-20}), (std::vector<double>{40.0, 40.0, 40.0}));
}

}  // namespace
