// Efforts of drives that joints share, along a direction and in time: the recursion over dual and Taylor numbers.
#pragma once

#include <axial/derivatives/dual_motion.hpp>
#include <axial/derivatives/taylor_motion.hpp>
#include <axial/transmissions/driven_rotors.hpp>

#include <axial/options/begin.hpp>

namespace axial {
/// Efforts of the drives along a direction.
template <class Links>
struct Execution<derivatives::Along, Links, IfDriven<Links>> {
  /// calls each(k, effort) for every drive
  template <class Input, class U, class V, class A, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const U& u, const V& ud, const A& udd,
                                         const Each& each) {
    const auto q = plain.positions(u.values), dq = plain.rates(u.slopes);
    const auto qd = plain.rates(ud.values), dqd = plain.rates(ud.slopes), qdd = plain.rates(udd.values);
    const auto dqdd = plain.rates(udd.slopes);  // of another type where accelerations do not change
    typename Links::JointValues efforts{}, changes{};
    using Number = Dual<typename Links::Scalar, typename Links::Scalar>;
    const auto links = derivatives::differentiated<Number>(plain.joints());
    const derivatives::DualValues at{q, dq};
    const auto of_rotor = driven::run_joints(
        plain, links, in, at, derivatives::dual_screws(plain.joints(), links, in, at), derivatives::DualValues{qd, dqd},
        derivatives::DualValues{qdd, dqdd}, ud, udd, [&](auto i, const auto& effort) AXIAL_INLINE {
          plain.write(efforts, i, value_of(effort));
          plain.write(changes, i, slope_of(effort));
        });
    const auto own = plain.actuator_efforts(efforts), change = plain.actuator_efforts(changes);
    plain.each_drive([&](auto k) AXIAL_INLINE {
      const auto drive = plain.drives().link(k);
      each(k, with_slope(own[k], change[k]) + friction_effort(drive, ud[k]) + drive.rotor() * udd[k] + of_rotor(k));
    });
  }
};
/// Efforts of the drives with their rates.
template <class Links>
struct Execution<derivatives::InTime, Links, IfDriven<Links>> {
  /// calls each(k, effort) for every drive
  template <class Input, class U, class V, class A, class J, class S, class Each>
  AXIAL_INLINE static constexpr void run(const Links& plain, const Input& in, const U& u, const V& ud, const A& udd,
                                         const J& u3, const S& u4, const Each& each) {
    typename Links::JointValues effort{}, rate{}, curve{};
    const derivatives::TaylorValues accelerations{udd, u3, u4};
    using Number = Taylor<typename Links::Scalar, typename Links::Scalar, typename Links::Scalar>;
    const auto links = derivatives::differentiated<Number>(plain.joints());
    const auto q = plain.positions(u), qd = plain.rates(ud), qdd = plain.rates(udd);
    const auto q3 = plain.rates(u3), q4 = plain.rates(u4);
    const derivatives::TaylorValues at{q, qd, qdd};
    const auto of_rotor = driven::run_joints(
        plain, links, in, at, derivatives::moving_screws(plain.joints(), links, in, at),
        derivatives::TaylorValues{qd, qdd, q3}, derivatives::TaylorValues{qdd, q3, q4},
        derivatives::TaylorValues{ud, udd, u3}, accelerations, [&](auto i, const auto& x) AXIAL_INLINE {
          plain.write(effort, i, value_at_0(x));
          plain.write(rate, i, linear_of(x));
          plain.write(curve, i, quadratic_of(x));
        });
    const auto own = plain.actuator_efforts(effort), first = plain.actuator_efforts(rate);
    const auto second = plain.actuator_efforts(curve);
    plain.each_drive([&](auto k) AXIAL_INLINE {
      each(k,
           with_rates(own[k], first[k], second[k]) + plain.drives().link(k).rotor() * accelerations[k] + of_rotor(k));
    });
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
