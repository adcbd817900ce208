// Ranges and errors of the poses of frames. doc/ranges.md is the proof.
#pragma once

#include <axial/fixed/ranges/newton_euler.hpp>

namespace axial {
namespace detail {

template <int N>
constexpr Ranges<N> pose_ranges(const Mechanism<N>& m, const Rounding& r) {
  Ranges<N> all;
  double longest = m.loads.base_offset;
  for (int i = 0; i < N; ++i)
    longest += m.reach(i);
  longest += m.loads.tool_offset;
  const int unit = r.bits - 2, format = m.format(r, &LinkFormat::length, longest > 1.0 ? longest : 1.0);
  for (int i = 0; i < N; ++i) {
    const auto &c = m.links[i], &k = m.factors(i);
    const int p = m.parent(i);
    const Ball up = p < 0 ? Ball{1.0, 3.0 * r.store(unit)} : all.range[p].rotation;
    LinkRange& own = all.range[i];
    const double turn = c.prismatic ? 0.0 : root2 * r.turn_error;
    const double sine = m.steps.shared ? 1.5 : 0.71;  // its exponent is what counts
    const double step =
        root2 * (r.products(2, unit, unit, unit) + r.sum(unit, {Factor{sine, unit, 1.0}, Factor{sine, unit, 1.0}}));
    own.rotation = {1.0, up.error + (1.0 + up.error) * turn + 2.0 * step};
    const Ball from = p < 0 ? Ball{m.loads.base_offset, r.store(format)} : all.range[p].length;
    const bool stored = c.prismatic || m.steps.shared;  // the shift, in its format
    const double products = stored ? r.products(1, unit, format, format) + 2.0 * r.store(format) : 0.0;
    const double rounding =
        root3 *
        (products + r.sum(format, {Factor{k.a, unit, 1.0}, Factor{k.d, unit, 1.0}, Factor{k.branch.b, unit, 1.0}}) +
         3.0 * r.store(format));
    own.length = {from.size + m.reach(i), from.error + m.reach(i) * 2.0 * own.rotation.error + rounding};
    all.format[i].length = format;
  }
  return all;
}

}  // namespace detail

/// Poses and Jacobians: every position has one format, which holds the whole arm and the number 1; entries of rotations
/// and directions that of sines. `length` bounds a position, `rotation` the rows of a rotation.
template <int N>
constexpr Ranges<N> kinematics_ranges(const Mechanism<N>& m, const Rounding& r) {
  return detail::ranges_by(m, r, [&r](const Mechanism<N>& of) { return detail::pose_ranges(of, r); });
}

}  // namespace axial
