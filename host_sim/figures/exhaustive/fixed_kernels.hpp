// The kernels that fixed point has, over FixedState.
#pragma once

#include <host_sim/figures/exhaustive/fixed_states.hpp>

namespace exhaustive {

// Kernels as types: run(state) answers joint values of a role.
template <class S, class T>
struct InverseDynamics {
  static constexpr const char* name = "inverse_dynamics";
  static auto run(const FixedState<S, T>& s) { return axial::inverse_dynamics<S>(s.q, s.qd, s.qdd); }
};
template <class S, class T>
struct BiasTorque {
  static constexpr const char* name = "bias";
  static auto run(const FixedState<S, T>& s) { return axial::bias_torque<S>(s.q, s.qd); }
};
template <class S, class T>
struct GravityTorque {
  static constexpr const char* name = "gravity";
  static auto run(const FixedState<S, T>& s) { return axial::gravity_torque<S>(s.q); }
};
template <class S, class T>
struct ForwardDynamics {
  static constexpr const char* name =
      axial::scene_of<S>::template has<axial::ArticulatedBody> ? "articulated_body" : "split_articulated_body";
  static auto run(const FixedState<S, T>& s) { return axial::forward_dynamics<S>(s.q, s.qd, s.tau); }
};
template <class S, class T>
struct ClosedForm {
  static constexpr const char* name = "closed_form";
  static auto run(const FixedState<S, T>& s) { return axial::closed_form::scara_torque<S>(s.q, s.qd, s.qdd); }
};

/// Results of a kernel that did not fit, over `states` states of a checked scene.
template <template <class, class> class Kernel, class S, class T>
std::uint64_t overflows(std::uint64_t states, std::uint64_t seed) {
  Random random(seed);
  const std::uint64_t before = axial::range_overflows;
  for (std::uint64_t k = 0; k < states; ++k) {
    const auto result = Kernel<S, T>::run(next_state<FixedState<S, T>>(random, k));
    static_cast<void>(*const_cast<const volatile typename T::Word*>(&result.values[0].raw));
  }
  return axial::range_overflows - before;
}

}  // namespace exhaustive
