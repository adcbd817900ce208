// M udd = left of drives that joints share, in words: eliminated once, and refined by what the answer leaves of it.
#pragma once

#include <axial/fixed/dynamics/mass_inverse.hpp>
#include <axial/fixed/dynamics/mass_matrix.hpp>
#include <axial/fixed/formats/drive_units.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// M eliminated (L^T D L, Featherstone 2008, section 6.5) in DriveUnits, whose bounds hold every word, and solutions.
template <class S, class Word>
class DriveSolve {
 public:
  using Units = DriveUnits<S, Word>;
  using Matrix = MassMatrixOf<S, Stored<Word>>;
  using A = ArithmeticOf<scene_of<S>, Word>;
  static constexpr int size = Units::size, bits = Units::bits;
  static constexpr const auto& u = drive_units<S, Word>;

  /// Eliminates M from the last drive on.
  AXIAL_INLINE constexpr explicit DriveSolve(const Matrix& m) : m_(m) {
    std::int32_t left[size][size] = {};
    for (int k = 0; k < size; ++k)
      for (int l = 0; l <= k; ++l)
        left[k][l] = m(k, l).raw >> u.down[k][l];
    for (int k = size; k-- > 0;)
      eliminate(left, k);
  }
  /// The innermost drive whose inertia is lost in rounding, -1 for none. It is held.
  [[nodiscard]] AXIAL_INLINE constexpr int lost() const { return lost_; }

  /// M'^-1 w in words of bits - gain_bits[k] behind the point, in place.
  AXIAL_INLINE constexpr void solve(std::int32_t (&w)[size]) const {
    for (int k = size; k-- > 0;)
      for (int i = 0; i < k; ++i)
        w[i] = narrowed<A>(w[i] - wide_rounded(integer::multiply(gain_[k][i], w[k]), bits - u.gain_bits[k]));
    for (int k = 0; k < size; ++k) {
      std::int64_t own = wide_rounded(integer::multiply(w[k], mantissa_[k]), shift_[k]);
      for (int i = 0; i < k; ++i)
        own -= wide_rounded(integer::multiply(gain_[k][i], w[i]), bits - u.gain_bits[i]);
      w[k] = narrowed<A>(own);
    }
  }
  /// What accelerations, in words, leave of `left`, efforts in their words; all to `size` units.
  AXIAL_INLINE constexpr void residual(const std::int64_t (&left)[size], const std::int32_t (&x)[size],
                                       std::int64_t (&r)[size]) const {
    for (int k = 0; k < size; ++k) {
      r[k] = wide_raised(left[k], u.given[k]);
      for (int l = 0; l < size; ++l)
        r[k] -= wide_shifted_by(integer::multiply(m_(k, l).raw, x[l]), u.product[k][l]);
    }
  }
  /// Accelerations, in words; `spilt` is the first drive whose word does not hold its own.
  AXIAL_INLINE constexpr void accelerations(const std::int64_t (&left)[size], std::int32_t (&x)[size],
                                            int& spilt) const {
    for (int s = 0; s < Units::solves; ++s) {
      std::int64_t r[size] = {};
      residual(left, x, r);
      spilt = -1;
      correct(r, x, spilt);
    }
  }

 private:
  const Matrix& m_;
  std::int32_t gain_[size][size] = {}, mantissa_[size] = {};
  int shift_[size] = {}, lost_ = -1;

  AXIAL_INLINE constexpr void eliminate(std::int32_t (&left)[size][size], int k) {
    const bool kept = !is_less_wide(left[k][k], u.least[k]);
    const auto inverse = integer::reciprocal(static_cast<std::int32_t>(select_wide(kept, left[k][k], 1)));
    lost_ = select(kept, lost_, k);
    mantissa_[k] = static_cast<std::int32_t>(inverse.mantissa) & -static_cast<std::int32_t>(kept);
    shift_[k] = inverse.exponent - bits + u.gain_bits[k];
    for (int i = 0; i < k; ++i)
      gain_[k][i] = narrowed<A>(wide_rounded(integer::multiply(left[k][i], mantissa_[k]), shift_[k]));
    for (int i = 0; i < k; ++i)
      for (int j = 0; j <= i; ++j)
        left[i][j] =
            narrowed<A>(left[i][j] - wide_rounded(integer::multiply(gain_[k][i], left[k][j]), bits - u.gain_bits[k]));
  }
  /// x + M^-1 r, r as large as words hold it.
  AXIAL_INLINE constexpr void correct(const std::int64_t (&r)[size], std::int32_t (&x)[size], int& spilt) const {
    int most = -1000;
    for (int k = 0; k < size; ++k) {
      const int own = wide_bits(r[k]) + u.norm_bits[k] - u.residual[k] - u.scale[k];
      most = static_cast<int>(select_wide(is_less_wide(most, own), own, most));
    }
    std::int32_t w[size] = {};
    bool fits = true;
    for (int k = 0; k < size; ++k)
      w[k] = narrowed<A>(moved_wide(r[k], u.residual[k] + u.scale[k] - bits + most, fits));
    solve(w);
    for (int k = 0; k < size; ++k) {
      const int down = bits - u.gain_bits[k] - most + u.scale[k] - Units::Answers::exponent(k);
      bool held = true, over = false;
      const std::int64_t whole = moved_wide(wide_raised(w[k], 1), down, held);
      x[k] = held_in_word<A>(over, x[k] + ((whole + 1) >> 1));
      spilt = first_found(spilt, over | !held, k);
    }
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
