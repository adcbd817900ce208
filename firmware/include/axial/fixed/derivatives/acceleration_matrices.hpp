// Matrices of forward dynamics' derivatives in fixed point: an exponent per entry, by what M^-1 can be.
#pragma once

#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/fixed/derivatives/derivatives.hpp>
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

}  // namespace axial

#include <axial/options/end.hpp>
