// Defines, beside AXIAL_C_EXPORT, the C function that AXIAL_C_DECLARE_ELASTIC (axial/axial.h) declares.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/c_interface/export.hpp>
#include <axial/elastic/elastic_feedforward.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The first joint of whose motor something is not finite.
template <class S, class T>
[[nodiscard]] constexpr Status check_finite(const ElasticFeedforward<S, T>& motors) {
  return check_finite(motors.tau_m, motors.theta, motors.thetad, motors.tau_l);
}

}  // namespace axial

namespace axial::c_interface {

/// What motors do into a struct of C's.
template <class S, class T, class C>
constexpr void write(ToC, const ElasticFeedforward<S, T>& motors, C& result) {
  write_c(motors.tau_m, result.tau_m);
  write_c(motors.theta, result.theta);
  write_c(motors.thetad, result.thetad);
  write_c(motors.tau_l, result.tau_l);
}

}  // namespace axial::c_interface

/// Defines the function of AXIAL_C_DECLARE_ELASTIC(prefix) for the numbers that AXIAL_C_EXPORT has, and a robot that
/// declares a stiffness or a scene that names ElasticJoints. In one source of a program, in the global namespace,
/// without a semicolon.
#define AXIAL_C_EXPORT_ELASTIC(prefix, scene, number)                                                                 \
  AXIAL_C_SHADOWS                                                                                                     \
  static_assert(axial::c_interface::check_export<prefix##_joints, scene, axial::c_interface::as_##number>());         \
  using prefix##_elastic_calls = axial::c_interface::Calls<scene, axial::c_interface::as_##number>;                   \
  AXIAL_C_DEFINED(prefix, prefix##_elastic_calls, elastic_feedforward, elastic_feedforward, highest, elastic, result) \
  AXIAL_C_SHADOWS_END

#include <axial/options/end.hpp>
