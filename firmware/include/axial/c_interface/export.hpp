// Defines, in one C++ source, the C functions that AXIAL_C_DECLARE (axial/axial.h) declares.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/c_interface/calls.hpp>

#include <axial/options/begin.hpp>

namespace axial::c_interface {

/// Joints of a struct that AXIAL_C_DECLARE made, and what it holds them in.
template <class CJoints>
inline constexpr int declared_joints = sizeof(CJoints{}.of) / sizeof(CJoints{}.of[0]);
/// What such a struct holds a value in.
template <class CJoints>
using DeclaredNumber = std::decay_t<decltype(CJoints{}.of[0])>;

/// Everything that a declaration and an export can disagree about.
template <class CJoints, class S, class T>
constexpr bool check_export() {
  static_assert(declared_joints<CJoints> == joint_count<S>,
                "axial: AXIAL_C_DECLARE and AXIAL_C_EXPORT disagree about the number of joints; write the robot's "
                "number of joints as second argument of AXIAL_C_DECLARE");
  static_assert(std::is_same_v<DeclaredNumber<CJoints>, CNumber<T>>,
                "axial: AXIAL_C_DECLARE and AXIAL_C_EXPORT disagree about the numbers; write the same third argument "
                "(float, double or fixed32) in both");
  static_assert(!has_run_time_inputs<S, T> && !scene_of<S>::template has<FloatingBase>,
                "axial: the C interface has no run-time inputs and no floating base; export a scene without Payload, "
                "RuntimeGravity, TipWrench, BaseMotion, FloatingBase and the like");
  return true;
}

static_assert(AXIAL_OK == static_cast<int>(Status::Code::ok) &&
              AXIAL_NEAR_SINGULAR == static_cast<int>(Status::Code::near_singular) &&
              AXIAL_NOT_FINITE == static_cast<int>(Status::Code::not_finite) &&
              AXIAL_POSITION_LIMIT == static_cast<int>(Status::Code::position_limit) &&
              AXIAL_SPEED_LIMIT == static_cast<int>(Status::Code::speed_limit) &&
              AXIAL_ACCELERATION_LIMIT == static_cast<int>(Status::Code::acceleration_limit) &&
              AXIAL_EFFORT_LIMIT == static_cast<int>(Status::Code::effort_limit) &&
              AXIAL_PAYLOAD_LIMIT == static_cast<int>(Status::Code::payload_limit) &&
              AXIAL_NOT_READY == static_cast<int>(Status::Code::not_ready) &&
              AXIAL_SATURATED == static_cast<int>(Status::Code::saturated) &&
              AXIAL_RESCALED == static_cast<int>(Status::Code::rescaled) &&
              AXIAL_INPUT_LIMIT == static_cast<int>(Status::Code::input_limit) &&
              AXIAL_ANGLE_RANGE == static_cast<int>(Status::Code::angle_range) &&
              AXIAL_INACCURATE == static_cast<int>(Status::Code::inaccurate) &&
              AXIAL_EFFORT_RATE == static_cast<int>(Status::Code::effort_rate) &&
              AXIAL_COMMAND_LIMIT == static_cast<int>(Status::Code::command_limit) &&
              AXIAL_CURRENT_LIMIT == static_cast<int>(Status::Code::current_limit));

}  // namespace axial::c_interface

/// Between them a parameter q may shadow the user's global q.
///@{
#define AXIAL_C_SHADOWS _Pragma("GCC diagnostic push") _Pragma("GCC diagnostic ignored \"-Wshadow\"")
#define AXIAL_C_SHADOWS_END _Pragma("GCC diagnostic pop")
///@}

// NOLINTBEGIN(bugprone-macro-parentheses): a parameter's name
/// The C function of an algorithm, by the order of its arguments.
#define AXIAL_C_DEFINED(prefix, calls, name, algorithm, order, type, result)                                   \
  AXIAL_C_FUNCTION axial_status prefix##_##name(AXIAL_C_TAKEN_##order(prefix), prefix##_##type* result) {      \
    return calls::order::call([](const auto&... at) { return axial::algorithm<calls::Scene>(at...); }, result, \
                              AXIAL_C_NAMES_##order);                                                          \
  }
// NOLINTEND(bugprone-macro-parentheses)
/// The arguments' names, in each order.
///@{
#define AXIAL_C_NAMES_position q
#define AXIAL_C_NAMES_state q, qd
#define AXIAL_C_NAMES_motion q, qd, qdd
#define AXIAL_C_NAMES_driven q, qd, tau
#define AXIAL_C_NAMES_highest q, qd, qdd, q3, q4
///@}
/// One C function: the call of the same name, unless a pointer is null.
#define AXIAL_C_CALL(calls, name, pointers, values) \
  return axial::c_interface::any_null pointers ? axial::c_interface::null_argument : calls::name values

/// The functions that fixed point alone has.
///@{
#define AXIAL_C_EXPORT_MORE_float(prefix)
#define AXIAL_C_EXPORT_MORE_double(prefix)
#define AXIAL_C_EXPORT_MORE_fixed32(prefix)                                                                     \
  AXIAL_C_FUNCTION axial_status prefix##_get_formats(prefix##_formats* formats) {                               \
    AXIAL_C_CALL(prefix##_calls, get_formats, (formats), (*formats));                                           \
  }                                                                                                             \
  AXIAL_C_FUNCTION axial_status prefix##_to_fixed(const prefix##_real* real_q, const prefix##_real* real_qd,    \
                                                  const prefix##_real* real_qdd, prefix##_joints* q,            \
                                                  prefix##_joints* qd, prefix##_joints* qdd) {                  \
    AXIAL_C_CALL(prefix##_calls, to_fixed, (real_q, real_qd, real_qdd, q, qd, qdd),                             \
                 (*real_q, *real_qd, *real_qdd, *q, *qd, *qdd));                                                \
  }                                                                                                             \
  AXIAL_C_FUNCTION axial_status prefix##_efforts_to_real(const prefix##_joints* tau, prefix##_real* real_tau) { \
    AXIAL_C_CALL(prefix##_calls, efforts_to_real, (tau, real_tau), (*tau, *real_tau));                          \
  }
///@}

/// Defines the functions of AXIAL_C_DECLARE(prefix, joints, number) for a robot or a scene (by an alias where its name
/// has commas). In one source of a program, in the global namespace, without a semicolon.
#define AXIAL_C_EXPORT(prefix, scene, number)                                                                 \
  AXIAL_C_SHADOWS                                                                                             \
  static_assert(axial::c_interface::check_export<prefix##_joints, scene, axial::c_interface::as_##number>()); \
  using prefix##_calls = axial::c_interface::ExportedCalls<scene, axial::c_interface::as_##number>;           \
  AXIAL_C_EXPORT_MORE_##number(prefix) AXIAL_C_FUNCTION axial_status prefix##_feedforward(                    \
      prefix##_state* state, const prefix##_joints* q, const prefix##_joints* qd, const prefix##_joints* qdd, \
      prefix##_joints* tau) {                                                                                 \
    AXIAL_C_CALL(prefix##_calls, feedforward, (state, q, qd, qdd, tau), (*state, *q, *qd, *qdd, *tau));       \
  }                                                                                                           \
  AXIAL_C_ALGORITHMS(AXIAL_C_DEFINED, prefix, prefix##_calls)                                                 \
  AXIAL_C_SHADOWS_END

#include <axial/options/end.hpp>
