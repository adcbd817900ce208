// Ranges of the joints' momenta and of their rates: Newton-Euler from rest. doc/observer.md is the proof.
#pragma once

#include <axial/fixed/ranges/newton_euler.hpp>

namespace axial {

/// A robot without gravity and wrenches that starts from rest, its joints "accelerating" by what their speeds may be:
/// the accelerations of its Newton-Euler recursion are velocities, its forces momenta, its efforts the joints' momenta.
template <int N>
constexpr Mechanism<N> impulsive(Mechanism<N> m) {
  for (int i = 0; i < N; ++i)
    m.joints[i].acceleration = m.joints[i].speed, m.joints[i].speed = 0.0;
  LoadRange& loads = m.loads;
  loads.gravity_across = loads.gravity_along = loads.tip_force = loads.tip_moment = 0.0;
  loads.friction = loads.springs = false;
  return m;
}

/// Ranges, formats and errors of momenta, under the names of Newton-Euler's quantities.
template <int N>
constexpr Ranges<N> momentum_ranges(const Mechanism<N>& mechanism, const Rounding& rounding) {
  return newton_euler_ranges(impulsive(mechanism), rounding);
}

/// Bound of a joint's dT/dq at given ranges of momenta: |w||n| + |v||l| about an axis, |w||l| along one.
template <int N>
constexpr Ball kinetic_slope_range(const Mechanism<N>& m, const Ranges<N>& momenta, int i) {
  const LinkRange& r = momenta.range[i];
  if (m.links[i].prismatic) return r.angular_acceleration * r.force;
  return r.angular_acceleration * r.moment + r.linear_acceleration * r.force;
}

}  // namespace axial
