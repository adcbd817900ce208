// Derivatives of forward dynamics in values of drives that joints share.
#pragma once

#include <axial/derivatives/forward_dynamics_along.hpp>
#include <axial/transmissions/driven_derivatives.hpp>

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

}  // namespace axial

#include <axial/options/end.hpp>
