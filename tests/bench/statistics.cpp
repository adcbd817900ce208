#include <algorithm>
#include <bench/statistics.hpp>
#include <cmath>
#include <stdexcept>

namespace bench {

// P(fewer than k of n values below the median) is the sum of binomials 2^-n C(n, i), i < k.
int interval_rank(int count, double confidence) {
  const double outside = (1.0 - confidence) / 2.0;
  double below = 0.0;
  int rank = 0;
  for (; rank < count / 2; ++rank) {
    const double n = count, i = rank;
    below += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) - n * std::log(2.0));
    if (below > outside) break;
  }
  return std::max(rank - 1, 0);
}

Median median_of(std::vector<double> sample, double confidence) {
  if (sample.empty()) throw std::invalid_argument("median_of: no values");
  std::sort(sample.begin(), sample.end());
  const std::size_t n = sample.size(), rank = static_cast<std::size_t>(interval_rank(static_cast<int>(n), confidence));
  return {(sample[(n - 1) / 2] + sample[n / 2]) / 2.0, sample[rank], sample[n - 1 - rank]};
}

}  // namespace bench
