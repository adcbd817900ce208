// Errors of poses and of the Jacobian: their kernels, run on bounds. Rows of a rotation are vectors in a link's frame,
// so a joint's turn keeps them; positions and directions in the world are known by their norms alone.
#pragma once

#include <axial/dynamics/kinematics.hpp>
#include <axial/fixed/bounds/links.hpp>

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

/// A pose seen through a pose of words, the tool on the last link: each component of its origin adds three products of
/// an entry with a literal or, of a run-time tool, a word. Its axes are the caller's to round.
constexpr BoundedPose operator*(const BoundedPose& frame, const BoundedPose& tool) {
  using detail::hypotenuse;
  const double offset = tool.position.bound.whole.size;
  const Rotation& r = frame.rotation;
  const double error = hypotenuse(hypotenuse(r.x.bound.whole.error, r.y.bound.whole.error), r.z.bound.whole.error);
  Terms terms;
  if (offset > 0.0) terms.add_word(frame.position.exponent);
  for (int i = 0; i < 3 && offset > 0.0; ++i)
    if (tool.position.is_literal)
      terms.add_scaled(offset, r.x.exponent, 1.0);
    else
      terms.add_product(r.x.exponent + tool.position.exponent);
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
  double longest = m.loads.base_offset + m.loads.tool_reach;
  for (int i = 0; i < N; ++i)
    longest += m.origin_distance(i);
  for (LinkSizes& widest : account.widest)
    widest.of(quantity::Length{}) = longest > 1.0 ? longest : 1.0;
  account.choose_formats();
  return account;
}

template <int N>
constexpr auto frames_of(const KernelStart<NoLoads, N>& start) {
  return kinematics::frames(start.links, start.in, start.at.q);
}

template <int N>
constexpr Ranges<N> poses(const Mechanism<N>& m, const WordRounding& r, Wanted wanted) {
  Account<N> account = positions(m, r);
  if (wanted == Wanted::formats) return account.ranges;
  const auto frames = frames_of(KernelStart<NoLoads, N>(account));
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

// The tool as kernels see it: a constant, or words.
constexpr BoundedPose tool_pose(const LoadRange& l, const WordRounding& r) {
  if (!l.tool_given) return constant_pose(l.tool_offset, r);
  return given_pose(l.tool_reach, input_exponent(l.tool_reach, r), r);
}
}  // namespace detail

/// Errors of the tool's pose: of its origin (m) and of an entry of its rotation.
struct ToolError {
  double position = 0.0, rotation = 0.0;  ///< m; dimensionless
};
/// Bounds of the tool's pose in the formats that `ranges` say.
template <int N>
constexpr ToolError tool_error(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges) {
  auto account = account_in_formats(m, r, ranges);
  const auto frames = detail::frames_of(detail::KernelStart<detail::NoLoads, N>(account));
  const Rotation& axes = frames[N - 1].rotation;
  const auto tool = detail::tool_pose(m.loads, r);
  Terms entry;
  for (int k = 0; k < 3; ++k)
    if (m.loads.tool_given)
      entry.add_product(axes.x.exponent + tool.rotation.x.exponent);
    else
      entry.add_scaled(1.0, axes.x.exponent, 1.0);
  double row = 0.0;
  for (const BoundedVector* each : {&axes.x, &axes.y, &axes.z})
    row = each->bound.whole.error > row ? each->bound.whole.error : row;
  constexpr double longest_axis = 1.0 + 1.0 / 2048.0;  // beyond it a run-time tool is no frame
  return {(frames[N - 1] * tool).position.bound.whole.error, longest_axis * row + entry.rounding(r.bits - 2, r)};
}
/// Bounds of the tool's Jacobian in the formats that `ranges` say.
template <int N>
constexpr JacobianBounds<N> jacobian_bounds(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges) {
  auto account = account_in_formats(m, r, ranges);
  const detail::KernelStart<detail::NoLoads, N> start(account);
  const auto frames = detail::frames_of(start);
  const auto tool = frames[N - 1] * detail::tool_pose(m.loads, r);
  JacobianBounds<N> all;
  const auto point = start.links.link(N - 1).sum(quantity::Length{}, tool.position);
  kinematics::columns(start.links, frames, N - 1, point, all);
  return all;
}

}  // namespace bounds

/// Ranges and errors of the poses of frames, and their formats: every position has one, which holds the whole arm and
/// the number 1; entries of rotations and directions that of sines. `length` bounds a position, `rotation` the rows of
/// a rotation.
template <int N>
constexpr Ranges<N> kinematics_ranges(const Mechanism<N>& m, const WordRounding& r, Wanted wanted = Wanted::errors) {
  using bounds::detail::poses;
  return poses(r.tabled ? detail::sharing(m, r, poses(m, r, Wanted::formats)) : m, r, wanted);
}

}  // namespace axial

#include <axial/options/end.hpp>
