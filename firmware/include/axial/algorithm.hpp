// The algorithms as values: what cost<Scene>() and error_bound<Scene>() are asked for, and what a program calls that
// runs them all.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/registry.hpp>
#include <axial/closed_form/scara.hpp>
#include <axial/derivatives/forward_dynamics_along.hpp>
#include <axial/derivatives/inverse_dynamics_along.hpp>
#include <axial/separation/separated_torque.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Third and fourth derivatives of joint positions by time.
template <class S, class T>
struct HigherDerivatives {
  Joints<robot_of<S>, T> q3{};  ///< rad/s^3 or m/s^3
  Joints<robot_of<S>, T> q4{};  ///< rad/s^4 or m/s^4
};

namespace detail {

/// A function of so many joint values, called with more, with two that a struct holds, or with a direction.
///@{
template <int joint_values, class F, class J, class In>
constexpr auto applied(const F& f, const J& q, [[maybe_unused]] const J& qd, [[maybe_unused]] const J& x,
                       const In& in) {
  if constexpr (joint_values == 1)
    return f(q, in);
  else if constexpr (joint_values == 2)
    return f(q, qd, in);
  else
    return f(q, qd, x, in);
}
template <int joint_values, class F, class J, class D, class In>
constexpr auto applied(const F& f, const J& q, const J& qd, const J& x, const D& more, const In& in) {
  if constexpr (joint_values == 5)
    return f(q, qd, x, more.q3, more.q4, in);
  else
    return f(q, qd, x, more, in);
}
///@}

/// What algorithms as values call: of gravity also where the chain does not say which way it pulls.
namespace functions {
using namespace axial;
template <class S, class J, class In>
constexpr auto gravity_torque(const J& q, const In& in) {
  return holding_torque<S>(q, in);
}
}  // namespace functions

}  // namespace detail

/// The algorithms by name. Each has `name` and `run<S>(q, qd, x, in)`, x being accelerations or efforts, over any
/// number system; before `in` HigherDerivatives of torque_rates and elastic_feedforward, a direction of those along
/// one.
namespace algorithm {

/// A line of calls/registry.hpp as a type and a value: `function` of axial, of so many joint values.
#define AXIAL_AS_A_VALUE(function, count, order, answer, type, value)                                        \
  struct type {                                                                                              \
    static constexpr const char* name = #value;                                                              \
    static constexpr int joint_values = count;                                                               \
    template <class S, class T>                                                                              \
    using Answer = detail::functions::answer<S, T>;                                                          \
    template <class S, class... Given>                                                                       \
    static constexpr auto run(const Given&... given) {                                                       \
      return detail::applied<count>([](const auto&... at) { return detail::functions::function<S>(at...); }, \
                                    given...);                                                               \
    }                                                                                                        \
  };                                                                                                         \
  inline constexpr type value;
AXIAL_ALGORITHMS(AXIAL_AS_A_VALUE)
AXIAL_ALGORITHMS_OF_CHOICE(AXIAL_AS_A_VALUE)
/// With a direction besides.
///@{
AXIAL_AS_A_VALUE(inverse_dynamics_along, 3, Motion, EffortsAlong, InverseDynamicsAlong, inverse_dynamics_along)
AXIAL_AS_A_VALUE(forward_dynamics_along, 3, Driven, AccelerationsAlong, ForwardDynamicsAlong, forward_dynamics_along)
///@}
#undef AXIAL_AS_A_VALUE

/// torque() from terms that are there already.
struct SeparatedTorque {
  static constexpr const char* name = "separated_torque";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class T, class J>
  static constexpr auto run(const Separated<S, T>& separated, const J& qd, const J& qdd) {
    return axial::torque(separated, qd, qdd);
  }
};
/// Only for robots of the SCARA's structure: all terms, and the torque.
struct ClosedFormSeparation {
  static constexpr const char* name = "closed_form_separation";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J&, const J&, const In&) {
    return closed_form::scara<robot_of<S>>(q);
  }
};
/// closed_form::scara_torque(): only for robots of the SCARA's structure.
struct ClosedForm {
  static constexpr const char* name = "closed_form";  ///< in files, tables and JSON
  /// Runs it for the scene S.
  template <class S, class J, class In>
  static constexpr auto run(const J& q, const J& qd, const J& qdd, const In&) {
    return closed_form::scara_torque<robot_of<S>>(q, qd, qdd);
  }
};

/// The algorithm of that name, as an argument.
///@{
inline constexpr SeparatedTorque separated_torque;
inline constexpr ClosedFormSeparation closed_form_separation;
inline constexpr ClosedForm closed_form;
///@}

}  // namespace algorithm

}  // namespace axial

#include <axial/options/end.hpp>
