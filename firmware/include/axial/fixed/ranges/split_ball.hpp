// Bounds of vectors in a link's frame: across and along its joint's axis, which a turn of the joint keeps apart.
#pragma once

#include <axial/fixed/ranges/ball.hpp>

namespace axial {

/// A vector: its part across the z axis, its part along it, and the whole.
struct SplitBall {
  Ball across{}, along{}, whole{};  ///< bound of that part, and of the whole
};

namespace detail {

inline constexpr double root2 = 1.4142135623730951, root3 = 1.7320508075688772;

constexpr double least(double a, double b) { return a < b ? a : b; }
constexpr double hypotenuse(double a, double b) { return square_root(a * a + b * b); }
constexpr Ball least(const Ball& a, const Ball& b) { return {least(a.size, b.size), least(a.error, b.error)}; }
constexpr Ball hypotenuse(const Ball& a, const Ball& b) {
  return {hypotenuse(a.size, b.size), hypotenuse(a.error, b.error)};
}

/// Each of the three bounds the others.
constexpr SplitBall tightened(const SplitBall& v) {
  const Ball whole = least(v.whole, hypotenuse(v.across, v.along));
  return {least(v.across, whole), least(v.along, whole), whole};
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
/// After a rounding of two components across the axis.
constexpr SplitBall rounded_across(SplitBall v, double step) {
  v.across.error += detail::root2 * step, v.whole.error += detail::root2 * step;
  return detail::tightened(v);
}
/// After a turn about x: z takes from across, across from z.
constexpr SplitBall turned_about_x(const SplitBall& v, double sine, double cosine) {
  const double s = magnitude(sine), c = magnitude(cosine);
  if (!(s > 0.0)) return v;
  return detail::tightened({v.across + s * v.along, s * v.across + c * v.along, v.whole});
}
/// r x f for r along z, and for r along x.
constexpr SplitBall cross_along_z(double r, const SplitBall& f) { return detail::split(r * f.across, Ball{}); }
/// For r along x.
constexpr SplitBall cross_along_x(double r, const SplitBall& f) {
  return detail::tightened({magnitude(r) * f.along, magnitude(r) * f.across, magnitude(r) * f.whole});
}

/// What a body's rotation does to the points of it: U = dw~ + w~ w~ (gyration.hpp). `entry` is the rounding of one
/// entry of U beyond what w and dw carry.
struct SpinBall {
  SplitBall w{}, dw{};  ///< of angular velocity (rad/s) and angular acceleration (rad/s^2)
  double entry = 0.0;   ///< rad^2/s^2

  /// U r for r = (x, y, z) with |(x, y)| = side and |z| = height.
  constexpr SplitBall times(double side, double height) const {
    const Ball ww = w.whole * w.whole, wz = w.across * w.along, wo = w.across * w.across;
    const SplitBall from_side{side * (dw.along + ww), side * (dw.across + wz), side * (dw.whole + ww)};
    const SplitBall from_height = detail::split(height * (dw.across + wz), height * wo);
    const SplitBall exact = detail::tightened(from_side) + from_height;
    return detail::tightened(rounded(exact, (side * detail::root2 + height) * entry));
  }
  /// Of one entry, and of U r per metre whatever the direction.
  constexpr Ball strength() const {
    Ball s = dw.whole + w.whole * w.whole;
    s.error += 3.0 * entry;
    return s;
  }
};

}  // namespace axial
