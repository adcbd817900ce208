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

/// A motion at an instant: positions and their four derivatives by time.
struct Path {
  Vector<quad> q, qd, qdd, q3, q4;

  /// k-th derivative at time t of the polynomial that these are of.
  Vector<quad> at(int k, const quad& t) const {
    const Vector<quad>* all[] = {&q, &qd, &qdd, &q3, &q4};
    Vector<quad> result(q.size(), quad(0));
    quad term = 1;
    for (int order = k; order <= 4; ++order) {
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += term * (*all[order])[i];
      term = term * t / quad(order - k + 1);
    }
    return result;
  }
};
/// A vector with both its derivatives by time.
struct RatesInTime {
  Vector<quad> value, first, second;
};
/// Of f(q, qd, qdd) along a path: central differences of second order, exact to some 17 digits.
template <class F>
RatesInTime rates_in_time(const Path& path, const F& f) {
  const quad h = quad(1) / quad(1LL << 29);
  const auto at = [&](const quad& t) { return f(path.at(0, t), path.at(1, t), path.at(2, t)); };
  const Vector<quad> before = at(-h), now = at(quad(0)), after = at(h);
  RatesInTime result{now, now, now};
  for (std::size_t i = 0; i < now.size(); ++i) {
    result.first[i] = (after[i] - before[i]) / (h + h);
    result.second[i] = (after[i] - now[i] - (now[i] - before[i])) / (h * h);
  }
  return result;
}

}  // namespace oracle
