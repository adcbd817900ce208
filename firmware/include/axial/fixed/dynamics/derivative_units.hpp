// What of the derivatives of forward dynamics in words no state changes: scales, and how far words of inverse dynamics
// can be off.
#pragma once

#include <axial/fixed/dynamics/acceleration_matrices.hpp>
#include <axial/fixed/dynamics/certified_forward_dynamics.hpp>
#include <axial/fixed/dynamics/derivative_error.hpp>
#include <axial/fixed/dynamics/mass_inverse.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// What no state changes, in words: accelerations in those of requests, efforts in those of motions.
template <class S, class T>
struct DerivativeUnits {
  using C = Certificate<S, T>;
  static constexpr int size = C::size;
  static constexpr double largest = 1073741823.0;

  MassUnits<size> mass{};
  int effort_up[size] = {};       ///< of words of efforts to those of motions
  std::int32_t effort_error = 0;  ///< of all efforts of inverse dynamics
  /// Of each column of right-hand sides: what the Jacobian can be off, of all of its rows.
  std::int32_t by_position_error[size] = {}, by_velocity_error[size] = {};

  static constexpr DerivativeUnits made() {
    constexpr auto errors = error_bound<S, T>(algorithm::inverse_dynamics_derivatives);
    DerivativeUnits u;
    for (int i = 0; i < size; ++i) {
      const int own = C::Needs::exponent(i);
      for (int k = 0; k < size; ++k) {
        const int relative = MassMatrixOf<S, T>::exponent(i, k) + C::Requests::exponent(k) - own;
        u.mass.scale[i] = k == 0 || relative - 2 < u.mass.scale[i] ? relative - 2 : u.mass.scale[i];
      }
      for (int k = 0; k < size; ++k) {
        const int unit = u.mass.scale[i] + own - C::Requests::exponent(k);
        u.mass.down[i][k] = smaller(MassMatrixOf<S, T>::exponent(i, k) - unit, 31);
        u.mass.error[i][k] = above(errors.M(i, k), unit);
      }
      u.effort_up[i] = own - EffortsOf<S, T>::exponent(i);
      u.effort_error = larger(u.effort_error, above(errors.tau[i], own));
      for (int j = 0; j < size; ++j) {
        u.by_position_error[j] =
            larger(u.by_position_error[j], above(errors.dtau_dq(i, j), own + sides(by::Position{}).scale[j]));
        u.by_velocity_error[j] =
            larger(u.by_velocity_error[j], above(errors.dtau_dqd(i, j), own + sides(by::Velocity{}).scale[j]));
      }
    }
    return u;
  }
  template <class By>
  static constexpr const auto& sides(By) {
    return right_hand_sides<S, typename T::Word, By>;
  }
  constexpr std::int32_t error(by::Position, int j) const { return by_position_error[j]; }
  constexpr std::int32_t error(by::Velocity, int j) const { return by_velocity_error[j]; }

 private:
  static constexpr std::int32_t larger(std::int32_t a, std::int32_t b) { return a < b ? b : a; }
  /// An error at an exponent, and that of what is rounded down to it.
  static constexpr std::int32_t above(double error, int exponent) {
    const double words = error * power_of_two(exponent) + 2.0;
    return static_cast<std::int32_t>(words < largest ? words : largest);
  }
};
template <class S, class T>
inline constexpr auto derivative_units = DerivativeUnits<S, T>::made();

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
