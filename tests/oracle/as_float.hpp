// Numbers that float, double and quad share.
#pragma once

namespace oracle {

/// The float nearest to x, as a double. Stored on the way: GCC 12 forgets the rounding where it vectorises two such
/// casts beside each other (-O2, -ftree-slp-vectorize), and then float would be given another problem than double.
template <class T>
double as_float(const T& x) {
  const volatile auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest);
}

}  // namespace oracle
