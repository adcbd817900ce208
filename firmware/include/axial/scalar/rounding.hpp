// The whole vocabulary of rounding: what a number system with narrow words needs to know, and floating point does not.
#pragma once

#include <axial/scalar/structural.hpp>

namespace axial {

/// What a stored result is: a number system with exponents looks its format up by (quantity, link).
namespace quantity {
struct AngularVelocity {};      // rad/s
struct AngularAcceleration {};  // rad/s^2, and products of angular velocities
struct LinearAcceleration {};   // m/s^2
struct Moment {};               // N m
struct Force {};                // N
struct RotationalInertia {};    // kg m^2
struct FirstMoment {};          // kg m
struct Mass {};                 // kg
struct JointInertia {};         // D of a joint: kg m^2 or kg
struct Gain {};                 // K = U / D, dimension of the block over D
struct JointEffort {};          // N m or N
struct JointAcceleration {};    // rad/s^2 or m/s^2
struct Length {};               // m
}  // namespace quantity

/// Rounding of float, double and the counting scalar: none beyond the operations themselves.
/// `sum(quantity, terms...)` is the sum of products and stored values, rounded once into the format of the quantity.
struct Plain {
  template <class Quantity, class... Terms>
  AXIAL_INLINE constexpr auto sum(Quantity, const Terms&... terms) const {
    return (... + terms);
  }
  /// Rounding in the formats of the link that carries this one.
  AXIAL_INLINE static constexpr Plain outer() { return {}; }
};

/// A product with sines or cosines, back in the format of what was turned. A turn keeps the norm of what it turns.
template <class T>
AXIAL_INLINE constexpr T turned(const T& x) {
  return x;
}

/// 1 / x. Number systems without a division overload it.
template <class T, std::enable_if_t<is_number_v<T>, int> = 0>
AXIAL_INLINE constexpr T reciprocal(const T& x) {
  return T(One{}) / x;
}

}  // namespace axial
