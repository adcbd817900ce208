// Dual numbers: a value with its derivative along one direction. A kernel of values, run over them, differentiates
// itself; what does not depend on the direction stays a plain number, by type.
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
// Two conditions in this order: of what has no dual number nothing else is asked, for traits of other numbers may stand
// behind their operators.
template <class A, class B>
using IfOneIsDual = std::enable_if_t<is_dual_v<A> || is_dual_v<B>>;
template <class A, class B>
using IfBothAreNumbers = std::enable_if_t<is_number_v<A> && is_number_v<B>>;
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

}  // namespace axial

#include <axial/options/end.hpp>
