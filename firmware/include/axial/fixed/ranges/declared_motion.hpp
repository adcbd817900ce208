// What the declared accelerations make of the structure at rest: the formats of forward dynamics where efforts could
// do far more to the least inertia than any declared motion does. doc/guides/forward_ranges.md.
#pragma once

#include <axial/fixed/ranges/articulated_bodies.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// A robot that accelerates from rest, weightless and free of outside forces.
template <int N>
constexpr Mechanism<N> starting(Mechanism<N> m) {
  for (JointRange& joint : m.joints)
    joint.speed = 0.0;
  m.loads.gravity_across = m.loads.gravity_along = m.loads.tip_force = m.loads.tip_moment = 0.0;
  m.loads.friction = false;
  return m;
}

/// Sizes of what the split form stores of each link while joints accelerate as declared: motions and forces as
/// Newton-Euler has them, u = U . a + J qdd, and p = f - I* a with 0 <= I* <= I^c.
template <int N>
class DeclaredMotion {
 public:
  /// `all` has the gains and inertias of the links.
  constexpr DeclaredMotion(const Mechanism<N>& mechanism, const WordRounding& rounding, const Ranges<N>& all)
      : m_(mechanism), all_(all), bodies_(composite_ranges(mechanism)) {
    const Ranges<N> motion = newton_euler_ranges(starting(mechanism), rounding, Wanted::formats);
    for (int i = 0; i < N; ++i)
      size(i, motion);
  }
  constexpr const Ranges<N>& sizes() const { return sizes_; }

 private:
  const Mechanism<N>& m_;
  const Ranges<N>& all_;
  CompositeRanges<N> bodies_;
  Ranges<N> sizes_{};

  constexpr void size(int i, const Ranges<N>& motion) {
    const LinkRange& own = motion.range[i];
    const CompositeRange& b = bodies_.behind[i];
    const LinkRange base{};
    const LinkRange& up = m_.parent(i) < 0 ? base : motion.range[m_.parent(i)];
    const double pull = m_.joints[i].acceleration, rotor = m_.loads.rotors ? m_.links[i].rotor : 0.0;
    const double carried = up.linear_acceleration.size + m_.origin_distance(i) * up.angular_acceleration.size;
    const double turn = larger(own.angular_acceleration.size, up.angular_acceleration.size);
    const double shift = larger(own.linear_acceleration.size, carried);
    const double moment = b.inertia * turn + b.moment * shift, force = b.moment * turn + b.mass * shift;
    LinkRange& to = sizes_.range[i];
    to.angular_acceleration.size = turn, to.linear_acceleration.size = shift;
    to.moment.size = own.moment.size + m_.joints[i].travel * own.force.size + moment;
    to.force.size = own.force.size + force;
    to.joint_effort.size = larger((m_.links[i].prismatic ? force : moment) + rotor * pull, own.joint_effort.size);
    const double carries =
        all_.range[i].angular_gain.size * up.angular_acceleration.size + all_.range[i].linear_gain.size * carried;
    to.joint_acceleration.size = pull + least(carries, to.joint_effort.size / all_.range[i].least);
  }
};

/// What formats take each joint to feel at least: a 256th of what it feels usually where that is more than its own link
/// and rotor. Fewer than two states in a hundred bring less, in which the joint has a status.
template <int N>
constexpr PerJoint<N> resisting(const Mechanism<N>& m, PerJoint<N> least) {
  const PerJoint<N> usual = usual_inertia(m);
  for (int i = 0; i < N; ++i)
    least.of[i] = larger(least.of[i], usual.of[i] / 256.0);
  return least;
}

/// What a drive makes, which is in proportion to it.
struct DrivenQuantity {
  Ball LinkRange::*size;
  int LinkFormat::*format;
};
inline constexpr DrivenQuantity driven_quantities[] = {
    {&LinkRange::angular_acceleration, &LinkFormat::angular_acceleration},
    {&LinkRange::linear_acceleration, &LinkFormat::linear_acceleration},
    {&LinkRange::moment, &LinkFormat::moment},
    {&LinkRange::force, &LinkFormat::force},
    {&LinkRange::joint_effort, &LinkFormat::joint_effort},
    {&LinkRange::joint_acceleration, &LinkFormat::joint_acceleration}};

}  // namespace detail

/// By how much efforts alone could drive a joint beyond the acceleration that it declares, at most.
template <int N>
constexpr double largest_excess(const Mechanism<N>& m, const Ranges<N>& ranges) {
  double most = 0.0;
  for (int i = 0; i < N; ++i)
    if (m.joints[i].acceleration > 0.0)
      most = detail::larger(most, ranges.range[i].joint_acceleration.size / m.joints[i].acceleration);
  return most;
}
/// Whether a second solve pays: above 2^10 formats have that many bits to spare in most states. In 32-bit words.
template <int N>
constexpr bool second_solve_pays(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges) {
  return r.bits == 32 && ranges.halvings == 0 && largest_excess(m, ranges) > 1024.0;
}
/// Whether formats for the declared motion pay: above 2^14 the others leave that motion too few bits.
template <int N>
constexpr bool declared_formats_pay(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges) {
  return r.bits == 32 && largest_excess(m, ranges) > 16384.0;
}

/// Gives the driven quantities the formats of the declared motion, and counts the halvings of a drive that bring
/// everything that efforts can do within them.
template <int N>
constexpr Ranges<N> fitted_to_declared_motion(const Mechanism<N>& m, const WordRounding& r, Ranges<N> all) {
  const Ranges<N> declared = detail::DeclaredMotion<N>(m, r, all).sizes();
  for (int i = 0; i < N; ++i)
    for (const auto& quantity : detail::driven_quantities) {
      const double size = (declared.range[i].*quantity.size).size;
      int& format = all.format[i].*quantity.format;
      const int safe = format;
      if (size > 0.0) format = r.exponent(size);
      if (format - safe > all.halvings) all.halvings = format - safe;
      if (format < safe) format = safe;
    }
  return all;
}

}  // namespace axial

#include <axial/options/end.hpp>
