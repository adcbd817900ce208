// The algorithms, a line each: what is said once of all of them is made of these lines.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/actuator_power.hpp>
#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/derivatives/torque_rates.hpp>
#include <axial/derivatives/torque_regressor.hpp>
#include <axial/dynamics/base_wrench.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/elastic/elastic_feedforward.hpp>
#include <axial/scene/refused_calls.hpp>
#include <axial/separation/separation.hpp>

/// ROW(function, number and order of its joint values (joint_roles.hpp), what it answers over a scene and numbers, its
/// type and its name in namespace algorithm).
///@{
#define AXIAL_ALGORITHMS_OVER_MODELS(ROW)                                                        \
  ROW(inverse_dynamics, 3, Motion, EffortsOf, InverseDynamics, inverse_dynamics)                 \
  ROW(actuator_power, 3, Motion, PowersOf, ActuatorPower, actuator_power)                        \
  ROW(gravity_torque, 1, Position, EffortsOf, Gravity, gravity)                                  \
  ROW(bias_torque, 2, State, EffortsOf, Bias, bias)                                              \
  ROW(forward_dynamics, 3, Driven, ForwardDynamicsOf, ForwardDynamics, forward_dynamics)         \
  ROW(mass_matrix, 1, Position, MassMatrixOf, MassMatrix, mass_matrix)                           \
  ROW(forward_kinematics, 1, Position, ForwardKinematics, ForwardKinematics, forward_kinematics) \
  ROW(jacobian, 1, Position, Jacobian, Jacobian, jacobian)                                       \
  ROW(separate, 1, Position, Separated, Separation, separation)                                  \
  ROW(momentum_terms, 2, State, MomentumTerms, MomentumTerms, momentum_terms)                    \
  ROW(base_wrench, 3, Motion, WrenchOf, BaseWrench, base_wrench)                                 \
  ROW(torque_regressor, 3, Motion, TorqueRegressor, TorqueRegressor, torque_regressor)           \
  ROW(torque_rates, 5, Highest, TorqueRates, TorqueRates, torque_rates)
#define AXIAL_ALGORITHMS(ROW)       \
  AXIAL_ALGORITHMS_OVER_MODELS(ROW) \
  ROW(elastic_feedforward, 5, Highest, ElasticFeedforward, ElasticFeedforward, elastic_feedforward)
/// The same of those whose results are chosen by name.
#define AXIAL_ALGORITHMS_OF_CHOICE(ROW)                                                                \
  ROW(inverse_dynamics_derivatives, 3, Motion, InverseDynamicsDerivatives, InverseDynamicsDerivatives, \
      inverse_dynamics_derivatives)                                                                    \
  ROW(forward_dynamics_derivatives, 3, Driven, ForwardDynamicsDerivatives, ForwardDynamicsDerivatives, \
      forward_dynamics_derivatives)
///@}

#include <axial/options/begin.hpp>

namespace axial {

/// Refused: what the call of an algorithm takes, where nothing else can be called; the text is one that a compiler
/// shows whole.
///@{
// clang-format off
template <class S = void, class... F> constexpr detail::Refused inverse_dynamics(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("inverse_dynamics", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused actuator_power(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("actuator_power", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused gravity_torque(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("gravity_torque", "q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused bias_torque(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("bias_torque", "q, qd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused forward_dynamics(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("forward_dynamics", "q, qd, tau")); return {}; }
template <class S = void, class... F> constexpr detail::Refused mass_matrix(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("mass_matrix", "q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused forward_kinematics(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("forward_kinematics", "q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused jacobian(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("jacobian", "q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused separate(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("separate", "q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused momentum_terms(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("momentum_terms", "q, qd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused torque_regressor(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("torque_regressor", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused inverse_dynamics_derivatives(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("inverse_dynamics_derivatives", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused forward_dynamics_derivatives(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("forward_dynamics_derivatives", "q, qd, tau")); return {}; }
template <class S = void, class... F> constexpr detail::Refused base_wrench(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("base_wrench", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused torque_rates(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("torque_rates", "q, qd, qdd, q3, q4")); return {}; }
template <class S = void, class... F> constexpr detail::Refused elastic_feedforward(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("elastic_feedforward", "q, qd, qdd, q3, q4")); return {}; }
template <class S, int I> constexpr detail::Refused joint_torque(...) { static_assert(detail::is_offered<S>, AXIAL_NO_SUCH_CALL("joint_torque", "q, qd, qdd")); return {}; }
template <class S, int I> constexpr detail::Refused gravity_torque(...) { static_assert(detail::is_offered<S>, AXIAL_NO_SUCH_CALL("gravity_torque", "q")); return {}; }
template <class S, int I> constexpr detail::Refused jacobian(...) { static_assert(detail::is_offered<S>, AXIAL_NO_SUCH_CALL("jacobian", "q")); return {}; }
// clang-format on
///@}

}  // namespace axial

#include <axial/options/end.hpp>
