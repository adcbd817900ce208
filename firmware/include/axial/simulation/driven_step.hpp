// The linearly implicit step of a robot whose joints share drives.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/simulation/stiff_links.hpp>
#include <axial/transmissions/roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {
struct ImplicitStep;
}  // namespace detail

/// Accelerations of the drives in a step of h seconds: (G^T (M + h^2 K) G + rotors + h D + h^2 K_u) udd =
/// tau - bias - h (G^T K G + K_u) ud, with springs K at the joints, friction D of the drives and the stiffness K_u of
/// what drives them. Composite bodies.
template <class Links>
struct Execution<detail::ImplicitStep, Links, IfDriven<Links>> {
  /// their status
  template <class T, class Input, class Q, class V, class Tau, class Stiffness, class A>
  [[nodiscard]] static constexpr auto run(const Links& links, T h, const Input& in, const Q& u, const V& ud,
                                          const Tau& tau, const Stiffness& stiffness, A& udd) {
    using Kernels = DrivenKernels<Links>;
    const auto q = links.positions(u), qd = links.rates(ud);
    const auto joints = links.joints();
    const auto drives = links.drives();
    const auto screws = joint_screws(joints, in, q);
    Kernels::remaining_efforts(links, in, q, screws, qd, ud, tau, udd);
    const NoStiffness none{};
    const StiffLinks<std::decay_t<decltype(joints)>, typename Links::JointValues, NoStiffness> springs(joints, h, qd,
                                                                                                       none);
    const StiffLinks<std::decay_t<decltype(drives)>, V, Stiffness> dampers(drives, h, ud, stiffness);
    typename Links::JointValues pulled{};
    for_each_link(joints, [&](auto i) AXIAL_INLINE { pulled[i] = static_cast<T>(springs.stiffness(i) * qd[i]); });
    links.each_drive([&](auto k) AXIAL_INLINE {
      udd[k] = static_cast<T>(udd[k] - h * (links.actuator_effort(k, pulled) + stiffness.stiffness[k] * ud[k]));
    });
    typename Kernels::Matrix m{};
    typename Kernels::JointMatrix by_joints{};
    crba::entries(springs, in, screws, by_joints);
    Kernels::reduce(links, by_joints, m);
    links.each_drive([&](auto k)
                         AXIAL_INLINE { m(k, k) = m(k, k) + (dampers.link(k).rotor() - drives.link(k).rotor()); });
    return crba::solve(drives, m, udd);
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
