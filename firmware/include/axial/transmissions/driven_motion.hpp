// Of drives that joints share: derivatives of forward dynamics, and efforts along a direction and in time, by the
// recursion over Taylor numbers.
#pragma once

#include <axial/derivatives/forward_dynamics_along.hpp>
#include <axial/derivatives/taylor_motion.hpp>
#include <axial/transmissions/driven_derivatives.hpp>
#include <axial/transmissions/driven_rotors.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// solve_and_factor() in values of drives; q and qd are the joints'.
template <class Links, class Input, class Q, class Screws, class W, class V, class Tau, class A, class F>
AXIAL_INLINE constexpr auto solve_and_factor_drives(const Links& links, const Input& in, const Q& q,
                                                    const Screws& screws, const W& qd, const V& ud, const Tau& tau,
                                                    A& udd, F& factors) {
  using AtRest = WantedResults<typename Links::JointScene, typename Links::Scalar, with_efforts, with_mass_matrix>;
  const auto at =
      driven::results_of_joints<AtRest>(links.template joints<recursion::Derivatives>(), in, q, screws, qd, NoMotion{});
  DrivenKernels<Links>::reduce(links, at.M, factors.m);
  DrivenKernels<Links>::remaining_efforts(links, at.tau, ud, tau, udd);
  return eliminate(links.drives(), udd, factors);
}
/// Jacobians of the joints that those of drives which are wanted follow from.
template <class Links, class Result>
using JointSlopes = WantedResults<
    typename Links::JointScene, typename Links::Scalar,
    std::conditional_t<Result::template has<with_acceleration_by_position>, with_position_jacobian, NotWanted<0>>,
    std::conditional_t<Result::template has<with_acceleration_by_velocity>, with_velocity_jacobian, NotWanted<1>>>;

}  // namespace derivatives

/// Derivatives of the drives' accelerations.
template <class Links>
struct Execution<derivatives::ForwardSlopes, Links, IfDriven<Links>> {
  /// all results but the status, which it returns
  template <class Input, class U, class V, class Tau, class Result>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const U& u, const V& ud, const Tau& tau,
                                         Result& result) {
    using T = typename Links::Scalar;
    constexpr bool position = Result::template has<with_acceleration_by_position>;
    constexpr bool velocity = Result::template has<with_acceleration_by_velocity>;
    const auto& joints = links.template joints<recursion::Derivatives>();
    const auto q = links.positions(u), qd = links.rates(ud);
    const auto screws = joint_screws(joints, in, q);
    Row<T, Links::capacity> udd;
    derivatives::Factors<MassMatrix<typename Links::Scene::Robot, T>, T, Links::capacity> factors;
    const auto status = derivatives::solve_and_factor_drives(links, in, q, screws, qd, ud, tau, udd, factors);
    if constexpr (position || velocity) {
      const auto at = driven::results_of_joints<derivatives::JointSlopes<Links, Result>>(joints, in, q, screws, qd,
                                                                                         links.rates(udd));
      if constexpr (position) driven::write_slopes(by::Position{}, links, at.dtau_dq, ud, result.dqdd_dq);
      if constexpr (velocity) driven::write_slopes(by::Velocity{}, links, at.dtau_dqd, ud, result.dqdd_dqd);
    }
    links.each_drive([&](auto k) AXIAL_INLINE { result.qdd[k] = udd[k]; });
    if constexpr (Result::template has<with_inverse_mass_matrix>)
      derivatives::invert(links.drives(), factors, result.M_inverse);
    derivatives::solve_slopes(links.drives(), factors, result);
    return status;
  }
};
/// Accelerations and factors of M of the drives from positions themselves.
template <class Links>
struct Execution<derivatives::FactorsAt, Links, IfDriven<Links>> {
  /// status of the accelerations
  template <class Input, class U, class V, class Tau, class A, class F>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const U& u, const V& ud, const Tau& tau,
                                         A& udd, F& factors) {
    const auto at = links.positions(u);
    const auto screws = joint_screws(links.template joints<recursion::Derivatives>(), in, at);
    return derivatives::solve_and_factor_drives(links, in, at, screws, links.rates(ud), ud, tau, udd, factors);
  }
};

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
