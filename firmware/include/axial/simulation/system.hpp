// A robot as an integrator asks it: accelerations, explicit or of an implicit step. A scene, or a run-time model.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/simulation/driven_step.hpp>
#include <axial/simulation/motion.hpp>
#include <axial/simulation/stiff_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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
}  // namespace axial

#include <axial/options/end.hpp>
