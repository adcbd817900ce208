// Bounds of vectors in a link's frame: across and along its joint's axis, which a turn of the joint keeps apart.
#pragma once

#include <axial/fixed/balls/ball.hpp>
#include <axial/spatial/mat3.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A vector: its part across the z axis, its part along it, and the whole.
struct SplitBall {
  Ball across{}, along{}, whole{};  ///< bound of that part, and of the whole
};

namespace detail {

inline constexpr double root2 = 1.4142135623730951, root3 = 1.7320508075688772;

constexpr double least(double a, double b) { return a < b ? a : b; }
/// The square root from above, within 1e-13 of it: Newton's steps from the halved exponent end above.
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
