// Whether what went into a kernel and what came out of it are numbers, and angles small enough for their sines.
#pragma once

#include <axial/links/link_constants.hpp>
#include <axial/scalar/select.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Largest sum of |angle| (rad) for which the sines of all the angles are as exact as sincos.hpp says: powers of two,
/// which instructions hold.
template <class T>
inline constexpr T largest_angles = T(8192.0);
/// Largest angles in double, whose reduction has more bits.
template <>
inline constexpr double largest_angles<double> = 524288.0;

namespace detail {
template <class T>
AXIAL_INLINE constexpr std::uint32_t upper_word(const T& x) {
  using Bits = typename detail::BitsOf<T>::type;
  return static_cast<std::uint32_t>(__builtin_bit_cast(Bits, x) >> (8 * sizeof(T) - 32));
}
// All ones where the sign bit is set.
AXIAL_INLINE constexpr std::uint32_t spread_sign(std::uint32_t x) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(x) >> 31);
}

// 0 where x is finite, else infinity.
template <class T>
AXIAL_INLINE constexpr T infinite_where_not_finite(const T& x) {
  using Bits = typename detail::BitsOf<T>::type;
  constexpr std::uint32_t infinite = upper_word(std::numeric_limits<T>::infinity()),
                          lowest = infinite & (0U - infinite);
  const std::uint32_t all = spread_sign((upper_word(x) & infinite) + lowest) & infinite;
  return __builtin_bit_cast(T, static_cast<Bits>(static_cast<Bits>(all) << (8 * sizeof(T) - 32)));
}

}  // namespace detail

/// |x|, by its sign bit.
///@{
AXIAL_INLINE constexpr float absolute_of(const float& x) { return __builtin_fabsf(x); }
AXIAL_INLINE constexpr double absolute_of(const double& x) { return __builtin_fabs(x); }
///@}

/// ok, angle_range or not_finite, from the sum of |angles| and of what is 0 or NaN. It has no sign bit, so the
/// differences' sign bits tell: compilers may turn a comparison into a branch.
template <class T, std::enable_if_t<std::is_floating_point_v<T>, int> = 0>
AXIAL_INLINE constexpr Status soundness_of(const T& all) {
  using detail::spread_sign, detail::upper_word;
  const std::uint32_t sum = upper_word(all);  // numbers without a sign, infinity and NaN stand in the order of these
  constexpr std::uint32_t most = upper_word(largest_angles<T>);
  constexpr std::uint32_t infinite = upper_word(std::numeric_limits<T>::infinity());
  constexpr std::uint32_t large = static_cast<std::uint32_t>(Status::Code::angle_range);
  constexpr std::uint32_t broken = static_cast<std::uint32_t>(Status::Code::not_finite);
  const std::uint32_t code =
      spread_sign(most - sum) & (large ^ (spread_sign(sum + (0x80000000u - infinite)) & (large ^ broken)));
  return {static_cast<Status::Code>(code), -1};
}

/// Collects what went into a kernel and what came out of it. NaN and infinity survive sums, so that two sums and two
/// comparisons of bits judge all the numbers, without a branch: an addition a number, two operations an angle.
/// A sum that overflows counts as not finite although its terms are finite: they are at the end of T's range.
/// Numbers other than float and double (the counting scalar) have nothing to say and cost nothing; fixed point is held
/// against declared limits instead (fixed/limits/state_check.hpp).
template <class T, class = void>
class Soundness {
 public:
  /// Looks at nothing.
  template <class X>
  AXIAL_INLINE constexpr void angle(const X&) {}
  /// Looks at nothing.
  template <class X>
  AXIAL_INLINE constexpr void number(const X&) {}
  /// Looks at nothing.
  template <class Kind, class X>
  AXIAL_INLINE constexpr void position(Kind, const X&) {}
  AXIAL_INLINE constexpr StatusOf<T> status() const { return {}; }      ///< always ok
  AXIAL_INLINE constexpr StatusOf<T> of_numbers() const { return {}; }  ///< always ok
};

/// float and double, and batches of them.
template <class T>
class Soundness<T, std::enable_if_t<std::is_floating_point_v<Lane<T>> && sizeof(Lane<T>) <= 8>> {
 public:
  /// An angle, rad, of which a sine is taken.
  AXIAL_INLINE constexpr void angle(const T& q) { angles_ = angles_ + absolute_of(q); }
  /// Any other number.
  AXIAL_INLINE constexpr void number(const T& x) { others_ = others_ + x; }
  AXIAL_INLINE constexpr void number(Zero) {}                                 ///< zero by type is a number
  AXIAL_INLINE constexpr void position(Revolute, const T& q) { angle(q); }    ///< of a revolute joint, rad
  AXIAL_INLINE constexpr void position(Prismatic, const T& q) { number(q); }  ///< of a prismatic joint, m
  /// Whether a run-time input is beyond its range.
  AXIAL_INLINE constexpr void range(const Truth<T>& beyond) { beyond_ = beyond_ | beyond; }
  /// What was looked at of a payload.
  AXIAL_INLINE constexpr void load(const Soundness& body) {
    others_ = others_ + body.others_, load_ = load_ | body.beyond_;
  }
  /// Whether an input is beyond its range, or NaN.
  [[nodiscard]] AXIAL_INLINE constexpr Truth<T> is_beyond() const { return beyond_; }
  /// Whether a payload is, likewise.
  [[nodiscard]] AXIAL_INLINE constexpr Truth<T> is_load_beyond() const { return load_; }

  /// ok; not_finite where one of the numbers is NaN or infinite; angle_range where the angles are too large or a pair
  /// is none; payload_limit, input_limit where an input is beyond its range. Names no joint.
  [[nodiscard]] AXIAL_INLINE constexpr StatusOf<T> status() const {
    StatusOf<T> ranges{};
    put_where(ranges, beyond_, Status::Code::input_limit);
    put_where(ranges, load_, Status::Code::payload_limit);
    return first_trouble(of_numbers(), ranges);
  }
  /// The same where there are no run-time inputs.
  [[nodiscard]] AXIAL_INLINE constexpr StatusOf<T> of_numbers() const {
    return soundness_of(angles_ + absolute_of(of_others()));
  }

 private:
  // -0 is what an addition leaves as it is; +0 would turn -0 into +0, so that compilers keep the addition.
  T angles_ = T(Lane<T>(-0.0)), others_ = T(Lane<T>(-0.0));
  Truth<T> beyond_ = false, load_ = false;
  /// 0, or none where the sum is NaN or infinite. By bits for Clang, which takes x - x for 0 where it may regroup sums,
  /// and (x 2^k) 0 for x 0.
  [[nodiscard]] AXIAL_INLINE constexpr T of_others() const {
#ifdef __clang__
    if constexpr (std::is_floating_point_v<T>)
      return detail::infinite_where_not_finite(others_);
    else
      return others_ * T(0);
#else
    return others_ - others_;
#endif
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
