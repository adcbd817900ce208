// A query for answers that carry no status of their own: whether they are numbers.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/base_wrench.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/scalar/traits.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

template <class X, class Y, class Z>
constexpr bool is_finite_vector(const Vec3<X, Y, Z>& v) {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}
// What stands at a joint: a value, a sine-cosine pair, a column of a Jacobian.
template <class T>
constexpr bool is_finite_value(const T& x) {
  return is_finite(x);
}
template <class T>
constexpr bool is_finite_value(const SinCos<T>& pair) {
  return is_finite(pair.sin) && is_finite(pair.cos);
}
template <class T>
constexpr bool is_finite_value(const MotionVector<Vec3<T>, Vec3<T>>& column) {
  return is_finite_vector(column.angular) && is_finite_vector(column.linear);
}
constexpr Status finite_or_not(bool finite) { return {finite ? Status::Code::ok : Status::Code::not_finite, -1}; }

// The first of `size` joints for which `finite(i)` is false.
template <class Finite>
constexpr Status first_not_finite(int size, const Finite& finite) {
  for (int i = 0; i < size; ++i)
    if (!finite(i)) return {Status::Code::not_finite, i};
  return {};
}

}  // namespace detail

/// `check_finite(q, qd, qdd)`: ok, or not_finite and the first joint (from the base) of which one of the values is NaN
/// or infinite. For what algorithms answer without a status, for they hand on what is not finite: inverse_dynamics,
/// gravity_torque, bias_torque, joint_torque, mass_matrix, momentum_terms, base_wrench, torque. An answer that
/// overflowed is infinite or NaN. Fixed point is always finite: there check_request() looks at what goes in.
/// Reads bits, so that -ffast-math cannot remove it. Not of constant time: it stops at the first.
template <class S, class T, class Role, class... Values>
[[nodiscard]] constexpr Status check_finite(const Joints<S, T, Role>& first, const Values&... others) {
  static_assert((true && ... && (Values::size == Joints<S, T, Role>::size)),
                "axial: check_finite takes joint values of one robot together");
  return detail::first_not_finite(Joints<S, T, Role>::size, [&](int i) {
    return (detail::is_finite_value(first[i]) && ... && detail::is_finite_value(others[i]));
  });
}
/// The joint is the row of the first entry of the lower triangle that is not finite.
template <class S, class T>
[[nodiscard]] constexpr Status check_finite(const MassMatrix<S, T>& matrix) {
  return detail::first_not_finite(MassMatrix<S, T>::size, [&](int i) {
    bool finite = true;
    for (int j = 0; j <= i; ++j)
      finite = finite && is_finite(matrix(i, j));
    return finite;
  });
}
/// The joint is that of the first column that is not finite.
template <class S, class T>
[[nodiscard]] constexpr Status check_finite(const Jacobian<S, T>& jacobian) {
  return detail::first_not_finite(joint_count<S>, [&](int i) { return detail::is_finite_value(jacobian[i]); });
}
/// Momenta and their drift.
template <class S, class T>
[[nodiscard]] constexpr Status check_finite(const MomentumTerms<S, T>& terms) {
  return check_finite(terms.momentum, terms.drift);
}
/// Names no joint.
template <class T>
[[nodiscard]] constexpr Status check_finite(const Vec3<T>& v) {
  return detail::finite_or_not(detail::is_finite_vector(v));
}
/// Names no joint.
template <class T>
[[nodiscard]] constexpr Status check_finite(const Wrench<T>& wrench) {
  return detail::finite_or_not(detail::is_finite_vector(wrench.moment) && detail::is_finite_vector(wrench.force));
}
/// Names no joint.
template <class T>
[[nodiscard]] constexpr Status check_finite(const WorldPose<T>& pose) {
  const auto& r = pose.rotation;
  return detail::finite_or_not(detail::is_finite_vector(r.x) && detail::is_finite_vector(r.y) &&
                               detail::is_finite_vector(r.z) && detail::is_finite_vector(pose.position));
}
/// One number, such as joint_torque(); names no joint.
template <class T, std::enable_if_t<std::is_floating_point_v<T>, int> = 0>
[[nodiscard]] constexpr Status check_finite(const T& x) {
  return detail::finite_or_not(is_finite(x));
}

}  // namespace axial

#include <axial/options/end.hpp>
