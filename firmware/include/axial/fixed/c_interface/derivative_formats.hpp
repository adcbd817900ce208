// Defines the C function that AXIAL_C_DECLARE_DERIVATIVE_FORMATS (axial/axial.h) declares.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/c_interface/derivatives.hpp>
#include <axial/fixed/c_interface/fixed_calls.hpp>

#include <axial/options/begin.hpp>

namespace axial::c_interface {

/// Exponents of a matrix' entries into a C array.
template <class Matrix, class CMatrix>
constexpr void write_exponents_c(CMatrix& result) {
  for (int i = 0; i < Matrix::size; ++i)
    for (int j = 0; j < Matrix::size; ++j)
      result.of[i][j] = Matrix::exponent(i, j);
}

/// Formats of the derivatives of one scene over words T. Pointers are not null.
template <class S, class T>
struct DerivativeFormatCalls {
  /// Exponents of all entries.
  template <class CFormats>
  static axial_status get_derivative_formats(CFormats& formats) {
    using Slopes = AccelerationMatrices<S, T>;
    write_exponents_c<MassMatrixOf<S, T>>(formats.mass_matrix);
    write_exponents_c<JointMatrixOf<S, T, by::Position>>(formats.dtau_dq);
    write_exponents_c<JointMatrixOf<S, T, by::Velocity>>(formats.dtau_dqd);
    write_exponents_c<typename Slopes::ByEffort>(formats.inverse_mass_matrix);
    write_exponents_c<typename Slopes::ByPosition>(formats.dqdd_dq);
    write_exponents_c<typename Slopes::ByVelocity>(formats.dqdd_dqd);
    return ok;
  }
};

}  // namespace axial::c_interface

/// Defines the function of AXIAL_C_DECLARE_DERIVATIVE_FORMATS(prefix) for the scene that AXIAL_C_EXPORT has, in
/// fixed32. In one source of a program, in the global namespace, without a semicolon.
#define AXIAL_C_EXPORT_DERIVATIVE_FORMATS(prefix, scene)                                                     \
  static_assert(axial::c_interface::check_export<prefix##_joints, scene, axial::c_interface::as_fixed32>()); \
  using prefix##_derivative_format_calls =                                                                   \
      axial::c_interface::DerivativeFormatCalls<scene, axial::c_interface::as_fixed32>;                      \
  AXIAL_C_FUNCTION axial_status prefix##_get_derivative_formats(prefix##_derivative_formats* formats) {      \
    AXIAL_C_CALL(prefix##_derivative_format_calls, get_derivative_formats, (formats), (*formats));           \
  }

#include <axial/options/end.hpp>
