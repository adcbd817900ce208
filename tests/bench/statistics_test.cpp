#include <gtest/gtest.h>
#include <bench/statistics.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

namespace {

using bench::interval_rank;
using bench::median_of;

// Conover 1999, table A3: the two-sided 95 % interval of a median.
TEST(BenchStatistics, RanksAreTheBinomialTables) {
  EXPECT_EQ(interval_rank(6, 0.95), 0);   // 2 * 1/64 = 3.1 %
  EXPECT_EQ(interval_rank(9, 0.95), 1);   // 2 * 10/512 = 3.9 %
  EXPECT_EQ(interval_rank(20, 0.95), 5);  // 2 * 21700/2^20 = 4.1 %
  EXPECT_EQ(interval_rank(20, 0.99), 3);  // 2 * 1351/2^20 = 0.26 %
  EXPECT_EQ(interval_rank(100, 0.95), 39);
}

TEST(BenchStatistics, SmallSampleGivesItsExtremes) {
  const auto m = median_of({3.0, 1.0, 2.0});
  EXPECT_EQ(m.value, 2.0);
  EXPECT_EQ(m.low, 1.0);
  EXPECT_EQ(m.high, 3.0);
  EXPECT_THROW(median_of({}), std::invalid_argument);
}

TEST(BenchStatistics, MedianOfAnEvenSampleIsTheMean) { EXPECT_EQ(median_of({4.0, 1.0, 2.0, 3.0}).value, 2.5); }

// A preempted round is thirty times too long: median and interval hardly see it.
TEST(BenchStatistics, OutliersMoveNothing) {
  std::vector<double> sample;
  for (int i = 0; i < 101; ++i)
    sample.push_back(10.0 + 0.001 * i);
  auto disturbed = sample;
  for (int i = 0; i < 5; ++i)
    disturbed[std::size_t(i)] = 300.0;
  EXPECT_NEAR(median_of(disturbed).value, median_of(sample).value, 0.006);
  EXPECT_LE(median_of(disturbed).high, 10.1);
}

// The interval holds the true median in at least 95 of 100 samples (and not always: it is not needlessly wide).
TEST(BenchStatistics, IntervalCoversTheMedian) {
  std::mt19937 engine(1);
  int held = 0;
  const int trials = 2000;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> sample;
    for (int i = 0; i < 31; ++i)
      sample.push_back(-std::log((static_cast<double>(engine()) + 0.5) / 4294967296.0));  // exponential
    const auto m = median_of(sample);
    held += m.low <= std::log(2.0) && std::log(2.0) <= m.high;
  }
  EXPECT_GE(held, trials * 0.95 - 20);
  EXPECT_LE(held, trials * 0.99);
}

}  // namespace
