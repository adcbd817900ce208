// What the exported functions do: C's structs to the library's types and back, and the checks that C can not make.
#pragma once

#include <axial/axial.h>
#include <axial/control/border.hpp>
#include <axial/control/feedforward.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>

namespace axial::c_interface {

/// Numbers by the names that AXIAL_C_DECLARE takes.
using as_float = float;
using as_double = double;
using as_fixed32 = Fixed32;

/// What C holds a number T in.
template <class T>
constexpr auto c_number() {
  if constexpr (is_stored_v<T>)
    return typename T::Word{};
  else
    return T{};
}
template <class T>
using CNumber = decltype(c_number<T>());

template <class T>
constexpr CNumber<T> to_c(const T& x) {
  if constexpr (is_stored_v<T>)
    return x.raw;
  else
    return x;
}
template <class Values, class CValues>
constexpr Values from_c(const CValues& values) {
  Values result{};
  for (int i = 0; i < Values::size; ++i)
    result[i] = {values.of[i]};
  return result;
}
template <class Values, class CValues>
constexpr void write_c(const Values& values, CValues& result) {
  for (int i = 0; i < Values::size; ++i)
    result.of[i] = to_c(values[i]);
}

constexpr axial_status to_c(const Status& status) { return {static_cast<int>(status.code), status.joint}; }
template <class... Pointers>
constexpr bool any_null(const Pointers*... pointers) {
  return (false || ... || (pointers == nullptr));
}
inline constexpr axial_status ok{AXIAL_OK, -1}, null_argument{AXIAL_NULL_ARGUMENT, -1};

/// First joint with a value that is not finite.
template <class... Values>
constexpr Status check_finite(int size, const Values&... values) {
  for (int i = 0; i < size; ++i)
    if (!(true && ... && is_finite(values[i]))) return {Status::Code::not_finite, i};
  return {};
}

/// The functions of one scene over numbers T. Pointers are not null.
template <class S, class T>
struct Calls {
  using Robot = robot_of<S>;
  using Q = Positions<Robot, T>;
  using V = Velocities<Robot, T>;
  using A = Accelerations<Robot, T>;
  using Tau = EffortsOf<S, T>;
  static constexpr int size = joint_count<S>;

  // Floating point may be asked beyond the limits; formats of fixed point end there.
  static constexpr Status check(const Q& q, const V& qd = {}, const A& qdd = {}) {
    if constexpr (is_stored_v<T>)
      return check_request<S>(q, qd, qdd);
    else
      return check_finite(size, q, qd, qdd);
  }

  template <class CState, class C>
  static axial_status feedforward(CState& state, const C& q, const C& qd, const C& qdd, C& tau) {
    FeedforwardState<S, T> memory{from_c<Tau>(state.last_safe)};
    const auto result = axial::feedforward<S>(memory, from_c<Q>(q), from_c<V>(qd), from_c<A>(qdd));
    write_c(memory.last_safe, state.last_safe);
    write_c(result.tau, tau);
    return to_c(result.status);
  }

  template <class C>
  static axial_status inverse_dynamics(const C& c_q, const C& c_qd, const C& c_qdd, C& tau) {
    const auto q = from_c<Q>(c_q);
    const auto qd = from_c<V>(c_qd);
    const auto qdd = from_c<A>(c_qdd);
    const Status status = check(q, qd, qdd);
    if (status.ok()) write_c(axial::inverse_dynamics<S>(q, qd, qdd), tau);
    return to_c(status);
  }

  template <class C>
  static axial_status gravity(const C& c_q, C& tau) {
    const auto q = from_c<Q>(c_q);
    const Status status = check(q);
    if (status.ok()) write_c(gravity_torque<S>(q), tau);
    return to_c(status);
  }

  template <class C>
  static axial_status forward_dynamics(const C& c_q, const C& c_qd, const C& c_tau, C& qdd) {
    const auto q = from_c<Q>(c_q);
    const auto qd = from_c<V>(c_qd);
    const auto tau = from_c<Tau>(c_tau);
    Status status = check(q, qd);
    if (status.ok()) status = check_finite(size, tau);
    if (!status.ok()) return to_c(status);
    const auto result = axial::forward_dynamics<S>(q, qd, tau);
    write_c(result, qdd);
    return to_c(result.status);
  }

  template <class C, class CMatrix>
  static axial_status mass_matrix(const C& c_q, CMatrix& matrix) {
    const auto q = from_c<Q>(c_q);
    const Status status = check(q);
    if (!status.ok()) return to_c(status);
    const auto m = axial::mass_matrix<S>(q);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        matrix.of[i][j] = to_c(m(i, j));
    return to_c(status);
  }

  template <class C, class CPose>
  static axial_status tool_pose(const C& c_q, CPose& pose) {
    const auto q = from_c<Q>(c_q);
    const Status status = check(q);
    if (!status.ok()) return to_c(status);
    const auto tool = forward_kinematics<S>(q).tool;
    write_row(tool.rotation.x, pose.rotation[0]);
    write_row(tool.rotation.y, pose.rotation[1]);
    write_row(tool.rotation.z, pose.rotation[2]);
    write_row(tool.position, pose.position);
    return to_c(status);
  }

 private:
  static constexpr void write_row(const Vec3<T>& v, CNumber<T> (&row)[3]) {
    row[0] = to_c(v.x);
    row[1] = to_c(v.y);
    row[2] = to_c(v.z);
  }
};

}  // namespace axial::c_interface
