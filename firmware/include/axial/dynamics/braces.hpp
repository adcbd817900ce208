// Kernels on numbers in braces: inverse_dynamics<Arm>({0.1F, 0.2F}, {1.0F, 0.0F}, {0.0F, 0.0F}).
#pragma once

#include <axial/dynamics/derivatives_on_arrays.hpp>
#include <axial/dynamics/models_on_arrays.hpp>
#include <axial/dynamics/plain_arrays.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// N numbers, as an array has them.
template <class T, std::size_t N>
struct BracedNumbers {
  static constexpr std::size_t extent = N;
  T numbers[N];
  [[nodiscard]] constexpr const T* data() const { return numbers; }
};

template <std::size_t, class T>
using Repeated = T;

/// What braces become where a kernel takes joint values: a number for each joint, none narrowed. A compiler deduces no
/// type from braces, so that this is the default of the type of each argument.
template <class S, class T = float, class Each = std::make_index_sequence<joint_count<S>>>
struct Braces;
template <class S, class T, std::size_t... I>
struct Braces<S, T, std::index_sequence<I...>> : BracedNumbers<T, sizeof...(I)> {
  constexpr Braces(Repeated<I, T>... values) : BracedNumbers<T, sizeof...(I)>{{values...}} {}
  // Counts are parameters, so that a compiler says what they are.
  template <class... V, std::size_t numbers = sizeof...(V), std::size_t joints = sizeof...(I),
            class = std::enable_if_t<numbers != joints && (true && ... && std::is_arithmetic_v<V>)>>
  constexpr Braces(V...) : BracedNumbers<T, sizeof...(I)>{} {
    static_assert(numbers == joints, "axial: braces hold one number for each joint");
  }
};

template <class A>
inline constexpr bool is_braces = false;
template <class S, class T, class Each>
inline constexpr bool is_braces<Braces<S, T, Each>> = true;

/// Where braces stand for joint values, and no number: a scalar may be named instead, inverse_dynamics<Arm, double>.
template <class... A>
using IfAnyIsBraced = std::enable_if_t<(false || ... || is_braces<A>)&&!(false || ... || std::is_arithmetic_v<A>), int>;

/// Braces as an array; other joint values as they are.
///@{
template <class A>
AXIAL_INLINE constexpr const A& unbraced(const A& given) {
  return given;
}
template <class S, class T, std::size_t... I>
AXIAL_INLINE constexpr const BracedNumbers<T, sizeof...(I)>& unbraced(
    const Braces<S, T, std::index_sequence<I...>>& given) {
  return given;
}
///@}

}  // namespace detail

/// The kernels of the same names on braces that hold a number for each joint, of float, instead of joint values or
/// mixed with them and with arrays. Braces of another scalar: inverse_dynamics<Arm, double>({...}, ...).
///@{
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics(const A& q, const B& qd, const C& x, const In&... in) {
  return inverse_dynamics<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto gravity_torque(const A& q, const In&... in) {
  return gravity_torque<S>(detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B> = 0>
[[nodiscard]] constexpr auto bias_torque(const A& q, const B& qd, const In&... in) {
  return bias_torque<S>(detail::unbraced(q), detail::unbraced(qd), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics(const A& q, const B& qd, const C& x, const In&... in) {
  return forward_dynamics<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto mass_matrix(const A& q, const In&... in) {
  return mass_matrix<S>(detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto forward_kinematics(const A& q, const In&... in) {
  return forward_kinematics<S>(detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto jacobian(const A& q, const In&... in) {
  return jacobian<S>(detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto separate(const A& q, const In&... in) {
  return separate<S>(detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B> = 0>
[[nodiscard]] constexpr auto momentum_terms(const A& q, const B& qd, const In&... in) {
  return momentum_terms<S>(detail::unbraced(q), detail::unbraced(qd), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto torque_regressor(const A& q, const B& qd, const C& x, const In&... in) {
  return torque_regressor<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <class S, int Joint, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class... In, detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto joint_torque(const A& q, const B& qd, const C& x, const In&... in) {
  return joint_torque<S, Joint>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <class S, int Joint, class A = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto gravity_torque(const A& q, const In&... in) {
  return gravity_torque<S, Joint>(detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class D = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A, B, C, D> = 0>
[[nodiscard]] constexpr auto torque_rates(const A& q, const B& qd, const C& qdd, const D& q3, const In&... in) {
  return torque_rates<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(qdd), detail::unbraced(q3), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class D = detail::Braces<S>, class E = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B, C, D, E> = 0>
[[nodiscard]] constexpr auto torque_rates(const A& q, const B& qd, const C& qdd, const D& q3, const E& q4,
                                          const In&... in) {
  return torque_rates<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(qdd), detail::unbraced(q3),
                         detail::unbraced(q4), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class D = detail::Braces<S>, class E = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B, C, D, E> = 0>
[[nodiscard]] constexpr auto elastic_feedforward(const A& q, const B& qd, const C& qdd, const D& q3, const E& q4,
                                                 const In&... in) {
  return elastic_feedforward<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(qdd), detail::unbraced(q3),
                                detail::unbraced(q4), in...);
}
template <class S, class... Wanted, class A = detail::Braces<S>, class B = detail::Braces<S>,
          class C = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics_derivatives(const A& q, const B& qd, const C& x, const In&... in) {
  return inverse_dynamics_derivatives<S, Wanted...>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x),
                                                    in...);
}
template <class S, class... Wanted, class A = detail::Braces<S>, class B = detail::Braces<S>,
          class C = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics_derivatives(const A& q, const B& qd, const C& x, const In&... in) {
  return forward_dynamics_derivatives<S, Wanted...>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x),
                                                    in...);
}
///@}

/// Those over a run-time model.
///@{
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class C = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics(const Model<N, F...>& model, const A& q, const B& qd, const C& x,
                                              const In&... in) {
  return inverse_dynamics(model, detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto gravity_torque(const Model<N, F...>& model, const A& q, const In&... in) {
  return gravity_torque(model, detail::unbraced(q), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class... In, detail::IfAnyIsBraced<A, B> = 0>
[[nodiscard]] constexpr auto bias_torque(const Model<N, F...>& model, const A& q, const B& qd, const In&... in) {
  return bias_torque(model, detail::unbraced(q), detail::unbraced(qd), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class C = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics(const Model<N, F...>& model, const A& q, const B& qd, const C& x,
                                              const In&... in) {
  return forward_dynamics(model, detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto mass_matrix(const Model<N, F...>& model, const A& q, const In&... in) {
  return mass_matrix(model, detail::unbraced(q), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto forward_kinematics(const Model<N, F...>& model, const A& q, const In&... in) {
  return forward_kinematics(model, detail::unbraced(q), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto jacobian(const Model<N, F...>& model, const A& q, const In&... in) {
  return jacobian(model, detail::unbraced(q), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto separate(const Model<N, F...>& model, const A& q, const In&... in) {
  return separate(model, detail::unbraced(q), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class... In, detail::IfAnyIsBraced<A, B> = 0>
[[nodiscard]] constexpr auto momentum_terms(const Model<N, F...>& model, const A& q, const B& qd, const In&... in) {
  return momentum_terms(model, detail::unbraced(q), detail::unbraced(qd), in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class C = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto torque_regressor(const Model<N, F...>& model, const A& q, const B& qd, const C& x,
                                              const In&... in) {
  return torque_regressor(model, detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <class... Wanted, int N, class... F, class A = detail::Braces<Model<N, F...>>,
          class B = detail::Braces<Model<N, F...>>, class C = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics_derivatives(const Model<N, F...>& model, const A& q, const B& qd,
                                                          const C& x, const In&... in) {
  return inverse_dynamics_derivatives<Wanted...>(model, detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x),
                                                 in...);
}
template <class... Wanted, int N, class... F, class A = detail::Braces<Model<N, F...>>,
          class B = detail::Braces<Model<N, F...>>, class C = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics_derivatives(const Model<N, F...>& model, const A& q, const B& qd,
                                                          const C& x, const In&... in) {
  return forward_dynamics_derivatives<Wanted...>(model, detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x),
                                                 in...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
