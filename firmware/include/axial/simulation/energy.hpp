// Energy of a robot: what an integrator should neither make nor lose.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/recursion/loads.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Energy, J, and what there is to say about it.
template <class T>
struct Energy {
  T kinetic{};      ///< of links, rotors and a payload: qd^T M(q) qd / 2
  T potential{};    ///< of weight, 0 where all mass is at the world's origin, and of springs
  Status status{};  ///< as momentum_terms()
  /// both
  [[nodiscard]] AXIAL_INLINE constexpr T total() const { return kinetic + potential; }
};

namespace detail {

/// Weight and springs of the joints.
struct PotentialEnergy {
  using Roles = axial::Roles<role::Position>;  ///< of its argument
  /// J
  template <class Links, class Input, class Q>
  static constexpr auto run(const Links& links, const Input& in, const Q& q) {
    using T = typename Links::Scalar;
    const auto frame_0 = links.base_pose();
    const auto up = frame_0.rotation * base_acceleration(links, in);
    const auto frames = kinematics::frames(links, in, q);
    const TipLoads<typename Links::Scene, Input> loads(in);
    T sum = T(Zero{});
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      const auto link = links.link(i);
      const auto body = loads.body(link);
      const auto moment = frames[i].rotation * body.first_moment + body.mass * frames[i].position;
      sum = T(sum + dot(up, moment));
      if constexpr (Links::Scene::template has<JointSprings>) {
        const T stretch = T(q[i] - link.spring_rest());
        sum = T(sum + T(0.5) * T(link.spring_stiffness()) * stretch * stretch);
      }
    });
    return sum;
  }
};

template <class T, class Links, class Input, class Q, class V, class Terms>
constexpr Energy<T> energy_in(const Links& links, const Input& in, const Q& q, const V& qd, const Terms& terms) {
  Energy<T> energy;
  for (int i = 0; i < V::size; ++i)
    energy.kinetic += T(0.5) * qd[i] * terms.momentum[i];
  energy.potential = execute<PotentialEnergy>(links, in, q);
  energy.status = terms.status;
  return energy;
}

}  // namespace detail

/// Kinetic and potential energy at q (rad or m) and qd, in O(n): qd^T p / 2 of the momenta p = M(q) qd, what the
/// weights of links and of a payload have to fall, and the springs that the scene names. Of joints that share drives q
/// and qd are the drives'. For float and double; of words take to_real<float>(). Friction, drives and what else changes
/// it are the integrator's inputs.
template <class S, class T>
[[nodiscard]] constexpr Energy<T> energy(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                                         const Inputs<S, T>& in = no_inputs<S, T>()) {
  return detail::energy_in<T>(links_of<S, T>(), in, q, qd, momentum_terms<S>(q, qd, in));
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Energy<T> energy(const Model<N, F...>& model, const Positions<M, T>& q,
                                         const Velocities<M, T>& qd, const Inputs<M, T>& in = no_inputs<M, T>()) {
  return detail::energy_in<T>(model.template links<T>(), in, q, qd, momentum_terms(model, q, qd, in));
}

}  // namespace axial

#include <axial/options/end.hpp>
