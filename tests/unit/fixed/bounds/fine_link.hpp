// What operators on bounds ask of a link where rounding is left out (units of 2^-900), and symmetric matrices of a
// norm.
#pragma once

#include <axial/axial.hpp>
#include <axial/fixed/bounds/separation.hpp>

#include "climb.hpp"

namespace bounds_test {

using axial::Sym3;
using axial::WordRounding;
using axial::bounds::BoundedVector;
using axial::bounds::CompositeBody;

inline constexpr int fine = 900;
inline constexpr WordRounding exact_rounding{32, true, false, 0.0};

inline BoundedVector bounded(const SplitBall& b) { return {b, fine, false, &exact_rounding}; }
inline double any_size(std::mt19937_64& random) {
  return std::pow(10.0, std::uniform_real_distribution<double>(-2.0, 1.0)(random));
}

/// What the operators ask of a link.
struct FineLink {
  template <class Q>
  int exponent(Q) const {
    return fine;
  }
  template <class Q>
  void note(Q, const Ball&) const {}
  template <class Q>
  void leave_room(Q, double) const {}
  template <class Q, class First, class... Terms>
  auto sum(Q, const First& first, const Terms&... terms) const {
    using namespace axial::bounds;
    if constexpr (axial::bounds::detail::is_vector<First>) {
      VectorSum all = vector_of(first);
      (axial::bounds::detail::accumulate(all, vector_of(terms)), ...);
      return bounded(axial::detail::tightened(all.bound));
    } else {
      NumberSum all = term_of(first);
      (axial::bounds::detail::accumulate(all, term_of(terms)), ...);
      return word_of(all.bound, fine);
    }
  }
  template <class F>
  void while_quiet(const F& f) const {
    f();
  }
  const WordRounding& rounding() const { return exact_rounding; }
  const CompositeBody& formatted(const CompositeBody& body) const { return body; }
};

// A symmetric matrix of a norm, in a direction: +-norm n n^T, or a rotation's worth of two of them.
inline Sym3<double> symmetric(double norm, Choice& c) {
  const Vector n = vector_within(1.0, 1.0, 1.0, c), m = vector_within(1.0, 1.0, 1.0, c);
  const double a = norm * c.next(), b = (norm - std::fabs(a)) * c.next();
  const auto entry = [&](double nx, double ny, double mx, double my) { return a * nx * ny + b * mx * my; };
  return {entry(n.x, n.x, m.x, m.x), entry(n.y, n.y, m.y, m.y), entry(n.z, n.z, m.z, m.z),
          entry(n.x, n.y, m.x, m.y), entry(n.x, n.z, m.x, m.z), entry(n.y, n.z, m.y, m.z)};
}
inline Sym3<double> added(const Sym3<double>& a, const Sym3<double>& b, double sign = 1.0) {
  return {a.xx + sign * b.xx, a.yy + sign * b.yy, a.zz + sign * b.zz,
          a.xy + sign * b.xy, a.xz + sign * b.xz, a.yz + sign * b.yz};
}
// The spectral norm by iteration of the square.
inline double norm(const Sym3<double>& s) {
  double largest = 0.0;
  for (Vector v : {Vector{1.0, 0.1, 0.2}, Vector{0.1, 1.0, -0.2}, Vector{-0.1, 0.2, 1.0}}) {
    double length = 0.0;
    for (int step = 0; step < 12; ++step) {
      v = s * (s * v), length = whole(v);
      if (!(length > 0.0)) break;
      v = (1.0 / length) * v;
    }
    largest = std::fmax(largest, std::sqrt(length));
  }
  return largest;
}

}  // namespace bounds_test
