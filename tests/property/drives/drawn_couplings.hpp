// What couples the joints of robots that numbers alone describe, as their numbers have it.
#pragma once

#include "constrained.hpp"
#include "driven_robots.hpp"

namespace constrained {

/// G of a drawn robot as its numbers have it, without the library's matrix.
template <int Number>
Couplings drawn_couplings() {
  using R = property::Coupled<Number>;
  Couplings c{Matrix<quad>(R::n, R::n), Vector<quad>(std::size_t(R::n), quad(0)), {}};
  for (int i = 0; i < R::n; ++i) {
    c.owner.push_back(i);
    c.g(i, i) = R::number(50 * i + 40) > 0.0 ? 0.7 : -1.3;
    for (int k = 0; k < i; ++k)
      if (R::number(50 * i + 20 + k) > -0.3) c.g(i, k) = 1.5 * R::number(50 * i + 30 + k);
  }
  return c;
}

}  // namespace constrained
