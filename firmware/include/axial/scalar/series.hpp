// Dual numbers: a value with its derivative along one direction. Truncated Taylor numbers: a quantity with its first
// and second derivative by time. A kernel of values, run over them, differentiates itself, or twice; what does not
// depend on the direction, or does not change, stays a plain number, by type.
#pragma once

#include <axial/scalar/rounding.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A value and its derivative by one parameter; either may be a structural scalar.
template <class V, class D>
struct Dual {
  V value{};  ///< in its own unit
  D slope{};  ///< its derivative: that unit, per unit of the parameter
};
template <class V, class D>
Dual(V, D) -> Dual<V, D>;

/// A dual number as a number of kernels; constants have no slope.
template <class V, class D>
struct NumberTraits<Dual<V, D>> {
  static constexpr bool is_number = true;  ///< it is a number
  /// the nearest V
  AXIAL_INLINE static constexpr Dual<V, D> constant(double value) { return {NumberTraits<V>::constant(value), {}}; }
};

namespace detail {
template <class X>
inline constexpr bool is_dual_v = false;
template <class V, class D>
inline constexpr bool is_dual_v<Dual<V, D>> = true;
// Two conditions in this order: of what has no dual or Taylor number nothing else is asked, for traits of other numbers
// may stand behind their operators.
template <class A, class B>
using IfOneIsDual = std::enable_if_t<is_dual_v<A> || is_dual_v<B>, int>;
template <class A, class B>
using IfBothAreNumbers = std::enable_if_t<is_number_v<A> && is_number_v<B>, int>;
}  // namespace detail

/// The value of any scalar.
template <class X>
AXIAL_INLINE constexpr const X& value_of(const X& x) {
  return x;
}
/// The value of a dual number.
template <class V, class D>
AXIAL_INLINE constexpr const V& value_of(const Dual<V, D>& x) {
  return x.value;
}
/// The derivative of any scalar: zero by type where there is none.
template <class X>
AXIAL_INLINE constexpr Zero slope_of(const X&) {
  return {};
}
/// The derivative of a dual number.
template <class V, class D>
AXIAL_INLINE constexpr const D& slope_of(const Dual<V, D>& x) {
  return x.slope;
}

/// A value with its slope; the value alone where the slope is zero by type.
template <class V, class D>
AXIAL_INLINE constexpr auto with_slope(const V& value, const D& slope) {
  if constexpr (is_zero_v<D>)
    return value;
  else
    return Dual{value, slope};
}
/// x with `more` added to its slope.
template <class X, class D>
AXIAL_INLINE constexpr auto add_slope(const X& x, const D& more) {
  return with_slope(value_of(x), slope_of(x) + more);
}

/// Sum of dual numbers, or of one and a plain number.
template <class A, class B, class = detail::IfOneIsDual<A, B>, class = detail::IfBothAreNumbers<A, B>>
AXIAL_INLINE constexpr auto operator+(const A& a, const B& b) {
  return with_slope(value_of(a) + value_of(b), slope_of(a) + slope_of(b));
}
/// Difference of dual numbers, or of one and a plain number.
template <class A, class B, class = detail::IfOneIsDual<A, B>, class = detail::IfBothAreNumbers<A, B>>
AXIAL_INLINE constexpr auto operator-(const A& a, const B& b) {
  return with_slope(value_of(a) - value_of(b), slope_of(a) - slope_of(b));
}
/// Product of dual numbers, or of one and a plain number: Leibniz's rule.
template <class A, class B, class = detail::IfOneIsDual<A, B>, class = detail::IfBothAreNumbers<A, B>>
AXIAL_INLINE constexpr auto operator*(const A& a, const B& b) {
  return with_slope(value_of(a) * value_of(b), slope_of(a) * value_of(b) + value_of(a) * slope_of(b));
}
/// A dual number with the other sign.
template <class V, class D>
AXIAL_INLINE constexpr auto operator-(const Dual<V, D>& x) {
  return with_slope(-x.value, -x.slope);
}

/// Plain numbers and structural scalars become dual numbers where a loop keeps one type for all links.
template <class V, class D>
struct Holding<Dual<V, D>> {
  /// X with its slope, if it has one.
  template <class X>
  AXIAL_INLINE static constexpr Dual<V, D> of(const X& x) {
    return {Holding<V>::of(value_of(x)), Holding<D>::of(slope_of(x))};
  }
};

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

/// A value with its coefficients; the value alone where both are zero by type.
template <class V, class L, class Q>
AXIAL_INLINE constexpr auto with_rates(const V& value, const L& linear, const Q& quadratic) {
  if constexpr (is_zero_v<L> && is_zero_v<Q>)
    return value;
  else
    return Taylor{value, linear, quadratic};
}

namespace detail {
template <class X>
inline constexpr bool is_taylor_v = false;
template <class V, class L, class Q>
inline constexpr bool is_taylor_v<Taylor<V, L, Q>> = true;
template <class A, class B>
using IfOneIsTaylor = std::enable_if_t<is_taylor_v<A> || is_taylor_v<B>, int>;

}  // namespace detail

/// Sum of Taylor numbers, or of one and a plain number.
template <class A, class B, detail::IfOneIsTaylor<A, B> = 0, detail::IfBothAreNumbers<A, B> = 0>
AXIAL_INLINE constexpr auto operator+(const A& a, const B& b) {
  return with_rates(value_at_0(a) + value_at_0(b), linear_of(a) + linear_of(b), quadratic_of(a) + quadratic_of(b));
}
/// Difference of Taylor numbers, or of one and a plain number.
template <class A, class B, detail::IfOneIsTaylor<A, B> = 0, detail::IfBothAreNumbers<A, B> = 0>
AXIAL_INLINE constexpr auto operator-(const A& a, const B& b) {
  return with_rates(value_at_0(a) - value_at_0(b), linear_of(a) - linear_of(b), quadratic_of(a) - quadratic_of(b));
}
/// Product of Taylor numbers, or of one and a plain number: Leibniz's rule.
template <class A, class B, detail::IfOneIsTaylor<A, B> = 0, detail::IfBothAreNumbers<A, B> = 0>
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
