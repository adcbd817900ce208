// Ranges of composite bodies: what everything outboard of a link can weigh about it. doc/guides/ranges.md is the proof.
#pragma once

#include <axial/fixed/bounds/account.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Mass, first moment and inertia (norms) of all that a link carries, about a point.
struct CompositeRange {
  double mass = 0.0, moment = 0.0, inertia = 0.0;  ///< kg, kg m, kg m^2

  /// The range about a point at a distance of r (m) at most.
  constexpr CompositeRange seen_from(double r) const {
    return {mass, moment + r * mass, inertia + r * (2.0 * moment + r * mass)};
  }
};
/// Two bodies about one point.
constexpr CompositeRange operator+(const CompositeRange& a, const CompositeRange& b) {
  return {a.mass + b.mass, a.moment + b.moment, a.inertia + b.inertia};
}

/// One composite body per link.
template <int N>
struct CompositeRanges {
  CompositeRange own[N] = {};     ///< about the link's origin, everything outboard included
  CompositeRange behind[N] = {};  ///< `own` behind the shift of the joint
};

/// Parallel axes, link by link from the tips: whatever the joint angles.
template <int N>
constexpr CompositeRanges<N> composite_ranges(const Mechanism<N>& m) {
  CompositeRanges<N> all;
  for (int i = N; i-- > 0;) {
    const auto& c = m.links[i];
    CompositeRange link{magnitude(c.mass), detail::length_of(c.hx, c.hy, c.hz), detail::norm_of(c)};
    if (i + 1 == N) link = link + CompositeRange{m.loads.payload_mass, m.loads.payload_moment, m.loads.payload_inertia};
    all.own[i] = all.own[i] + link;
    all.behind[i] = all.own[i].seen_from(m.joints[i].travel);
    if (const int p = m.parent(i); p >= 0) all.own[p] = all.own[p] + all.own[i].seen_from(m.origin_distance(i));
  }
  return all;
}

/// Formats of composite bodies: sums of two first moments occur, so they keep a bit to spare.
template <int N>
constexpr void set_inertia_formats(const Mechanism<N>& m, const CompositeRanges<N>& bodies, const WordRounding& r,
                                   Ranges<N>& all) {
  for (int i = 0; i < N; ++i) {
    const CompositeRange& b = bodies.behind[i];
    all.range[i].mass.size = b.mass, all.range[i].first_moment.size = b.moment;
    all.range[i].rotational_inertia.size = b.inertia;
    all.format[i].mass = m.format(r, &LinkFormat::mass, b.mass);
    all.format[i].first_moment = m.format(r, &LinkFormat::first_moment, 2.0 * b.moment);
    all.format[i].rotational_inertia = m.format(r, &LinkFormat::rotational_inertia, b.inertia);
    const double rotor = m.loads.rotors ? m.links[i].rotor : 0.0;
    const CompositeRange& own = bodies.own[i];
    all.range[i].joint_inertia.size = (m.links[i].prismatic ? own.mass : own.inertia) + rotor;
    all.format[i].joint_inertia = m.format(r, &LinkFormat::joint_inertia, all.range[i].joint_inertia.size);
    all.format[i].length = m.format(r, &LinkFormat::length, m.joints[i].travel > 0.0 ? m.joints[i].travel : 1.0);
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
