// The whole vocabulary of rounding: what a number system with narrow words needs to know, and floating point does not.
#pragma once

#include <axial/scalar/structural.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What a stored result is: a number system with exponents looks its format up by (quantity, link).
namespace quantity {
struct AngularVelocity {};      ///< rad/s
struct AngularAcceleration {};  ///< rad/s^2, and products of angular velocities
struct LinearAcceleration {};   ///< m/s^2
struct Moment {};               ///< N m
struct Force {};                ///< N
struct RotationalInertia {};    ///< kg m^2
struct FirstMoment {};          ///< kg m
struct Mass {};                 ///< kg
struct JointInertia {};         ///< D of a joint: kg m^2 or kg
struct AngularGain {};          ///< K = U / D, angular block over D
struct LinearGain {};           ///< K = U / D, linear block over D
struct JointEffort {};          ///< N m or N
struct JointAcceleration {};    ///< rad/s^2 or m/s^2
struct Length {};               ///< m
struct GravityAcceleration {};  ///< m/s^2
struct Turn {};                 ///< sine or cosine
}  // namespace quantity

/// What a result of a quantity is kept as, where kernels keep plain numbers: T, unless T gives each quantity its own.
template <class T, class Quantity>
struct KeptAs {
  using type = T;  ///< what is kept
};
/// What a result of a quantity is kept as, given the number T.
template <class T, class Quantity>
using Kept = typename KeptAs<T, Quantity>::type;

/// Rounding of float, double and the counting scalar: none beyond the operations themselves.
/// `sum(quantity, terms...)` is the sum of products and stored values, rounded once into the format of the quantity.
struct Plain {
  static constexpr bool ranged = false;   ///< whether ranges of its results are proved
  static constexpr bool is_heard = true;  ///< whether anybody reads what the link sends to its parent
  /// The sum, by the number's own additions.
  template <class Quantity, class... Terms>
  AXIAL_INLINE constexpr auto sum(Quantity, const Terms&... terms) const {
    return (... + terms);
  }
  /// x / d from 1/d, a number or a vector.
  template <class Quantity, class Inverse, class X>
  AXIAL_INLINE constexpr auto quotient(Quantity, const Inverse& inverse, const X& x) const {
    return inverse * x;
  }
  /// A sum that is held within its format where there is one; sets `lost` where that changes it.
  template <class Quantity, class Lost, class... Terms>
  AXIAL_INLINE constexpr auto limited(Quantity, Lost&, const Terms&... terms) const {
    return (... + terms);
  }
  /// Drive u of a joint whose inertia is d, if it is within what formats are made for.
  template <class Lost, class D, class U, class M>
  AXIAL_INLINE constexpr const U& gated_drive(Lost&, const D&, const U& u, M) const {
    return u;
  }
  /// A body's inertia in the formats of the link.
  template <class Inertia>
  AXIAL_INLINE constexpr const Inertia& formatted(const Inertia& inertia) const {
    return inertia;
  }
  /// Two bodies as one.
  template <class A, class B>
  AXIAL_INLINE constexpr auto add(const A& a, const B& b) const {
    return a + b;
  }
  /// A force less another.
  template <class A, class B>
  AXIAL_INLINE constexpr auto subtract(const A& force, const B& other) const {
    return force - other;
  }
  /// Rounding in the formats of the link that carries this one.
  AXIAL_INLINE static constexpr Plain outer() { return {}; }
};

/// A product with sines or cosines, back in the format of what was turned. A turn keeps the norm of what it turns.
template <class T>
AXIAL_INLINE constexpr T turned(const T& x) {
  return x;
}

/// 2 x.
template <class T>
AXIAL_INLINE constexpr auto twice(const T& x) {
  return x + x;
}

/// x / 2.
template <class T>
AXIAL_INLINE constexpr auto half(const T& x) {
  if constexpr (is_zero_v<T>)
    return Zero{};
  else
    return NumberTraits<T>::constant(0.5) * x;
}

/// 1 / x. Number systems without a division overload it.
template <class T, std::enable_if_t<is_number_v<T>, int> = 0>
AXIAL_INLINE constexpr T reciprocal(const T& x) {
  return T(One{}) / x;
}

}  // namespace axial

#include <axial/options/end.hpp>
