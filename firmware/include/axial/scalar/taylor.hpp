// Truncated Taylor numbers: a quantity with its first and, unless that is cut off, its second derivative by one
// parameter. A kernel of values, run over them, differentiates itself; what does not change stays a plain number, by
// type.
#pragma once

#include <axial/scalar/rounding.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
/// A base whose copies are no bytes: what derives from it is copied member by member.
struct CopiedByMembers {
  constexpr CopiedByMembers() = default;
  AXIAL_INLINE constexpr CopiedByMembers(const CopiedByMembers&) {}
  AXIAL_INLINE constexpr CopiedByMembers& operator=(const CopiedByMembers&) { return *this; }
};
/// A base that changes nothing.
struct CopiedAsBytes {};
// Motions of Taylor numbers are larger than what GCC takes apart where it is copied as bytes: those of a SCARA, mostly
// zeros, stayed in memory, at twice the instructions. Member by member they are in the registers that an FPU has;
// where it has none for V, bytes are fewer instructions.
#if defined(__ARM_FP) && (__ARM_FP & 4)
template <class V>
using TaylorCopy = std::conditional_t<std::is_same_v<V, float>, CopiedByMembers, CopiedAsBytes>;
#else
template <class V>
using TaylorCopy = CopiedAsBytes;
#endif
}  // namespace detail

/// Stands for a coefficient that is cut off: so is all that it enters.
struct CutOff {
  constexpr CutOff() = default;
  /// of what it would be
  template <class X>
  AXIAL_INLINE constexpr CutOff(const X&) {}  // NOLINT(google-explicit-constructor): as any number
};

/// value + linear t + quadratic t^2, cut off behind: the second derivative is twice `quadratic`, which saves products a
/// factor 2. Each may be a structural scalar.
template <class V, class L, class Q>
struct Taylor : detail::TaylorCopy<V> {
  V value{};      ///< in its own unit
  L linear{};     ///< first derivative: that unit per second
  Q quadratic{};  ///< half of the second derivative: that unit per second squared

  constexpr Taylor() = default;
  /// of its coefficients
  AXIAL_INLINE constexpr Taylor(const V& at_0, const L& first, const Q& second)
      : value(at_0), linear(first), quadratic(second) {}
};
template <class V, class L, class Q>
Taylor(V, L, Q) -> Taylor<V, L, Q>;
/// Cut off behind its slope.
template <class V, class L>
struct Taylor<V, L, CutOff> {
  V value{};                            ///< in its own unit
  L linear{};                           ///< its derivative: that unit, per unit of the parameter
  static constexpr CutOff quadratic{};  ///< nothing is known of it

  constexpr Taylor() = default;
  /// of its coefficients
  AXIAL_INLINE constexpr Taylor(const V& at_0, const L& first, CutOff = {}) : value(at_0), linear(first) {}
};
/// Dual numbers: a value with its derivative along one direction.
template <class V, class D>
using Dual = Taylor<V, D, CutOff>;

/// A Taylor number as a number of kernels; constants do not change.
template <class V, class L, class Q>
struct NumberTraits<Taylor<V, L, Q>> {
  static constexpr bool is_number = true;  ///< it is a number
  /// the nearest V
  AXIAL_INLINE static constexpr Taylor<V, L, Q> constant(double value) {
    return {NumberTraits<V>::constant(value), {}, {}};
  }
};

/// The coefficients of any scalar: zero by type where it does not change.
///@{
template <class X>
AXIAL_INLINE constexpr const X& value_at_0(const X& x) {
  return x;
}
template <class V, class L, class Q>
AXIAL_INLINE constexpr const V& value_at_0(const Taylor<V, L, Q>& x) {
  return x.value;
}
template <class X>
AXIAL_INLINE constexpr Zero linear_of(const X&) {
  return {};
}
template <class V, class L, class Q>
AXIAL_INLINE constexpr const L& linear_of(const Taylor<V, L, Q>& x) {
  return x.linear;
}
template <class X>
AXIAL_INLINE constexpr Zero quadratic_of(const X&) {
  return {};
}
template <class V, class L, class Q>
AXIAL_INLINE constexpr const Q& quadratic_of(const Taylor<V, L, Q>& x) {
  return x.quadratic;
}
///@}

/// A value with its coefficients; the value alone where none is there by type.
template <class V, class L, class Q>
AXIAL_INLINE constexpr auto with_rates(const V& value, const L& linear, const Q& quadratic) {
  if constexpr (is_zero_v<L> && (is_zero_v<Q> || std::is_same_v<Q, CutOff>))
    return value;
  else
    return Taylor{value, linear, quadratic};
}

/// The value and the slope of a dual number, or of any scalar; and both as one number.
///@{
template <class X>
AXIAL_INLINE constexpr const auto& value_of(const X& x) {
  return value_at_0(x);
}
template <class X>
AXIAL_INLINE constexpr auto slope_of(const X& x) {
  return linear_of(x);
}
template <class V, class D>
AXIAL_INLINE constexpr auto with_slope(const V& value, const D& slope) {
  return with_rates(value, slope, CutOff{});
}
///@}

namespace detail {
template <class X>
inline constexpr bool is_taylor_v = false;
template <class V, class L, class Q>
inline constexpr bool is_taylor_v<Taylor<V, L, Q>> = true;
// Two conditions in this order: of what has no Taylor number nothing else is asked, for traits of other numbers may
// stand behind their operators.
template <class A, class B>
using IfOneIsTaylor = std::enable_if_t<is_taylor_v<A> || is_taylor_v<B>, int>;
template <class A, class B>
using IfBothMayMeet = std::enable_if_t<is_number_v<A> && is_number_v<B>, int>;
template <class A, class B>
using IfOneIsCutOff = std::enable_if_t<std::is_same_v<A, CutOff> || std::is_same_v<B, CutOff>, int>;
}  // namespace detail

/// What a coefficient that is cut off enters is cut off.
///@{
AXIAL_INLINE constexpr CutOff operator-(CutOff) { return {}; }
template <class A, class B, detail::IfOneIsCutOff<A, B> = 0>
AXIAL_INLINE constexpr CutOff operator+(const A&, const B&) {
  return {};
}
template <class A, class B, detail::IfOneIsCutOff<A, B> = 0>
AXIAL_INLINE constexpr CutOff operator-(const A&, const B&) {
  return {};
}
template <class A, class B, detail::IfOneIsCutOff<A, B> = 0>
AXIAL_INLINE constexpr CutOff operator*(const A&, const B&) {
  return {};
}
///@}

/// Sum of Taylor numbers, or of one and a plain number.
template <class A, class B, detail::IfOneIsTaylor<A, B> = 0, detail::IfBothMayMeet<A, B> = 0>
AXIAL_INLINE constexpr auto operator+(const A& a, const B& b) {
  return with_rates(value_at_0(a) + value_at_0(b), linear_of(a) + linear_of(b), quadratic_of(a) + quadratic_of(b));
}
/// Difference of Taylor numbers, or of one and a plain number.
template <class A, class B, detail::IfOneIsTaylor<A, B> = 0, detail::IfBothMayMeet<A, B> = 0>
AXIAL_INLINE constexpr auto operator-(const A& a, const B& b) {
  return with_rates(value_at_0(a) - value_at_0(b), linear_of(a) - linear_of(b), quadratic_of(a) - quadratic_of(b));
}
/// Product of Taylor numbers, or of one and a plain number: Leibniz's rule.
template <class A, class B, detail::IfOneIsTaylor<A, B> = 0, detail::IfBothMayMeet<A, B> = 0>
AXIAL_INLINE constexpr auto operator*(const A& a, const B& b) {
  return with_rates(value_at_0(a) * value_at_0(b), linear_of(a) * value_at_0(b) + value_at_0(a) * linear_of(b),
                    quadratic_of(a) * value_at_0(b) + linear_of(a) * linear_of(b) + value_at_0(a) * quadratic_of(b));
}
/// A Taylor number with the other sign.
template <class V, class L, class Q>
AXIAL_INLINE constexpr auto operator-(const Taylor<V, L, Q>& x) {
  return with_rates(-x.value, -x.linear, -x.quadratic);
}

/// Plain numbers and structural scalars become Taylor numbers where a loop keeps one type for all links.
template <class V, class L, class Q>
struct Holding<Taylor<V, L, Q>> {
  /// X with its coefficients, if it has any.
  template <class X>
  AXIAL_INLINE static constexpr Taylor<V, L, Q> of(const X& x) {
    return {Holding<V>::of(value_at_0(x)), Holding<L>::of(linear_of(x)), Holding<Q>::of(quadratic_of(x))};
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
