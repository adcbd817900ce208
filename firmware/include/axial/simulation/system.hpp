// A robot as an integrator asks it: accelerations, explicit or of an implicit step. A scene, or a run-time model.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/recursion/drives.hpp>
#include <axial/recursion/passes.hpp>
#include <axial/simulation/motion.hpp>
#include <axial/transmissions/roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Stiffness -d tau_i / d q_i (N m/rad, N/m) and damping -d tau_i / d qd_i (N m s/rad, N s/m) of what drives the
/// joints, each on its own joint and not negative: a stiff controller, end stops.
template <class S, class T>
struct DriveStiffness {
  Joints<robot_of<S>, T> stiffness{};  ///< N m/rad or N/m
  Joints<robot_of<S>, T> damping{};    ///< N m s/rad or N s/m
};

/// Drives without stiffness and damping: zero by type.
struct NoStiffness {
  NoMotion stiffness{};  ///< none
  NoMotion damping{};    ///< none
};

namespace detail {

// What friction damps: viscous, and dry friction over its smooth speed, whose effort is the larger breakaway of both
// directions; the fall of Stribeck's curve is left out, for its slope is negative.
template <class Link, class V>
AXIAL_INLINE constexpr auto friction_damping(const Link& link, const V& qd) {
  if constexpr (!Link::Scene::template has<Friction>) {
    return Zero{};
  } else if constexpr (is_zero_v<decltype(link.inverse_smooth_speed())>) {
    return link.viscous();
  } else {
    const V forward(link.coulomb_forward() + link.stribeck_forward());
    const V backward(-(link.coulomb_backward() + link.stribeck_backward()));
    return link.viscous() + sign_slope(link, qd) * select(forward > backward, forward, backward);
  }
}

}  // namespace detail

/// A link with the inertia `added` on its joint.
template <class Link, class Added>
class HeavierLink : public Link {
 public:
  /// `added` in kg m^2 or kg.
  AXIAL_INLINE constexpr HeavierLink(const Link& link, const Added& added) : Link(link), added_(added) {}
  /// Inertia on the joint: the rotor's and the added.
  AXIAL_INLINE constexpr auto rotor() const { return Link::rotor() + added_; }

 private:
  Added added_;
};

/// The links as M + h D + h^2 K sees them: the springs' K and the dampers' D of each joint, at velocities qd, stand
/// where a rotor's inertia does, so that the articulated-body recursion solves for them in O(n). A joint without either
/// is as it was, by type.
template <class Links, class V, class Stiffness>
class StiffLinks : public Links {
 public:
  using Scalar = typename Links::Scalar;  ///< of the links
  /// For a step of h seconds at the velocities qd; all three are only referred to.
  AXIAL_INLINE constexpr StiffLinks(const Links& links, Scalar h, const V& qd, const Stiffness& drive)
      : Links(links), h_(h), qd_(qd), drive_(drive) {}

  /// Link i with what its springs, dampers and drive add to the inertia of its joint.
  template <class I>
  AXIAL_INLINE constexpr auto link(I i) const {
    auto link = Links::link(i);
    auto damping = detail::friction_damping(link, qd_[i]) + drive_.damping[i];
    auto added = h_ * (damping + h_ * stiffness(i));
    return HeavierLink<decltype(link), decltype(added)>(link, added);
  }
  /// Stiffness of springs and drive together, N m/rad or N/m.
  template <class I>
  AXIAL_INLINE constexpr auto stiffness(I i) const {
    return spring_slope(Links::link(i)) + drive_.stiffness[i];
  }

 private:
  Scalar h_;
  const V& qd_;
  const Stiffness& drive_;
};

namespace detail {

template <class S>
constexpr auto check_fixed_base() {
  static_assert(!scene_of<S>::template has<FloatingBase>,
                "axial: integrators move joints; integrate a floating base as doc/guides/moving_base.md shows");
  static_assert(!scene_of<S>::template has<RotorDynamics>,
                "axial: integrators have no rotors as bodies; take RotorDynamics out of the scene, or integrate "
                "forward_dynamics");
  if constexpr (is_described<typename scene_of<S>::Robot> && !scene_of<S>::template has<FloatingBase>)
    check_resisted<scene_of<S>>();
}

/// A scene whose robot is a type.
template <class S>
struct StaticSystem {
  using Subject = S;
  static constexpr int size() { return joint_count<S>; }
  template <class T>
  static constexpr auto links() {
    return links_of<S, T, FullParameters, recursion::ArticulatedBodies>();
  }
  template <class T, class Q, class V, class Tau>
  static constexpr ForwardDynamicsOf<S, T> accelerations(const Q& q, const V& qd, const Tau& tau,
                                                         const Inputs<S, T>& in) {
    auto a = forward_dynamics<S>(q, qd, tau, in);
    Summation<S, T>::name_lost(a.status, q, qd);
    return a;
  }
  template <class T, class Q>
  static constexpr auto masses(const Q& q, const Inputs<S, T>& in) {
    return mass_matrix<S>(q, in);
  }
};

/// A robot described at run time.
template <class M>
struct ModelSystem {
  using Subject = M;
  const M& model;
  constexpr int size() const { return model.size(); }
  template <class T>
  constexpr auto links() const {
    return model.template links<T>();
  }
  template <class T, class Q, class V, class Tau>
  constexpr ForwardDynamicsOf<M, T> accelerations(const Q& q, const V& qd, const Tau& tau,
                                                  const Inputs<M, T>& in) const {
    return forward_dynamics(model, q, qd, tau, in);
  }
  template <class T, class Q>
  constexpr auto masses(const Q& q, const Inputs<M, T>& in) const {
    return mass_matrix(model, q, in);
  }
};

/// The step over links, by articulated bodies on full parameters.
struct ImplicitStep {
  /// status of the accelerations that it writes
  template <class Links, class T, class Input, class Q, class V, class Tau, class Stiffness, class A>
  static constexpr Status run(const Links& links, T h, const Input& in, const Q& q, const V& qd, const Tau& tau,
                              const Stiffness& drive, A& result) {
    StiffLinks<Links, V, Stiffness> stiff(links, h, qd, drive);
    Tau left{};
    for_each_link(stiff, [&](auto i) AXIAL_INLINE { left[i] = tau[i] - T(h * (stiff.stiffness(i) * qd[i])); });
    return aba::run(stiff, in, q, qd, left, result);
  }
};
/// Accelerations a with (M + h D + h^2 K) a = tau - c - g - passive efforts - h K qd, the step of the linearly implicit
/// method, whatever route the scene names.
template <class T, class System, class Q, class V, class Tau, class S, class Stiffness>
constexpr ForwardDynamicsOf<S, T> implicit_accelerations(const System& system, T h, const Q& q, const V& qd,
                                                         const Tau& tau, const Inputs<S, T>& in,
                                                         const Stiffness& drive) {
  auto links = system.template links<T>();
  ForwardDynamicsOf<S, T> result{};
  const Status solved = execute<ImplicitStep>(links, h, in, q, qd, tau, drive, result);
  result.status = sound_status(links, collected_request(links, in, q, qd), result, solved);
  return result;
}

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
