// Kernels on arrays of numbers: float[6], std::array<float, 6>, a std::span of known length, or a pointer with its
// length.
#pragma once

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/dynamics/separation.hpp>

#include <axial/options/begin.hpp>

/// What each kernel on arrays says where they do not fit (a macro: static_assert takes a literal only).
#define AXIAL_ARRAYS_FIT                                                                                     \
  "axial: joint values are axial::Joints, or arrays with one number for each joint, all of float or all of " \
  "double, as many as the kernel names; the length of a pointer is given by axial::pointed<N>(pointer)"

namespace axial {

/// A pointer to N numbers, for kernels that take joint values: `inverse_dynamics<Arm>(pointed<6>(q), ...)`. The length
/// is the caller's word.
template <int N, class T>
struct Pointed {
  static constexpr std::size_t extent = N;                           ///< as std::span has it
  const T* numbers;                                                  ///< N of them
  [[nodiscard]] constexpr const T* data() const { return numbers; }  ///< as std::span has it
};
/// Says how many numbers a pointer points to: pointed<6>(q).
template <int N, class T>
[[nodiscard]] constexpr Pointed<N, T> pointed(const T* numbers) {
  return {numbers};
}

namespace detail {

/// Length of what holds numbers, as far as its type tells: an array, what has data() and a constant size (std::array,
/// std::span<T, N>, Pointed); 0 for a pointer, a std::vector and others whose length a run tells; -1 for no array.
///@{
template <class A, class = void>
inline constexpr int plain_length = std::is_pointer_v<A> ? 0 : -1;
template <class T, std::size_t N>
inline constexpr int plain_length<T[N], void> = static_cast<int>(N);
template <class A, class = void>
inline constexpr int length_by_extent = 0;
template <class A>
inline constexpr int length_by_extent<A, std::enable_if_t<(A::extent < 1000000)>> = static_cast<int>(A::extent);
template <class A, class = void>
inline constexpr int length_by_size = length_by_extent<A>;
template <class A>
inline constexpr int length_by_size<A, std::enable_if_t<(std::tuple_size<A>::value > 0)>> =
    static_cast<int>(std::tuple_size<A>::value);
template <class A>
inline constexpr int plain_length<A, std::void_t<decltype(std::declval<const A&>().data())>> = length_by_size<A>;
///@}

template <class A>
inline constexpr bool is_plain_array = plain_length<A> >= 0;

/// Where one of the arguments is an array, or a lone number: of that kernels say the same sentence.
template <class... A>
using IfAnyIsPlain = std::enable_if_t<(false || ... || (is_plain_array<A> || std::is_arithmetic_v<A>))>;

/// The first number of an array.
template <class A>
constexpr const auto* first_of(const A& given) {
  if constexpr (std::is_array_v<A>)
    return &given[0];
  else if constexpr (std::is_pointer_v<A>)
    return given;
  else
    return given.data();
}

/// Numbers of an argument: of an array or of joint values; void of other inputs.
///@{
template <class A, class = void>
struct NumberOf {
  using type = void;
};
template <class A>
struct NumberOf<A, std::enable_if_t<is_plain_array<A>>> {
  using type = std::decay_t<decltype(*first_of(std::declval<const A&>()))>;
};
template <class S, class T, class Role>
struct NumberOf<Joints<S, T, Role>, void> {
  using type = T;
};
template <class A>
using number_of = typename NumberOf<A>::type;
///@}

template <class A, class T>
inline constexpr bool fits_number = std::is_void_v<number_of<A>> || std::is_same_v<number_of<A>, T>;
template <class A, int N>
inline constexpr bool fits_length = plain_length<A> == -1 || plain_length<A> == N;

/// How many of the arguments are joint values.
template <class... A>
inline constexpr int joint_values_among = (0 + ... + static_cast<int>(!std::is_void_v<number_of<A>>));

/// Whether there are `count` joint values, and at most one other input with them, and every array has a number for each
/// joint of S, all of float or all of double; where not, each kernel asserts it itself: from a function of its own the
/// sentence would stand behind a line more of the compiler's.
template <class S, int count, class... A>
inline constexpr bool takes_arrays = joint_values_among<A...> == count && sizeof...(A) <= count + 1 &&
                                     (true && ... &&
                                      fits_length<A, joint_count<S>>)&&((true && ... && fits_number<A, float>) ||
                                                                        (true && ... && fits_number<A, double>));

/// Joint values of an array; other inputs as they are.
template <class S, class A>
AXIAL_INLINE constexpr auto as_joint_values(const A& given) {
  if constexpr (is_plain_array<A>) {
    Joints<robot_of<S>, number_of<A>> values{};
    const auto* numbers = first_of(given);
    for (int i = 0; i < joint_count<S>; ++i)
      values[i] = numbers[i];
    return values;
  } else {
    return given;
  }
}

/// What `run` makes of joint values, of which some are arrays; nothing where they do not `fit`, so that the kernel's
/// one sentence about that is all that a compiler prints.
template <class S, bool fit, class Empty, class Run, class... A>
AXIAL_INLINE constexpr auto with_joint_values(const Run& run, const A&... given) {
  if constexpr (fit)
    return run(as_joint_values<S>(given)...);
  else
    return Empty{};
}

}  // namespace detail

/// The kernels of the same names on arrays that have a number for each joint, instead of joint values or mixed with
/// them.
///@{
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto inverse_dynamics(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Efforts<robot_of<S>, float>>(
      [](const auto&... in) AXIAL_INLINE { return inverse_dynamics<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto gravity_torque(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Efforts<robot_of<S>, float>>(
      [](const auto&... in) AXIAL_INLINE { return gravity_torque<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto bias_torque(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 2, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Efforts<robot_of<S>, float>>(
      [](const auto&... in) AXIAL_INLINE { return bias_torque<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto forward_dynamics(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, ForwardDynamicsOf<S, float>>(
      [](const auto&... in) AXIAL_INLINE { return forward_dynamics<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto mass_matrix(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, MassMatrix<robot_of<S>, float>>(
      [](const auto&... in) AXIAL_INLINE { return mass_matrix<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto forward_kinematics(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, ForwardKinematics<robot_of<S>, float>>(
      [](const auto&... in) AXIAL_INLINE { return forward_kinematics<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto jacobian(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Jacobian<robot_of<S>, float>>(
      [](const auto&... in) AXIAL_INLINE { return jacobian<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto separate(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Separated<S, float>>(
      [](const auto&... in) AXIAL_INLINE { return separate<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto momentum_terms(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 2, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, MomentumTerms<S, float>>(
      [](const auto&... in) AXIAL_INLINE { return momentum_terms<S>(in...); }, given...);
}
template <class S, int Joint, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto joint_torque(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, float>(
      [](const auto&... in) AXIAL_INLINE { return joint_torque<S, Joint>(in...); }, given...);
}
template <class S, int Joint, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto gravity_torque(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, float>(
      [](const auto&... in) AXIAL_INLINE { return gravity_torque<S, Joint>(in...); }, given...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
