// What of the derivatives of forward dynamics in words no state changes: an exponent per entry, by what M^-1 can be;
// scales; how far words of inverse dynamics can be off.
#pragma once

#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/fixed/derivatives/derivative_error.hpp>
#include <axial/fixed/dynamics/certified_forward_dynamics.hpp>
#include <axial/fixed/dynamics/mass_inverse.hpp>
#include <axial/fixed/formats/drive_formats.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace by {
struct Effort {};  ///< tau
}  // namespace by

namespace detail {

/// Equations in the words of motions.
template <class S, class Word>
struct MotionEquations {
  static constexpr int exponent(int i) { return exponents_of<S, Word, role::MotionEffort>.of[i]; }
};

/// How words of Jacobians of inverse dynamics become right-hand sides whose unknowns are accelerations in the words of
/// requests, 2^scale of them: all efforts in the words of equations, 2^scale of them, below 2^29.
template <class S, class Word, class By, class Equations = MotionEquations<S, Word>>
struct RightHandSides {
  static constexpr int size = joint_count<S>, finest = 31;
  int scale[size] = {};       ///< of each column
  int down[size][size] = {};  ///< shift of entry (i, j) to the right
  bool filled[size] = {};     ///< whether column j is other than zero

  static constexpr RightHandSides chosen() {
    constexpr const auto& sizes = entries_of<S, Word>(By{});
    RightHandSides all;
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        if (!(sizes(i, j).size > 0.0)) continue;
        const int own = relative(i, j) - 2;
        all.scale[j] = all.filled[j] && all.scale[j] < own ? all.scale[j] : own;
        all.filled[j] = true;
      }
      for (int i = 0; i < size; ++i)
        all.down[i][j] = sizes(i, j).size > 0.0 ? smaller(relative(i, j) - all.scale[j], finest) : finest;
    }
    return all;
  }

 private:
  static constexpr int relative(int i, int j) {
    return joint_matrix_format<S, Word, By>.of[i][j] - Equations::exponent(i);
  }
};
template <class S, class Word, class By, class Equations = MotionEquations<S, Word>>
inline constexpr auto right_hand_sides = RightHandSides<S, Word, By, Equations>::chosen();

/// Exponents of the entries by their sizes, as fine as they are computed at most.
///@{
template <class S, class Word>
constexpr int acceleration_exponent(by::Effort, int i, int j) {
  return joint_rounding<Word>.exponent(joint_mobilities<S, Word>.of[i] * joint_mobilities<S, Word>.of[j]);
}
template <class S, class Word, class By>
constexpr int acceleration_exponent(By by, int i, int j) {
  constexpr const auto& mobile = joint_mobilities<S, Word>;
  double drive = 0.0;
  for (int k = 0; k < joint_count<S>; ++k)
    drive += mobile.of[k] * entries_of<S, Word>(by)(k, j).size;
  const int computed = exponents_of<S, Word, role::Acceleration>.of[i] + right_hand_sides<S, Word, By>.scale[j];
  return drive > 0.0 ? smaller(joint_rounding<Word>.exponent(mobile.of[i] * drive), computed) : computed;
}
///@}
template <class S, class Word, class By>
inline constexpr auto acceleration_format = entry_exponents<joint_count<S>>([](int i, int j) {
  return acceleration_exponent<S, Word>(By{}, i, j);
});

}  // namespace detail

/// Derivatives of accelerations in fixed point: entry (i, j) = raw 2^-exponent(i, j).
template <class S, class T, class By>
struct AccelerationMatrix : SquareWords<joint_count<S>, T> {
  /// Exponent of entry (i, j).
  [[nodiscard]] static constexpr int exponent(int i, int j) {
    return detail::acceleration_format<S, typename T::Word, By>.of[i][j];
  }
};

/// In fixed point M^-1 is written whole, both ways round.
template <class S, class Word>
struct AccelerationMatrices<S, Stored<Word>> {
  using ByEffort = AccelerationMatrix<S, Stored<Word>, by::Effort>;      ///< M^-1
  using ByPosition = AccelerationMatrix<S, Stored<Word>, by::Position>;  ///< d qdd / d q
  using ByVelocity = AccelerationMatrix<S, Stored<Word>, by::Velocity>;  ///< d qdd / d qd
};

namespace detail {

/// Errors of what derivatives of forward dynamics are computed from.
template <class S, class T>
inline constexpr auto slope_errors = error_bound<S, T>(algorithm::inverse_dynamics_derivatives);

/// Equations in words of motions, in the looped form no finer than leaves an effort's error six bits: links that share
/// formats have errors of about the same size, and what is known of all equations is that of the worst word.
template <class S, class T>
struct LoopedEquations {
  static constexpr int exponent(int i) {
    constexpr double most = 64.0;
    int exponent = MotionEquations<S, typename T::Word>::exponent(i);
    while (slope_errors<S, T>.tau[i] * power_of_two(exponent) > most)
      --exponent;
    return exponent;
  }
};
template <class S, class T>
using EquationsOf =
    std::conditional_t<scene_of<S>::template has<Looped>, LoopedEquations<S, T>, MotionEquations<S, typename T::Word>>;

/// What no state changes, in words: accelerations in those of requests, efforts in those of equations.
template <class S, class T>
struct DerivativeUnits {
  using C = Certificate<S, T>;
  using Equations = EquationsOf<S, T>;
  static constexpr int size = C::size;
  static constexpr double largest = 536870911.0;

  MassUnits<size> mass{};
  int effort_up[size] = {};              ///< of words of efforts to those of equations
  std::int32_t effort_error[size] = {};  ///< of efforts of inverse dynamics
  /// Of right-hand sides, column by column: what the Jacobian can be off.
  std::int32_t by_position_error[size][size] = {}, by_velocity_error[size][size] = {};

  static constexpr DerivativeUnits made() {
    constexpr const auto& errors = slope_errors<S, T>;
    DerivativeUnits u;
    for (int i = 0; i < size; ++i) {
      const int own = Equations::exponent(i), finer = own - EffortsOf<S, T>::exponent(i);
      for (int k = 0; k < size; ++k) {
        const int relative = MassMatrixOf<S, T>::exponent(i, k) + C::Requests::exponent(k) - own;
        u.mass.scale[i] = k == 0 || relative - 2 < u.mass.scale[i] ? relative - 2 : u.mass.scale[i];
      }
      for (int k = 0; k < size; ++k) {
        const int unit = u.mass.scale[i] + own - C::Requests::exponent(k);
        u.mass.down[i][k] = smaller(MassMatrixOf<S, T>::exponent(i, k) - unit, 31);
        u.mass.error[i][k] = above(errors.M(i, k), unit);
      }
      u.effort_up[i] = finer > 0 ? finer : 0;
      u.effort_error[i] = above(errors.tau[i], own);
      for (int j = 0; j < size; ++j) {
        u.by_position_error[j][i] = above(errors.dtau_dq(i, j), own + sides(by::Position{}).scale[j]);
        u.by_velocity_error[j][i] = above(errors.dtau_dqd(i, j), own + sides(by::Velocity{}).scale[j]);
      }
    }
    return u;
  }
  template <class By>
  static constexpr const auto& sides(By) {
    return right_hand_sides<S, typename T::Word, By, Equations>;
  }
  constexpr const auto& errors(by::Position, int j) const { return by_position_error[j]; }
  constexpr const auto& errors(by::Velocity, int j) const { return by_velocity_error[j]; }

 private:
  /// An error at an exponent, and that of what is rounded down to it.
  static constexpr std::int32_t above(double error, int exponent) {
    const double words = error * power_of_two(exponent) + 2.0;
    return static_cast<std::int32_t>(words < largest ? words : largest);
  }
};
/// How solutions of M's elimination become columns of an approximate inverse, as in a Certificate.
template <class S, class T>
struct LoopedColumns {
  using Units = DriveUnits<S, typename T::Word>;
  static constexpr int size = Units::size;
  int column_shift[size] = {}, widest = 0;  ///< of solutions to words of requests
  int drive_shift[size] = {};               ///< of right-hand sides to equations
  int drive[size] = {};                     ///< exponent of a unit effort's word
  int effort_down[size] = {};               ///< of words of efforts to those of equations, where these are coarser

  static constexpr LoopedColumns made() {
    constexpr const auto& u = drive_units<S, typename T::Word>;
    LoopedColumns c;
    for (int i = 0; i < size; ++i) {
      c.column_shift[i] = Certificate<S, T>::Requests::exponent(i) - (Units::bits - u.gain_bits[i] + u.scale[i]);
      c.widest = i == 0 || c.column_shift[i] > c.widest ? c.column_shift[i] : c.widest;
      c.drive_shift[i] = EquationsOf<S, T>::exponent(i) - (Units::bits - u.scale[i]);
      c.drive[i] = Units::bits - u.norm_bits[i];
      const int coarser = EffortsOf<S, T>::exponent(i) - EquationsOf<S, T>::exponent(i);
      c.effort_down[i] = coarser > 0 ? coarser : 0;
    }
    return c;
  }
};
template <class S, class T>
inline constexpr auto looped_columns = LoopedColumns<S, T>::made();

template <class S, class T>
inline constexpr auto derivative_units = DerivativeUnits<S, T>::made();

}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
