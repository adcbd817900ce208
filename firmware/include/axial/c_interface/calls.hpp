// What the exported functions do: C's structs to the library's types and back, and the checks that C cannot make.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/axial.h>
#include <axial/calls/registry.hpp>
#include <axial/control/feedforward.hpp>
#include <axial/dynamics/check_finite.hpp>

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

/// Says that an answer goes into a struct of C's: write() of an answer declared later is found by it.
struct ToC {};
/// Efforts and accelerations into a struct of C's.
template <class Values, class C>
constexpr void write(ToC, const Values& values, C& result) {
  write_c(values, result);
}
/// M into a struct of C's.
template <class R, class T, class C>
constexpr void write(ToC, const MassMatrix<R, T>& m, C& result) {
  write_matrix_c(m, m.size, result);
}
/// A vector into an array of C's.
template <class T, class Row>
constexpr void write(ToC, const Vec3<T>& v, Row& row) {
  row[0] = to_c(v.x), row[1] = to_c(v.y), row[2] = to_c(v.z);
}
/// The tool's pose into a struct of C's.
template <class R, class T, class C>
constexpr void write(ToC to, const ForwardKinematics<R, T>& poses, C& result) {
  const auto& rotation = poses.tool.rotation;
  write(to, rotation.x, result.rotation[0]), write(to, rotation.y, result.rotation[1]);
  write(to, rotation.z, result.rotation[2]), write(to, poses.tool.position, result.position);
}

/// What an answer says of itself, or of its accelerations; of what says nothing, whether it is finite.
///@{
template <class Check, class Answer>
constexpr auto status_in_c(const Answer& answer, int) -> decltype(Status(answer.status)) {
  return answer.status;
}
template <class Check, class Answer>
constexpr auto status_in_c(const Answer& answer, long) -> decltype(Status(answer.qdd.status)) {
  return answer.qdd.status;
}
template <class Check, class Answer>
constexpr Status status_in_c(const Answer& answer, ...) {
  return Check::of_answer(answer);
}
///@}

/// The functions of one scene over numbers T: of an algorithm on joint values, by the order of these.
template <class S, class T>
struct Calls {
  using Scene = S;                             ///< what algorithms are called for
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

  /// axial::feedforward(): its state in `state`, efforts in `tau` whatever the status. Pointers are not null.
  template <class CState, class C>
  static axial_status feedforward(CState& state, const C& q, const C& qd, const C& qdd, C& tau) {
    FeedforwardState<S, T> memory{from_c<Tau>(state.last_safe)};
    const auto result = axial::feedforward<S>(memory, from_c<Q>(q), from_c<V>(qd), from_c<A>(qdd));
    write_c(memory.last_safe, state.last_safe);
    write_c(result.tau, tau);
    return to_c(result.status);
  }

  /// An algorithm on joint values of such types, of which the third are efforts or not: `result` is written unless a
  /// pointer is null, an input is refused or the answer is no number.
  template <bool by_efforts, class... Values>
  struct Of {
    /// its status
    template <class Algorithm, class Result, class... C>
    static axial_status call(const Algorithm& algorithm, Result* result, const C*... given) {
      if (any_null(result, given...)) return null_argument;
      return answered<by_efforts>(algorithm, *result, from_c<Values>(*given)...);
    }
  };
  using position = Of<false, Q>;                                           ///< q
  using state = Of<false, Q, V>;                                           ///< q, qd
  using motion = Of<false, Q, V, A>;                                       ///< q, qd, qdd
  using driven = Of<true, Q, V, Tau>;                                      ///< q, qd, tau
  using highest = Of<false, Q, V, A, Joints<Robot, T>, Joints<Robot, T>>;  ///< q, qd, qdd, q3, q4

 private:
  static constexpr Status asked(std::false_type, const Q& q, const V& qd = {}, const A& qdd = {}) {
    return check(q, qd, qdd);
  }
  template <class... Higher>
  static constexpr Status asked(std::false_type, const Q& q, const V& qd, const A& qdd, const Higher&... higher) {
    const Status motion_status = check(q, qd, qdd);
    return motion_status.ok() ? check_finite(higher...) : motion_status;
  }
  static constexpr Status asked(std::true_type, const Q& q, const V& qd, const Tau& tau) {
    const Status state_status = check(q, qd);
    return state_status.ok() ? check_finite(tau) : state_status;
  }
  template <bool by_efforts, class Algorithm, class Result, class... Values>
  static axial_status answered(const Algorithm& algorithm, Result& result, const Values&... values) {
    const Status refused = asked(std::bool_constant<by_efforts>{}, values...);
    if (!refused.ok()) return to_c(refused);
    const auto answer = algorithm(values...);
    const Status status = status_in_c<CallCheck<S, T>>(answer, 0);
    if (status.code != Status::Code::not_finite) write(ToC{}, answer, result);
    return to_c(status);
  }
};

/// All calls of one scene over numbers T: a number system may have more.
template <class S, class T>
struct ExportedCalls : Calls<S, T> {};

}  // namespace axial::c_interface

#include <axial/options/end.hpp>
