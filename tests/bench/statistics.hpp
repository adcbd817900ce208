// Median of a sample and an interval that holds the population's median, without a model of the noise.
#pragma once

#include <vector>

namespace bench {

struct Median {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// Median, and the narrowest symmetric pair of order statistics that encloses the population's median with at least
/// the given confidence (binomial: Conover 1999, section 3.2). A sample too small for it gives its extremes.
/// Independent, identically distributed values; an empty sample throws std::invalid_argument.
Median median_of(std::vector<double> sample, double confidence = 0.95);

/// Rank (from 0) of the lower order statistic of that interval; the upper one is count - 1 - rank.
int interval_rank(int count, double confidence);

}  // namespace bench
