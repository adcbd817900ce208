// The inverse of a mass matrix in words, and how far what it makes of right-hand sides can be from the exact solutions:
// an approximate inverse refined once (Schulz 1933), and what M leaves of it. After Rump, Acta Numerica 19 (2010), 10.
#pragma once

#include <axial/fixed/dynamics/enclosure.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// What of a mass matrix no state changes: how its words become a matrix of accelerations and efforts, each joint's in
/// a unit of its own, below 2^29, and how far that can be off.
template <int N>
struct MassUnits {
  int scale[N] = {};              ///< of each row
  int down[N][N] = {};            ///< shift of each word to the right
  std::int32_t error[N][N] = {};  ///< of each entry then
};

/// M, B near its inverse, and 1 - M B: unknowns and equations of up to 8 joints, each in a unit of its own.
template <int N>
struct MassInverse {
  static_assert(N <= 8, "axial: derivatives of forward dynamics in fixed point are those of up to 8 joints");
  static constexpr int defect_bits = 26;                       ///< behind the point of a defect
  static constexpr int reach_bits = 8, loss_bits = 32;         ///< behind those of `reach` and `loss`
  static constexpr std::int64_t most = std::int64_t{3} << 29;  ///< of B's words

  std::int32_t mass[N][N] = {};     ///< M(i, j) = mass[i][j] / 2^scale[i]
  std::int32_t inverse[N][N] = {};  ///< B(i, j) = inverse[i][j] / 2^shift[j]
  int shift[N] = {};                ///< of each column
  std::int64_t defect[N][N] = {};   ///< 1 - M B as words have it
  std::int64_t spread[N] = {};      ///< row sums of |1 - M B|, at least
  std::int64_t reach[N] = {};       ///< row sums of |B|, at least
  std::int64_t loss[N] = {};        ///< |B| spread, at least
  bool proved = true;               ///< whether everything so far fitted

  /// Takes what M makes of B.
  constexpr void find_defects(const MassUnits<N>& units) {
    constexpr std::int64_t limit = std::int64_t{1} << 28;
    for (int i = 0; i < N; ++i) {
      spread[i] = 0;
      for (int j = 0; j < N; ++j) {
        std::int64_t made = 0, error = 0;
        for (int k = 0; k < N; ++k) {
          made += integer::multiply(mass[i][k], inverse[k][j]);
          error += integer::multiply(units.error[i][k], word_magnitude(inverse[k][j]));
        }
        const int down = units.scale[i] + shift[j] - defect_bits;
        const bool below = is_negative(down), beyond = !is_less(down, 64);
        const std::int64_t one = i == j ? std::int64_t{1} << defect_bits : 0;
        const std::int64_t left = one - wide_shifted_by(made, down & 63);
        const bool fits = is_less_wide(wide_magnitude(left), limit) & !below & !beyond;
        proved = proved & fits;
        defect[i][j] = left & -static_cast<std::int64_t>(fits);
        spread[i] += wide_magnitude(defect[i][j]) + wide_shifted_by(error, down & 63) + 2;
      }
    }
  }
  /// B + B (1 - M B), whose defect is the square of what it was.
  constexpr void refine() {
    constexpr std::int64_t limit = std::int64_t{1} << 29;
    for (int j = 0; j < N; ++j) {
      std::int32_t moved[N] = {};
      bool fits = true;
      for (int k = 0; k < N; ++k) {
        const std::int64_t wide = moved_wide(defect[k][j], shift[k] - shift[j], fits);
        fits = fits & is_less_wide(wide_magnitude(wide), limit);
        moved[k] = static_cast<std::int32_t>(wide & -static_cast<std::int64_t>(fits));
      }
      std::int64_t column[N] = {};
      for (int i = 0; i < N; ++i) {
        std::int64_t sum = 0;
        for (int k = 0; k < N; ++k)
          sum += integer::multiply(inverse[i][k], moved[k]);
        column[i] = inverse[i][j] + (sum >> defect_bits);
        fits = fits & is_less_wide(wide_magnitude(column[i]), most);
      }
      proved = proved & fits;
      for (int i = 0; i < N; ++i)
        refined_[i][j] = static_cast<std::int32_t>(column[i] & -static_cast<std::int64_t>(fits));
    }
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        inverse[i][j] = refined_[i][j];
  }
  /// With M B = 1 - R and row sums of |R| of at most 1/2, x = B f solves M x = r for an f with |f| <= 2 |r|, the
  /// largest component of each, hence |x - B r| <= |B| |R| |f| <= 2 |r| |B| spread.
  constexpr void bound() {
    constexpr std::int64_t half = std::int64_t{1} << (defect_bits - 1), largest_reach = std::int64_t{1} << 31;
    for (int k = 0; k < N; ++k) {
      const bool within = is_less_wide(spread[k], half + 1);
      proved = proved & within;
      spread[k] &= -static_cast<std::int64_t>(within);
    }
    for (int i = 0; i < N; ++i) {
      reach[i] = loss[i] = N;  // every product is rounded down
      for (int k = 0; k < N; ++k) {
        const std::int64_t word = word_magnitude(inverse[i][k]);
        reach[i] += wide_shifted_by(word << reach_bits, shift[k] & 63);
        loss[i] += wide_shifted_by((word * spread[k]) << (loss_bits - defect_bits), shift[k] & 63);
      }
      const bool within = is_less_wide(reach[i], largest_reach);
      proved = proved & within;
      reach[i] &= -static_cast<std::int64_t>(within);
    }
  }
  /// Row i of B r, to N units; |r| <= 2^30.
  [[nodiscard]] constexpr std::int64_t solved(int i, const std::int32_t (&r)[N]) const {
    std::int64_t sum = 0;
    for (int j = 0; j < N; ++j)
      sum += wide_shifted_by(integer::multiply(inverse[i][j], r[j]), shift[j] & 63);
    return sum;
  }
  /// How far that can be from the exact unknown where |r| is below 2^largest, to `error` < 2^30.
  [[nodiscard]] constexpr std::int64_t off(int i, std::int64_t error, int largest) const {
    return ((error * reach[i]) >> reach_bits) + (loss[i] >> (loss_bits - 1 - largest)) + N + 2;
  }

 private:
  std::int32_t refined_[N][N] = {};
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
