// Arithmetic of bounds: how large a quantity can be, and how far its computed value can be from the exact one.
#pragma once

#include <axial/fixed/words/round.hpp>
#include <axial/scalar/math.hpp>
#include <axial/spatial/mat3.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A vector or number of at most `size` (its norm), computed within `error` (the norm of the difference). Both are
/// worst cases, products hold the second order too: whatever is computed with Balls is proved.
struct Ball {
  double size = 0.0, error = 0.0;  ///< norm of the value, and of its error, at most

  /// Norm of the computed value, at most.
  constexpr double largest() const { return size + error; }
};

/// Bounds of a sum.
constexpr Ball operator+(const Ball& a, const Ball& b) { return {a.size + b.size, a.error + b.error}; }
/// Bounds of a product, its error's second order included.
constexpr Ball operator*(const Ball& a, const Ball& b) {
  return {a.size * b.size, a.size * b.error + b.size * a.error + a.error * b.error};
}
/// A constant multiple; the constant's own rounding is counted where it is rounded.
constexpr Ball operator*(double c, const Ball& b) { return {magnitude(c) * b.size, magnitude(c) * b.error}; }

/// How an arithmetic rounds, for the analysis: its word, its modes, and the error of a sine or cosine.
struct WordRounding {
  int bits;                 ///< of a word
  bool nearest, high_word;  ///< results to nearest or down; products exact or by their upper word
  double turn_error;        ///< of one sine or cosine of a joint
  bool tabled = false;      ///< constants come from a table, each column at one exponent: the looped form

  constexpr double capacity() const { return detail::power_of_two(bits - 1) - 1.0; }  ///< largest raw value of a word
  /// The exponent of a quantity that reaches at most `size`, with a little room for its rounding errors.
  constexpr int exponent(double size) const {
    const double room = 1.0 + 256.0 / detail::power_of_two(bits - 1);
    return detail::fitting_exponent(size * room, capacity());
  }
  /// Unit of numbers at an exponent.
  static constexpr double ulp(int exponent) { return detail::power_of_two(-exponent); }
  /// Error of one stored component at an exponent.
  constexpr double store(int exponent) const { return (nearest ? 0.5 : 1.0) * ulp(exponent); }
  /// Error of a component moved to an exponent; nothing is lost on the way to a finer one.
  constexpr double move(int from, int to) const { return from <= to ? 0.0 : store(to); }
};

/// Rounding of an arithmetic S whose sines and cosines come from axial::sincos.
template <class S>
constexpr WordRounding rounding_of(bool tabled = false) {
  return {S::bits, S::nearest, S::high_word,
          integer::sincos_error + (S::bits == 32 ? 0.0 : detail::power_of_two(-S::unit - 1)), tabled};
}

/// A vector: its part across the z axis, its part along it, and the whole.
struct SplitBall {
  Ball across{}, along{}, whole{};  ///< bound of that part, and of the whole
};

namespace detail {

inline constexpr double root2 = 1.4142135623730951, root3 = 1.7320508075688772;

constexpr double least(double a, double b) { return a < b ? a : b; }
/// The square root from above, within 2e-12 of it: Newton's steps from the halved exponent end above.
constexpr double root_bound(double x) {
  if (!(x > 0.0)) return 0.0;
  double root = __builtin_bit_cast(double, (__builtin_bit_cast(std::uint64_t, x) >> 1) + (std::uint64_t{1023} << 51));
  for (int step = 0; step < 3; ++step)
    root = (root + x / root) * 0.5;
  return root * (1.0 + 1e-15);
}
constexpr double hypotenuse(double a, double b) {
  if (!(a > 0.0 || a < 0.0)) return b < 0.0 ? -b : b;
  if (!(b > 0.0 || b < 0.0)) return a < 0.0 ? -a : a;
  return root_bound(a * a + b * b);
}
/// The largest row sum of a symmetric 3x3 matrix, which bounds its spectral norm.
constexpr double largest_row(const Sym3<double>& s) {
  const double xy = magnitude(s.xy), xz = magnitude(s.xz), yz = magnitude(s.yz);
  const double x = magnitude(s.xx) + xy + xz, y = magnitude(s.yy) + xy + yz, z = magnitude(s.zz) + xz + yz;
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}
constexpr Ball least(const Ball& a, const Ball& b) { return {least(a.size, b.size), least(a.error, b.error)}; }
constexpr Ball hypotenuse(const Ball& a, const Ball& b) {
  return {hypotenuse(a.size, b.size), hypotenuse(a.error, b.error)};
}

constexpr void tighten(double& across, double& along, double& whole) {
  whole = least(whole, hypotenuse(across, along));
  across = least(across, whole), along = least(along, whole);
}
/// Each of the three bounds the others.
constexpr SplitBall tightened(SplitBall v) {
  tighten(v.across.size, v.along.size, v.whole.size);
  tighten(v.across.error, v.along.error, v.whole.error);
  return v;
}
constexpr SplitBall split(const Ball& across, const Ball& along) { return {across, along, hypotenuse(across, along)}; }

}  // namespace detail

/// Bounds of a sum of vectors.
constexpr SplitBall operator+(const SplitBall& u, const SplitBall& v) {
  return detail::tightened({u.across + v.across, u.along + v.along, u.whole + v.whole});
}
/// Bounds of a constant multiple.
constexpr SplitBall operator*(double c, const SplitBall& v) { return {c * v.across, c * v.along, c * v.whole}; }

/// A vector after a rounding of `step` in each component.
constexpr SplitBall rounded(SplitBall v, double step) {
  v.across.error += detail::root2 * step, v.along.error += step, v.whole.error += detail::root3 * step;
  return detail::tightened(v);
}
/// After a turn about x: z takes from across, across from z.
constexpr SplitBall turned_about_x(const SplitBall& v, double sine, double cosine) {
  const double s = magnitude(sine), c = magnitude(cosine);
  if (!(s > 0.0)) return v;
  return detail::tightened({v.across + s * v.along, s * v.across + c * v.along, v.whole});
}

}  // namespace axial

#include <axial/options/end.hpp>
