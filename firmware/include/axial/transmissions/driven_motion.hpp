// Efforts of drives that joints share, along a direction and in time: the recursion over Taylor numbers.
#pragma once

#include <axial/derivatives/taylor_motion.hpp>
#include <axial/transmissions/driven_rotors.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

/// Calls each(k, effort) for every drive with a Taylor number; `at`, `speeds` and `accelerations` are the joints'.
template <class Links, class Input, class Q, class W, class B, class V, class A, class Each>
AXIAL_INLINE constexpr void changing_efforts(const Links& plain, const Input& in, const Q& at, const W& speeds,
                                             const B& accelerations, const V& ud, const A& udd, const Each& each) {
  typename Links::JointValues efforts{}, rates{}, curves{};
  const auto links = derivatives::differentiated<typename Q::template Of<typename Links::Scalar>>(plain.joints());
  const auto of_rotor = run_joints(plain, links, in, at, derivatives::moving_screws(plain.joints(), links, in, at),
                                   speeds, accelerations, ud, udd, [&](auto i, const auto& x) AXIAL_INLINE {
                                     plain.write(efforts, i, value_at_0(x));
                                     plain.write(rates, i, linear_of(x));
                                     if constexpr (!Q::cut_off) plain.write(curves, i, quadratic_of(x));
                                   });
  const auto own = plain.actuator_efforts(efforts), first = plain.actuator_efforts(rates);
  const auto whole = [&](auto k, const auto& effort) AXIAL_INLINE {
    const auto drive = plain.drives().link(k);
    each(k, effort + friction_effort(drive, ud[k]) + drive.rotor() * udd[k] + of_rotor(k));
  };
  if constexpr (Q::cut_off) {
    plain.each_drive([&](auto k) AXIAL_INLINE { whole(k, with_slope(own[k], first[k])); });
  } else {
    const auto second = plain.actuator_efforts(curves);
    plain.each_drive([&](auto k) AXIAL_INLINE { whole(k, with_rates(own[k], first[k], second[k])); });
  }
}

}  // namespace driven

/// Efforts of the drives along a direction.
template <class Links>
struct Execution<derivatives::Along, Links, IfDriven<Links>> {
  /// calls each(k, effort) for every drive
  template <class Input, class U, class V, class A, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const U& u, const V& ud, const A& udd,
                                         const Each& each) {
    using derivatives::TaylorValues;
    const auto q = plain.positions(u.values), dq = plain.rates(u.first);
    const auto qd = plain.rates(ud.values), dqd = plain.rates(ud.first), qdd = plain.rates(udd.values);
    const auto dqdd = plain.rates(udd.first);  // of another type where accelerations do not change
    driven::changing_efforts(plain, in, TaylorValues{q, dq}, TaylorValues{qd, dqd}, TaylorValues{qdd, dqdd}, ud, udd,
                             each);
  }
};
/// Efforts of the drives with their rates.
template <class Links>
struct Execution<derivatives::InTime, Links, IfDriven<Links>> {
  /// calls each(k, effort) for every drive
  template <class Input, class U, class V, class A, class J, class S, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const U& u, const V& ud, const A& udd,
                                         const J& u3, const S& u4, const Each& each) {
    using derivatives::TaylorValues;
    const auto q = plain.positions(u), qd = plain.rates(ud), qdd = plain.rates(udd);
    const auto q3 = plain.rates(u3), q4 = plain.rates(u4);
    driven::changing_efforts(plain, in, TaylorValues{q, qd, qdd}, TaylorValues{qd, qdd, q3}, TaylorValues{qdd, q3, q4},
                             TaylorValues{ud, udd, u3}, TaylorValues{udd, u3, u4}, each);
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
