// What the exported functions do: C's structs to the library's types and back, and the checks that C cannot make.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/axial.h>
#include <axial/control/feedforward.hpp>
#include <axial/dynamics/check_finite.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial::c_interface {

/// Numbers by the names that AXIAL_C_DECLARE takes.
using as_float = float;
using as_double = double;    ///< AXIAL_C_DECLARE(..., double)
using as_fixed32 = Fixed32;  ///< AXIAL_C_DECLARE(..., fixed32)

/// Numbers T in C.
template <class T>
struct InC {
  static_assert(std::is_same_v<typename axial::detail::Substitute<T>::type, T>,
                "axial: fixed point is a plug-in: add #include <axial/fixed/c_interface/fixed_calls.hpp>");
  using type = T;                                        ///< what C holds one in
  static constexpr type value(const T& x) { return x; }  ///< one as C holds it
};
/// What C holds a number T in: of fixed point the word.
template <class T>
using CNumber = typename InC<T>::type;

/// A number as C holds it.
template <class T>
constexpr CNumber<T> to_c(const T& x) {
  return InC<T>::value(x);
}
/// Joint values of a C array.
template <class Values, class CValues>
constexpr Values from_c(const CValues& values) {
  Values result{};
  for (int i = 0; i < Values::size; ++i)
    result[i] = {values.of[i]};
  return result;
}
/// Joint values into a C array.
template <class Values, class CValues>
constexpr void write_c(const Values& values, CValues& result) {
  for (int i = 0; i < Values::size; ++i)
    result.of[i] = to_c(values[i]);
}
/// A matrix with a row and a column per joint into a C array.
template <class Matrix, class CMatrix>
constexpr void write_matrix_c(const Matrix& m, int size, CMatrix& result) {
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      result.of[i][j] = to_c(m(i, j));
}

/// A status in C, with the codes of axial_code.
constexpr axial_status to_c(const Status& status) { return {static_cast<int>(status.code), status.joint}; }
/// Whether any of the pointers is null.
template <class... Pointers>
constexpr bool any_null(const Pointers*... pointers) {
  return (false || ... || (pointers == nullptr));
}
inline constexpr axial_status ok{AXIAL_OK, -1}, null_argument{AXIAL_NULL_ARGUMENT, -1};  ///< a status without a joint

/// What a call looks at: floating point may be asked beyond the declared limits.
template <class S, class T>
struct CallCheck {
  /// the first value that is not finite; an angle of so many turns that its sine is not exact
  template <class Q, class V, class A>
  static constexpr Status of(const Q& q, const V& qd, const A& qdd) {
    const Status finite = check_finite(q, qd, qdd);
    return finite.ok() ? detail::collected_request(links_of<S, T>(), Inputs<S, T>{}, q, qd).of_numbers() : finite;
  }
  /// an answer that overflowed
  template <class... Values>
  static constexpr Status of_answer(const Values&... values) {
    return first_bad(check_finite(values)...);
  }

 private:
  template <class... Other>
  static constexpr Status first_bad(const Status& first, const Other&... other) {
    if constexpr (sizeof...(other) > 0)
      return first.ok() ? first_bad(other...) : first;
    else
      return first;
  }
};

/// The functions of one scene over numbers T. Pointers are not null.
template <class S, class T>
struct Calls {
  using Robot = robot_of<S>;                   ///< the robot alone
  using Q = Positions<Robot, T>;               ///< rad or m
  using V = Velocities<Robot, T>;              ///< rad/s or m/s
  using A = Accelerations<Robot, T>;           ///< rad/s^2 or m/s^2
  using Tau = EffortsOf<S, T>;                 ///< N m or N
  static constexpr int size = joint_count<S>;  ///< number of joints

  /// First value that is not finite; in fixed point also the first outside the declared limits.
  static constexpr Status check(const Q& q, const V& qd = {}, const A& qdd = {}) {
    return CallCheck<S, T>::of(q, qd, qdd);
  }

  /// axial::feedforward(): its state in `state`, efforts in `tau` whatever the status.
  template <class CState, class C>
  static axial_status feedforward(CState& state, const C& q, const C& qd, const C& qdd, C& tau) {
    FeedforwardState<S, T> memory{from_c<Tau>(state.last_safe)};
    const auto result = axial::feedforward<S>(memory, from_c<Q>(q), from_c<V>(qd), from_c<A>(qdd));
    write_c(memory.last_safe, state.last_safe);
    write_c(result.tau, tau);
    return to_c(result.status);
  }

  /// axial::inverse_dynamics(): `tau` is written where the status is ok.
  template <class C>
  static axial_status inverse_dynamics(const C& c_q, const C& c_qd, const C& c_qdd, C& tau) {
    const auto q = from_c<Q>(c_q);
    const auto qd = from_c<V>(c_qd);
    const auto qdd = from_c<A>(c_qdd);
    const Status status = check(q, qd, qdd);
    return status.ok() ? answered(axial::inverse_dynamics<S>(q, qd, qdd), tau) : to_c(status);
  }

  /// axial::gravity_torque(): `tau` is written where the status is ok.
  template <class C>
  static axial_status gravity(const C& c_q, C& tau) {
    const auto q = from_c<Q>(c_q);
    const Status status = check(q);
    return status.ok() ? answered(gravity_torque<S>(q), tau) : to_c(status);
  }

  /// axial::forward_dynamics(): `qdd` is written unless an input is refused or the answer is no number; the status is
  /// the solver's.
  template <class C>
  static axial_status forward_dynamics(const C& c_q, const C& c_qd, const C& c_tau, C& qdd) {
    const auto q = from_c<Q>(c_q);
    const auto qd = from_c<V>(c_qd);
    const auto tau = from_c<Tau>(c_tau);
    Status status = check(q, qd);
    if (status.ok()) status = check_finite(tau);
    if (!status.ok()) return to_c(status);
    const auto result = axial::forward_dynamics<S>(q, qd, tau);
    if (result.status.code != Status::Code::not_finite) write_c(result, qdd);
    return to_c(result.status);
  }

  /// axial::mass_matrix(): `matrix` is written where the status is ok.
  template <class C, class CMatrix>
  static axial_status mass_matrix(const C& c_q, CMatrix& matrix) {
    const auto q = from_c<Q>(c_q);
    if (const Status status = check(q); !status.ok()) return to_c(status);
    const auto m = axial::mass_matrix<S>(q);
    const Status status = CallCheck<S, T>::of_answer(m);
    if (status.ok()) write_matrix_c(m, size, matrix);
    return to_c(status);
  }

  /// axial::forward_kinematics(), the tool alone: `pose` is written where the status is ok.
  template <class C, class CPose>
  static axial_status tool_pose(const C& c_q, CPose& pose) {
    const auto q = from_c<Q>(c_q);
    if (const Status status = check(q); !status.ok()) return to_c(status);
    const auto poses = forward_kinematics<S>(q);
    if (!poses.status.ok()) return to_c(poses.status);
    const auto& tool = poses.tool;
    write_row(tool.rotation.x, pose.rotation[0]);
    write_row(tool.rotation.y, pose.rotation[1]);
    write_row(tool.rotation.z, pose.rotation[2]);
    write_row(tool.position, pose.position);
    return to_c(poses.status);
  }

 private:
  /// Efforts are written unless they overflowed.
  template <class C>
  static axial_status answered(const Tau& efforts, C& tau) {
    const Status status = CallCheck<S, T>::of_answer(efforts);
    if (status.ok()) write_c(efforts, tau);
    return to_c(status);
  }
  static constexpr void write_row(const Vec3<T>& v, CNumber<T> (&row)[3]) {
    row[0] = to_c(v.x);
    row[1] = to_c(v.y);
    row[2] = to_c(v.z);
  }
};

/// All calls of one scene over numbers T: a number system may have more.
template <class S, class T>
struct ExportedCalls : Calls<S, T> {};

}  // namespace axial::c_interface

#include <axial/options/end.hpp>
