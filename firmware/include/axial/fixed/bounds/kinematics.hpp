// Errors of poses and of the Jacobian: their kernels, run on bounds. Rows of a rotation are vectors in a link's frame,
// so a joint's turn keeps them; positions and directions in the world are known by their norms alone.
#pragma once

#include <axial/dynamics/kinematics.hpp>
#include <axial/fixed/bounds/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace bounds {

/// Columns of a rotation.
///@{
constexpr BoundedVector z_column(const Rotation& r) {
  return detail::direction(r, r.x.bound.along.error, r.y.bound.along.error, r.z.bound.along.error);
}
constexpr BoundedVector x_column(const Rotation& r) {
  return detail::direction(r, r.x.bound.across.error, r.y.bound.across.error, r.z.bound.across.error);
}
///@}

/// A constant pose seen through a pose of words, the tool on the last link: each component of its origin adds three
/// products of a literal and an entry. Its axes are the caller's to round.
constexpr BoundedPose operator*(const BoundedPose& frame, const BoundedPose& tool) {
  using detail::hypotenuse;
  const double offset = tool.position.bound.whole.size;
  const Rotation& r = frame.rotation;
  const double error = hypotenuse(hypotenuse(r.x.bound.whole.error, r.y.bound.whole.error), r.z.bound.whole.error);
  Terms terms;
  if (offset > 0.0) terms.add_word(frame.position.exponent);
  for (int i = 0; i < 3 && offset > 0.0; ++i)
    terms.add_scaled(offset, r.x.exponent, 1.0);
  Ball whole = frame.position.bound.whole + Ball{offset, offset * error};
  whole.error += detail::root3 * terms.rounding(frame.position.exponent, *r.x.rounding);
  return {r, detail::anywhere(whole, frame.position.exponent, r.x.rounding)};
}

/// Bounds of the tool's Jacobian.
template <int N>
struct JacobianBounds {
  Row<BoundedMotion, N> columns{};                          ///< angular (1), linear (m or 1)
  constexpr auto& operator[](int i) { return columns[i]; }  ///< of joint i
};

namespace detail {

using NoLoads = BoundedScene<false, false>;

// Positions of all links share a format, which holds the whole arm and the number 1.
template <int N>
constexpr Account<N> positions(const Mechanism<N>& m, const WordRounding& r) {
  Account<N> account{m, r};
  double longest = m.loads.base_offset + m.loads.tool_offset;
  for (int i = 0; i < N; ++i)
    longest += m.origin_distance(i);
  for (LinkSizes& widest : account.widest)
    widest.of[place_of(quantity::Length{}).index()] = longest > 1.0 ? longest : 1.0;
  account.choose_formats();
  return account;
}

template <int N>
constexpr Ranges<N> poses(const Mechanism<N>& m, const WordRounding& r, Wanted wanted) {
  Account<N> account = positions(m, r);
  if (wanted == Wanted::formats) return account.ranges;
  const BoundedLinks<NoLoads, N> links(account);
  const JointBounds<N> at(m, r);
  const auto frames = kinematics::frames(links, GivenLoads{}, at.q);
  for (int i = 0; i < N; ++i) {
    const auto& of = frames[i].rotation;
    LinkRange& range = account.ranges.range[i];
    range.length = frames[i].position.bound.whole;
    const double across =
        of.x.bound.whole.error > of.y.bound.whole.error ? of.x.bound.whole.error : of.y.bound.whole.error;
    range.rotation = {1.0, across > of.z.bound.whole.error ? across : of.z.bound.whole.error};
  }
  return account.ranges;
}

}  // namespace detail

/// Bounds of the tool's Jacobian in the formats that `ranges` say.
template <int N>
constexpr JacobianBounds<N> jacobian_bounds(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges) {
  const Mechanism<N> in_formats = r.tabled ? axial::detail::sharing(m, r, ranges) : m;
  Account<N> account{in_formats, r, false, false, ranges};
  const BoundedLinks<detail::NoLoads, N> links(account);
  const detail::JointBounds<N> at(in_formats, r);
  const auto frames = kinematics::frames(links, GivenLoads{}, at.q);
  const auto tool = frames[N - 1] * constant_pose(m.loads.tool_offset, r);
  JacobianBounds<N> all;
  kinematics::columns(links, frames, N - 1, links.link(N - 1).sum(quantity::Length{}, tool.position), all);
  return all;
}

}  // namespace bounds

/// Ranges and errors of the poses of frames, and their formats: every position has one, which holds the whole arm and
/// the number 1; entries of rotations and directions that of sines. `length` bounds a position, `rotation` the rows of
/// a rotation.
template <int N>
constexpr Ranges<N> kinematics_ranges(const Mechanism<N>& m, const WordRounding& r, Wanted wanted = Wanted::errors) {
  return detail::ranges_by(m, r, wanted,
                           [&r](const Mechanism<N>& of, Wanted part) { return bounds::detail::poses(of, r, part); });
}

}  // namespace axial

#include <axial/options/end.hpp>
