// Jacobians of what the oracle computes: central differences of fourth order in 113 bits, exact to some 24 digits.
#pragma once

#include <oracle/algebra.hpp>

namespace oracle {

/// By q and by qd: entry (i, j) is the slope of value i along joint j.
struct Jacobians {
  Matrix<quad> by_position, by_velocity;
};

namespace detail {

/// Column j of a Jacobian; `at` is the function with joint j moved by so much.
template <class F>
void put_slopes(Matrix<quad>& slopes, int j, const quad& h, const F& at) {
  const Vector<quad> near_above = at(h), near_below = at(-h), far_above = at(h + h), far_below = at(-h - h);
  for (std::size_t i = 0; i < near_above.size(); ++i)
    slopes(static_cast<int>(i), j) =
        (quad(8) * (near_above[i] - near_below[i]) - (far_above[i] - far_below[i])) / (quad(12) * h);
}

inline Vector<quad> moved(Vector<quad> values, int j, const quad& by) {
  values[static_cast<std::size_t>(j)] += by;
  return values;
}

}  // namespace detail

/// What is left out, h^4, and rounding over h are both below 1e-24.
inline quad usual_step() { return quad(1) / quad(1LL << 20); }

/// Of f(q, qd), a vector with a value for each joint.
template <class F>
Jacobians differences(const Vector<quad>& q, const Vector<quad>& qd, const F& f, const quad& step = usual_step()) {
  const int n = static_cast<int>(q.size());
  Jacobians result{Matrix<quad>(n, n), Matrix<quad>(n, n)};
  for (int j = 0; j < n; ++j) {
    detail::put_slopes(result.by_position, j, step, [&](const quad& by) { return f(detail::moved(q, j, by), qd); });
    detail::put_slopes(result.by_velocity, j, step, [&](const quad& by) { return f(q, detail::moved(qd, j, by)); });
  }
  return result;
}

}  // namespace oracle
