// Rotors as spinning bodies where joints share drives: a rotor turns by its drive, on a link that the joints carry.
//
// As rotor_dynamics.hpp has it, with the speed u' of the drive where a joint's is there: the moment on the carrier is
// one of the joints, which drives feel by G^T; the drive itself feels gear J z . dw_c. Source: as there.
#pragma once

#include <axial/transmissions/coupling_terms.hpp>
#include <axial/transmissions/rotor_dynamics.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The rotor of drive k, at the joint that owns it.
template <class Links>
struct Execution<RotorOf, Links, IfDriven<Links>> {
  /// its constants
  template <class K>
  AXIAL_INLINE static constexpr auto run(const Links& links, K k) {
    using T = typename Links::Scalar;
    if constexpr (Links::unrolled) {
      using Robot = typename detail::SceneOfClusters<typename Links::Scene>::Robot;
      return StaticRotor<Robot, detail::drive_matrix<Robot>.owner[K::value], T>{};
    } else {
      return TableRotor<T, double>{links.joints().rotor(links.owner(k))};
    }
  }
};

namespace driven {

/// Newton and Euler's recursion over the joints with the rotors that drives turn on them: calls each(i, effort) for
/// every joint, and answers the links' motions.
template <class Links, class Bodies, class Input, class Q, class Screws, class W, class B, class V, class A, class Each>
AXIAL_INLINE constexpr auto propagate_inward(const Links& links, const Bodies& joints, const Input& in, const Q& q,
                                             const Screws& screws, const W& qd, const B& qdd, const V& ud, const A& udd,
                                             const Each& each) {
  auto motions = rnea::link_motions(joints, in, screws, qd, qdd);
  const auto water = immersions(joints, in, screws, qd);
  const auto spins = rotor_spins(links, joints, ud, udd);
  const auto own = [&](auto i) AXIAL_INLINE {
    return with_spin(joints.link(i), rnea::own_force(joints, in, motions, water, i), spins[i], motions[i]);
  };
  inward(joints, own, [&](auto i, const auto& force) AXIAL_INLINE {
    each(i, rnea::joint_effort(joints, i, force, q, qd, qdd));
    return rnea::InwardResult{rnea::force_on_parent(joints, screws, i, force)};
  });
  return motions;
}

/// Newton and Euler's recursion over the joints that drives share, by `links` over any numbers: calls each(i, effort);
/// answers what of their rotors, where those are bodies, drive k feels besides: of_rotor(k). `ud`, `udd` are the
/// drives'.
template <class Links, class Joints, class Input, class Q, class Screws, class W, class B, class V, class A, class Each>
AXIAL_INLINE constexpr auto run_joints(const Links& plain, const Joints& links, const Input& in, const Q& q,
                                       const Screws& screws, const W& qd, const B& qdd, const V& ud, const A& udd,
                                       const Each& each) {
  if constexpr (Links::Scene::template has<RotorDynamics>) {
    const auto motions = propagate_inward(plain, links, in, q, screws, qd, qdd, ud, udd, each);
    return [&plain, &in, links, motions](auto k) AXIAL_INLINE { return effort_on_rotor(plain, links, in, k, motions); };
  } else {
    rnea::propagate_inward(links, in, q, screws, qd, qdd,
                           [&](auto i, const auto&, const auto& effort) AXIAL_INLINE { each(i, effort); });
    return [](auto) AXIAL_INLINE { return Zero{}; };
  }
}

/// Calls each(i, share) for every joint from j inwards, with what it feels of a moment on link j.
template <class Bodies, class Screws, class F, class J, class Each>
AXIAL_INLINE constexpr void climb(const Bodies& joints, const Screws& screws, const F& force, J j, const Each& each) {
  if constexpr (Bodies::unrolled) {
    const auto link = joints.link(j);
    link.on_joint([&](auto joint) AXIAL_INLINE { each(j, along_joint(joint, force)); });
    constexpr int parent = Bodies::template parent_of<J::value>;
    if constexpr (parent >= 0)
      climb(joints, screws, to_parent(link.x(), to_parent(screws[j], force, link), link.outer()), Index<parent>{},
            each);
  } else {
    auto carried = joints.link(j).shape(force);
    for (int i = j; i >= 0; i = joints.parent_index(i)) {
      const auto link = joints.link(i);
      link.on_joint([&](auto joint) AXIAL_INLINE { each(i, along_joint(joint, carried)); });
      carried = link.shape(to_parent(link.x(), to_parent(screws[i], carried, link), link.outer()));
    }
  }
}

/// Adds to M of the drives what rotors have to do with the turning of their carriers: gear J z . w_c of each unit of a
/// drive's speed, w_c by the joints.
template <class Links, class Screws, class M>
AXIAL_INLINE constexpr void couple_rotors(const Links& links, const Screws& screws, M& m) {
  using T = typename Links::Scalar;
  const auto add = [&](int k, int l, const auto& x) AXIAL_INLINE {
    m.set(k, l, m(k, l) + x);
    if (k == l) m.set(k, l, m(k, l) + x);
  };
  const auto& joints = links.joints();
  links.each_drive([&](auto k) AXIAL_INLINE {
    const auto rotor = rotor_of(links, k);
    const auto each = [&](auto j, const auto& share) AXIAL_INLINE {
      links.each_drive([&](auto l) AXIAL_INLINE {
        if constexpr (std::decay_t<decltype(joints)>::unrolled)
          add(k, l, literal<T>([] { return Links::matrix.ratio[decltype(j)::value][decltype(l)::value]; }) * share);
        else
          add(k, l, links.ratio(j, l) * share);
      });
    };
    const ForceVector moment{rotor.spin(), ZeroVec3{}};
    if constexpr (Links::unrolled) {
      constexpr int carrier = decltype(rotor_of(links, k))::carrier();
      if constexpr (carrier >= 0) climb(joints, screws, moment, Index<carrier>{}, each);
    } else {
      if (rotor.carrier() >= 0) climb(joints, screws, moment, rotor.carrier(), each);
    }
  });
}

/// Whether drive l turns the link that carries the rotor of drive k.
template <class Links>
constexpr bool turns_carrier(int l, int k) {
  using Robot = typename detail::SceneOfClusters<typename Links::Scene>::Robot;
  for (int j = detail::robot_rotors<Robot, double>.links[Links::matrix.owner[k]].carrier; j >= 0;
       j = Robot::chain.parent(j))
    if (Robot::chain.links[j].type == JointType::revolute && Links::matrix.is_moved(j, l)) return true;
  return false;
}

}  // namespace driven
}  // namespace axial

#include <axial/options/end.hpp>
