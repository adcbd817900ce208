// Rotors as spinning bodies: how fast rotors couple to the turning of the links that carry them.
//
// A rotor of inertia J about its axis z on link c turns at z . w_c + gear qd. Beside the J that its carrier declares as
// a part of itself, and the gear^2 J of RotorInertia on its own joint, that is gear J qd (z . w_c) of kinetic energy:
// on the joint gear J z . dw_c, on the carrier the moment gear J qdd z + w_c x (gear J qd z). Source: Murphy, Wen and
// Saridis 1990; Sciavicco and Siciliano 2000, chapter 4.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/links/rotors.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What the rotors on a link add to its angular momentum, in its axes, and how fast their spin changes that.
template <class H, class R>
struct RotorSpin {
  H momentum{};  ///< sum of gear J qd z, N m s
  R rate{};      ///< sum of gear J qdd z, N m
};
template <class H, class R>
RotorSpin(H, R) -> RotorSpin<H, R>;

namespace detail {

template <class Scene>
struct RotorsIncluded<Scene, true> {};

// Sum of gear J x z over the rotors on link I, from joint J on.
template <int J, class Links, class I, class X>
AXIAL_INLINE constexpr auto spin_on(const Links& links, I i, const X& x) {
  if constexpr (J >= Links::capacity) {
    return ZeroVec3{};
  } else {
    using Rotor = decltype(rotor_of(links, Index<J>{}));
    if constexpr (Rotor::carrier() == I::value)
      return x[Index<J>{}] * Rotor::spin() + spin_on<J + 1>(links, i, x);
    else
      return spin_on<J + 1>(links, i, x);
  }
}

}  // namespace detail

/// The spins of all links' rotors at speeds and accelerations of what turns them: `owners`, the links themselves or
/// drives that joints share.
template <class Owners, class Links, class V, class A>
AXIAL_INLINE constexpr auto rotor_spins(const Owners& owners, const Links& links, const V& qd, const A& qdd) {
  if constexpr (Links::unrolled) {
    return map_links(links, [&](auto i) AXIAL_INLINE {
      return RotorSpin{detail::spin_on<0>(owners, i, qd), detail::spin_on<0>(owners, i, qdd)};
    });
  } else {
    using Vector = Vec3<typename Links::Dense>;
    Row<RotorSpin<Vector, Vector>, Links::capacity> spins{};
    for_each_link(execute<Actuators>(owners), [&](auto i) AXIAL_INLINE {
      const auto rotor = rotor_of(owners, i);
      if (rotor.carrier() < 0) return;
      auto& spin = spins[rotor.carrier()];
      spin.momentum = spin.momentum + qd[i] * rotor.spin(), spin.rate = spin.rate + qdd[i] * rotor.spin();
    });
    return spins;
  }
}

/// Force that moves a link and turns its spinning rotors with it.
template <class Link, class F, class S, class M>
AXIAL_INLINE constexpr auto with_spin(const Link& link, const F& force, const S& spin, const M& motion) {
  return link.shape(force + ForceVector{spin.rate + cross(motion.w, spin.momentum), ZeroVec3{}});
}

/// Effort of joint i, or drive, of `owners` that keeps its rotor's speed while the rotor's carrier turns ever faster:
/// gear J z . dw_c.
template <class Owners, class Links, class Input, class I, class Motions>
AXIAL_INLINE constexpr auto effort_on_rotor(const Owners& owners, const Links& links, const Input& in, I i,
                                            const Motions& motions) {
  if constexpr (Owners::unrolled) {
    using Rotor = decltype(rotor_of(owners, i));
    if constexpr (Rotor::carrier() < 0)
      return dot(Rotor::spin(), base_angular_acceleration(links, in));
    else
      return dot(Rotor::spin(), motions[Index<Rotor::carrier()>{}].dw);
  } else {
    const auto rotor = rotor_of(owners, i);
    auto turning = base_angular_acceleration(links, in).template dense<typename Links::Dense>();
    if (rotor.carrier() >= 0) turning = motions[rotor.carrier()].dw;
    return dot(rotor.spin(), turning);
  }
}

/// The force that a unit of joint i's acceleration sends to link j, with the moment on its rotor where j carries that.
template <class Links, class I, class J, class F>
AXIAL_INLINE constexpr auto with_rotor(const Links& links, I i, J j, const F& force) {
  if constexpr (Links::unrolled) {
    using Rotor = decltype(rotor_of(links, i));
    if constexpr (Rotor::carrier() == J::value)
      return force + ForceVector{Rotor::spin(), ZeroVec3{}};
    else
      return force;
  } else {
    const auto rotor = rotor_of(links, i);
    return rotor.carrier() == j ? force + ForceVector{rotor.spin(), ZeroVec3{}} : force;
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
