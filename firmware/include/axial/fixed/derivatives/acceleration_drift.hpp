// How far d qdd / d q is off because the accelerations are that Jacobians of inverse dynamics are taken at.
#pragma once

#include <axial/fixed/derivatives/derivative_solve.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// For entries that no acceleration moves.
struct NoDrift {
  bool bounded = true;  ///< whether bounds are known
  /// As of AccelerationDrift.
  ///@{
  AXIAL_INLINE constexpr std::int64_t noise(std::int32_t, int) const { return 0; }
  AXIAL_INLINE constexpr std::int64_t moved() const { return 0; }
  AXIAL_INLINE constexpr std::int64_t spread(std::int64_t) const { return 0; }
  AXIAL_INLINE constexpr std::int64_t off(int, int) const { return 0; }
  ///@}
};

/// Accelerations that are off by e move column j of d tau / d q by D e, D = dM / d q_j, and that of d qdd / d q by M^-1
/// D e. What is known of e is its correction c, and e - c = B f with |f| <= lack: M^-1 D e is M^-1 D c and at most the
/// sum of |M^-1 D b| lack over the columns b of B. D times accelerations is what Jacobians have there above those at
/// none; magnified to what is declared, accelerations make their errors slight. What columns have in common cancels.
template <class S, class T>
class AccelerationDrift {
  using Solve = DerivativeSolve<S, T>;
  using Requests = typename Solve::C::Requests;
  using Matrix = typename AccelerationMatrices<S, T>::ByPosition;
  static constexpr int size = Solve::size, bits = 6, share_bits = 30, column_bits = 29;
  static constexpr const auto& sides = right_hand_sides<S, typename T::Word, by::Position, EquationsOf<S, T>>;

  std::int64_t open_[size][size] = {};  // at least, `bits` finer than the bounds
  std::int64_t share_ = 0;              // sum of what accelerations are weighed with

 public:
  bool bounded = true;  ///< whether everything so far fitted

  /// By the Jacobians at accelerations x, slopes_at(x).
  template <class SlopesAt>
  constexpr AccelerationDrift(const Solve& solve, const SlopesAt& slopes_at) {
    const auto resting = slopes_at(Requests{});
    for (int m = 0; m <= size; ++m) {
      const bool corrects = m == size;
      const int column = select(corrects, 0, m), up = magnification(solve);
      Requests moving{};
      for (int k = 0; k < size; ++k) {
        const std::int64_t correction = solve.correction[k] & -static_cast<std::int64_t>(solve.known);
        const auto corrected = static_cast<std::int32_t>(wide_raised(correction, up));
        // Words of B reach beyond what is declared, their halves do not.
        moving.values[k] = {select(corrects, corrected, solve.system.inverse[k][column] >> 1)};
      }
      add(solve.system, slopes_at(moving).dtau_dq, resting.dtau_dq, select(corrects, 1, solve.lack[column]),
          select(corrects, up, solve.system.shift[column] - 1));
    }
    bounded = bounded & is_less_wide(share_, std::int64_t{1} << share_bits);
    share_ &= -static_cast<std::int64_t>(bounded);
  }
  /// What a right-hand side lacks by it whose own error is `error`: the errors of two Jacobians' halves, with three
  /// roundings, of what is added, and roundings of the correction.
  [[nodiscard]] constexpr std::int64_t noise(std::int32_t error, int down) const {
    return share_of(std::int64_t{error} + 3) + (size >> (down - 1)) + 1;
  }
  /// What is added is below a share of it, on the way to accelerations too where M leaves `spread` of B.
  [[nodiscard]] constexpr std::int64_t moved() const { return share_of(std::int64_t{1} << column_bits); }
  [[nodiscard]] constexpr std::int64_t spread(std::int64_t rows) const {
    return share_of(2 * (rows << (column_bits - MassInverse<size>::defect_bits)));
  }
  /// How far entry (i, j) is off by it, but for noise, in its unit.
  [[nodiscard]] constexpr std::int64_t off(int i, int j) const { return (open_[i][j] >> bits) + 1; }

 private:
  constexpr std::int64_t share_of(std::int64_t x) const {
    return (integer::multiply(static_cast<std::int32_t>(share_), static_cast<std::int32_t>(x)) >> share_bits) + 1;
  }
  /// Doublings of the corrections, all of which are declared accelerations then.
  static constexpr int magnification(const Solve& solve) {
    std::int64_t seen = 1;
    for (int k = 0; k < size; ++k)
      seen |= wide_magnitude(solve.correction[k]);
    const int up = share_bits - wide_bits(seen);
    return select(is_negative(up), 0, up);
  }
  /// Adds what accelerations make of the entries, `weight` / 2^doublings of them.
  template <class Jacobian>
  constexpr void add(const MassInverse<size>& system, const Jacobian& moving, const Jacobian& resting,
                     std::int32_t weight, int doublings) {
    const int down = doublings - 1;  // of halves
    share_ += fitting(weight, down - share_bits) + 1;
    for (int j = 0; j < size; ++j) {
      std::int32_t right[size] = {};
      for (int i = 0; i < size; ++i)
        right[i] = ((moving(i, j).raw >> sides.down[i][j]) - (resting(i, j).raw >> sides.down[i][j])) >> 1;
      for (int i = 0; i < size; ++i) {
        const int coarser = Requests::exponent(i) + sides.scale[j] - Matrix::exponent(i, j);
        bool fits = true;
        const std::int64_t wide = wide_magnitude(moved_wide(system.solved(i, right), coarser, fits)) + size + 1;
        fits = fits & fits_word(wide);
        const auto entry = static_cast<std::int32_t>(wide & -static_cast<std::int64_t>(fits));
        open_[i][j] += fitting(integer::multiply(entry, weight), down - bits) + 1;
        bounded = bounded & (fits | !sides.filled[j]);
      }
    }
  }
  /// x / 2^shift, of which sums of nine fit; 0 where not.
  constexpr std::int64_t fitting(std::int64_t x, int shift) {
    const std::int64_t wide = moved_wide(x, shift, bounded);
    const bool fits = is_less_wide(wide_magnitude(wide), std::int64_t{1} << 59);
    bounded = bounded & fits;
    return wide & -static_cast<std::int64_t>(fits);
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
