// Ranges of the separated terms: composite bodies, and the motions that unit rates give them. doc/guides/ranges.md.
#pragma once

#include <axial/fixed/bounds/mass_matrix.hpp>
#include <axial/fixed/ranges/composite_bodies.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Formats on those of composite bodies: second moments are sums of three entries; LinearAcceleration is that of points
/// at unit rates (m); Moment and Force are those of two unit rates; JointInertia holds every coefficient of which this
/// joint is the outermost.
template <int N>
constexpr Ranges<N> separation_ranges_of(const Mechanism<N>& m, const Rounding& r) {
  Ranges<N> all = composite_body_ranges(m, r);
  const CompositeRanges<N> bodies = composite_ranges(m);
  double arm[N] = {};
  for (int i = 0; i < N; ++i) {
    const int p = m.parent(i);
    arm[i] = (p < 0 ? 1.0 : arm[p]) + m.reach(i);
    const CompositeRange& b = bodies.behind[i];
    LinkRange& own = all.range[i];
    LinkFormat& format = all.format[i];
    own.moment.size = 6.0 * b.inertia + 6.0 * b.moment, own.force.size = 4.0 * (b.moment + b.mass);
    const double rotor = m.loads.rotors ? m.links[i].rotor : 0.0;
    own.joint_inertia.size = own.moment.size + arm[i] * own.force.size + rotor;
    own.linear_acceleration.size = arm[i];
    format.rotational_inertia = r.exponent(4.0 * b.inertia), format.first_moment = r.exponent(2.0 * b.moment);
    format.moment = r.exponent(own.moment.size), format.force = r.exponent(own.force.size);
    format.joint_inertia = r.exponent(own.joint_inertia.size);
    format.linear_acceleration = r.exponent(arm[i]);
    const double falls = detail::hypotenuse(m.loads.gravity_across, m.loads.gravity_along);
    format.gravity = r.exponent(falls > 0.0 ? falls : 1.0);
    format.joint_effort = m.joints[i].effort_format;
  }
  return all;
}

}  // namespace axial

#include <axial/options/end.hpp>
