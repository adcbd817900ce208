// Defines, beside AXIAL_C_EXPORT, the C function that AXIAL_C_DECLARE_ELASTIC (axial/axial.h) declares.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/c_interface/export.hpp>
#include <axial/transmissions/elastic_feedforward.hpp>

#include <axial/options/begin.hpp>

namespace axial::c_interface {

/// The feed-forward of elastic joints of one scene over numbers T. Pointers are not null.
template <class S, class T>
struct ElasticCalls : Calls<S, T> {
  using Base = Calls<S, T>;               ///< the other calls
  using Higher = Joints<robot_of<S>, T>;  ///< rad/s^3 and rad/s^4, or m

  /// axial::elastic_feedforward(): `result` is written where the status is ok.
  template <class C, class CResult>
  static axial_status elastic_feedforward(const C& c_q, const C& c_qd, const C& c_qdd, const C& c_q3, const C& c_q4,
                                          CResult& result) {
    const auto q = from_c<typename Base::Q>(c_q);
    const auto qd = from_c<typename Base::V>(c_qd);
    const auto qdd = from_c<typename Base::A>(c_qdd);
    const auto q3 = from_c<Higher>(c_q3), q4 = from_c<Higher>(c_q4);
    Status status = Base::check(q, qd, qdd);
    if (status.ok()) status = check_finite(q3, q4);
    if (!status.ok()) return to_c(status);
    const auto motors = axial::elastic_feedforward<S>(q, qd, qdd, q3, q4);
    status = CallCheck<S, T>::of_answer(motors.tau_m, motors.theta, motors.thetad, motors.tau_l);
    if (!status.ok()) return to_c(status);
    write_c(motors.tau_m, result.tau_m);
    write_c(motors.theta, result.theta);
    write_c(motors.thetad, result.thetad);
    write_c(motors.tau_l, result.tau_l);
    return to_c(status);
  }
};

}  // namespace axial::c_interface

/// Defines the function of AXIAL_C_DECLARE_ELASTIC(prefix) for the numbers that AXIAL_C_EXPORT has, and a robot that
/// declares a stiffness or a scene that names ElasticJoints. In one source of a program, in the global namespace,
/// without a semicolon.
#define AXIAL_C_EXPORT_ELASTIC(prefix, scene, number)                                                               \
  AXIAL_C_SHADOWS                                                                                                   \
  static_assert(axial::c_interface::check_export<prefix##_joints, scene, axial::c_interface::as_##number>());       \
  using prefix##_elastic_calls = axial::c_interface::ElasticCalls<scene, axial::c_interface::as_##number>;          \
  AXIAL_C_FUNCTION axial_status prefix##_elastic_feedforward(const prefix##_joints* q, const prefix##_joints* qd,   \
                                                             const prefix##_joints* qdd, const prefix##_joints* q3, \
                                                             const prefix##_joints* q4, prefix##_elastic* result) { \
    AXIAL_C_CALL(prefix##_elastic_calls, elastic_feedforward, (q, qd, qdd, q3, q4, result),                         \
                 (*q, *qd, *qdd, *q3, *q4, *result));                                                               \
  }                                                                                                                 \
  AXIAL_C_SHADOWS_END

#include <axial/options/end.hpp>
