// What the compiler says to who gives a kernel arrays of numbers instead of joint values.
#pragma once

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// An array, a pointer, or what has data(): std::array, std::vector, std::span, Eigen's vectors.
///@{
template <class A, class = void>
inline constexpr bool is_plain_array = std::is_array_v<A> || std::is_pointer_v<A>;
template <class A>
inline constexpr bool is_plain_array<A, std::void_t<decltype(std::declval<const A&>().data())>> = true;
///@}

template <class... A>
using IfAnyIsPlainArray = std::enable_if_t<(false || ... || is_plain_array<A>)>;

template <class...>
inline constexpr bool takes_arrays = false;

}  // namespace detail

/// Refused: joint values are axial::Joints, whose number of joints the compiler checks.
///@{
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> inverse_dynamics(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> gravity_torque(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> bias_torque(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr Accelerations<robot_of<S>, float> forward_dynamics(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr MassMatrix<robot_of<S>, float> mass_matrix(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr ForwardKinematics<robot_of<S>, float> forward_kinematics(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr Jacobian<robot_of<S>, float> jacobian(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr Separated<S, float> separate(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
template <class S, int Joint, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr float joint_torque(const A&...) {
  static_assert(detail::takes_arrays<A...>,
                "axial: joint values are axial::Joints<Robot, float>, not an array; copy its numbers: q[i] = array[i]");
  return {};
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
