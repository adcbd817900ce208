// constexpr helpers that C++17's <cmath> does not have.
#pragma once

#include <axial/scalar/select.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Square root by Newton's iteration, within 1 ulp; NaN for negative arguments. Meant for constants: it loops.
template <class T>
constexpr T square_root(T x) {
  if (!(x > T(0)) || x > (std::numeric_limits<T>::max)())
    return x == T(0) || x > T(0) ? x : std::numeric_limits<T>::quiet_NaN();
  T scale = T(1);
  while (x >= T(4))
    x *= T(0.25), scale *= T(2);
  while (x < T(1))
    x *= T(4), scale *= T(0.5);
  T root = (x + T(1)) * T(0.5);
  for (T last = T(0); root != last;) {
    last = root;
    const T next = (root + x / root) * T(0.5);
    root = next < last ? next : last;  // monotone from above, so it ends
  }
  return root * scale;
}

}  // namespace axial

#include <axial/options/end.hpp>
