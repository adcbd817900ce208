// The largest of what is measured.
#pragma once

#include <cmath>

namespace host_sim {

/// Raises `largest` to |value|. NaN stays once it was seen: std::max and std::fmax pass it over, as if nothing had been
/// off.
inline void note_size(double& largest, double value) {
  const double size = std::fabs(value);
  if (!(size <= largest) && !std::isnan(largest)) largest = size;
}

}  // namespace host_sim
