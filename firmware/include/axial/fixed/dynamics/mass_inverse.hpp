// The inverse of a mass matrix in words, and how far what it makes of right-hand sides can be from the exact solutions:
// an approximate inverse refined once (Schulz 1933), and what M leaves of it. After Rump, Acta Numerica 19 (2010), 10.
#pragma once

#include <axial/fixed/dynamics/enclosure.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

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
  static constexpr int reach_bits = 8, loss_bits = 32;         ///< behind those of row sums of |B|, and of losses
  static constexpr std::int64_t most = std::int64_t{3} << 29;  ///< of B's words
  /// Right-hand sides and their errors are below it.
  static constexpr std::int64_t right_sides = std::int64_t{1} << 29;

  std::int32_t mass[N][N] = {};     ///< M(i, j) = mass[i][j] / 2^scale[i]
  std::int32_t inverse[N][N] = {};  ///< B(i, j) = inverse[i][j] / 2^shift[j]
  int shift[N] = {};                ///< of each column
  std::int64_t defect[N][N] = {};   ///< 1 - M B as words have it
  std::int32_t rest[N][N] = {};     ///< |1 - M B|, at least
  std::int64_t spread[N] = {};      ///< row sums of `rest`
  std::int32_t second[N] = {};      ///< |1 - M B| spread, at least
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
        const std::int64_t off = wide_magnitude(defect[i][j]) + wide_shifted_by(error, down & 63) + 2;
        const bool known = is_less_wide(off, limit);
        proved = proved & known;
        rest[i][j] = static_cast<std::int32_t>(off & -static_cast<std::int64_t>(known));
        spread[i] += rest[i][j];
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
  /// With M B = 1 - R and row sums of |R| of at most 1/2, x = B f solves M x = r + d for an f with f = r + d + R f, so
  /// |f| <= 2 m for the largest component m of |r| + |d|, hence |f| <= |r| + |d| + 2 m |R| 1, and |f - r| <= |d| + |R|
  /// (|r| + |d|) + 2 m |R| |R| 1, component by component.
  constexpr void bound() {
    constexpr std::int64_t half = std::int64_t{1} << (defect_bits - 1), largest_reach = std::int64_t{1} << 31;
    for (int k = 0; k < N; ++k) {
      const bool within = is_less_wide(spread[k], half + 1);
      proved = proved & within;
      spread[k] &= -static_cast<std::int64_t>(within);
      for (int j = 0; j < N; ++j)
        rest[k][j] &= -static_cast<std::int32_t>(within);
    }
    for (int i = 0; i < N; ++i) {
      std::int64_t reach = N, sum = 0;  // every product is rounded down
      for (int k = 0; k < N; ++k) {
        reach += wide_shifted_by(std::int64_t{word_magnitude(inverse[i][k])} << reach_bits, shift[k] & 63);
        sum += integer::multiply(rest[i][k], static_cast<std::int32_t>(spread[k]));
      }
      const bool within = is_less_wide(reach, largest_reach);
      proved = proved & within;
      for (int k = 0; k < N; ++k)
        inverse[i][k] &= -static_cast<std::int32_t>(within);
      second[i] = static_cast<std::int32_t>(sum >> defect_bits) + 1;
    }
  }
  /// |f - r| for a right-hand side of which |d| is at most `error`; both are below `right_sides`.
  constexpr void find_lack(const std::int32_t (&r)[N], const std::int32_t (&error)[N], std::int32_t (&lack)[N]) const {
    std::int32_t size[N] = {}, largest = 0;
    for (int k = 0; k < N; ++k) {
      size[k] = word_magnitude(r[k]) + error[k];
      largest |= size[k];  // of which none is larger
    }
    for (int k = 0; k < N; ++k) {
      std::int64_t sum = 2 * integer::multiply(second[k], largest);
      for (int j = 0; j < N; ++j)
        sum += integer::multiply(rest[k][j], size[j]);
      lack[k] = error[k] + static_cast<std::int32_t>(sum >> defect_bits) + 1;
    }
  }
  /// Lowers what find_lack() says, where the right-hand side is moved besides: f = r + v + g, |g| <= lack, |v| <=
  /// `moved` and |B v| <= `shifted`. With words W of M, which are off by E, g = d + (1 - W B) f - E x for the unknowns
  /// x = B f. What r has of the second is known with its sign; of the third unknowns count, not what columns of B add
  /// up to.
  constexpr void lower_lack(const MassUnits<N>& units, const std::int32_t (&r)[N], const std::int32_t (&error)[N],
                            std::int64_t moved, const std::int64_t (&shifted)[N], std::int32_t (&lack)[N]) const {
    std::int64_t unknown[N] = {}, largest = 0;
    for (int i = 0; i < N; ++i) {
      unknown[i] = wide_magnitude(solved(i, r)) + off(i, lack) + shifted[i];
      largest |= unknown[i];
    }
    const int above = wide_bits(largest) - word_bits, coarser = select(is_negative(above), 0, above);
    std::int32_t words[N] = {}, lower[N] = {};
    for (int i = 0; i < N; ++i)
      words[i] = static_cast<std::int32_t>(wide_shifted_by(unknown[i], coarser)) + 1;
    for (int k = 0; k < N; ++k) {
      std::int64_t by_mass = 0;
      for (int j = 0; j < N; ++j)
        by_mass += integer::multiply(units.error[k][j], words[j]);
      bool fits = true;
      const std::int64_t sum =
          lost_of(k, r, lack, moved, fits) + moved_wide(by_mass, units.scale[k] - coarser, fits) + error[k] + 2;
      lower[k] = static_cast<std::int32_t>(select_wide(fits & is_less_wide(sum, lack[k]), sum, lack[k]));
    }
    for (int k = 0; k < N; ++k)
      lack[k] = lower[k];
  }
  /// Row i of B r, to N units; |r| <= 2^30.
  [[nodiscard]] constexpr std::int64_t solved(int i, const std::int32_t (&r)[N]) const {
    std::int64_t sum = 0;
    for (int j = 0; j < N; ++j)
      sum += wide_shifted_by(integer::multiply(inverse[i][j], r[j]), shift[j] & 63);
    return sum;
  }
  /// How far that can be from the exact unknown.
  [[nodiscard]] constexpr std::int64_t off(int i, const std::int32_t (&lack)[N]) const {
    std::int64_t sum = 2 * N + 2;  // products are rounded down, here and in solved()
    for (int k = 0; k < N; ++k)
      sum += wide_shifted_by(integer::multiply(word_magnitude(inverse[i][k]), lack[k]), shift[k] & 63);
    return sum;
  }
  /// How far B(i, j) can be from M^-1, with loss_bits behind the point.
  [[nodiscard]] constexpr std::int64_t loss(int i, int j) const {
    std::int64_t sum = N;  // every product is rounded down
    for (int k = 0; k < N; ++k) {
      const std::int64_t lack = std::int64_t{rest[k][j]} + 2 * std::int64_t{second[k]};
      sum += wide_shifted_by((word_magnitude(inverse[i][k]) * lack) << (loss_bits - defect_bits), shift[k] & 63);
    }
    return sum;
  }

 private:
  static constexpr int word_bits = 30;
  std::int32_t refined_[N][N] = {};

  /// Row k of (1 - W B) f.
  constexpr std::int64_t lost_of(int k, const std::int32_t (&r)[N], const std::int32_t (&lack)[N], std::int64_t moved,
                                 bool& fits) const {
    std::int64_t known = 0, open = 0;
    for (int j = 0; j < N; ++j) {
      const auto left = static_cast<std::int32_t>(defect[k][j]);  // rounded down
      const std::int64_t besides = moved + lack[j];
      const bool below = is_less_wide(besides, std::int64_t{1} << (word_bits + 1));
      fits = fits & below;
      known += integer::multiply(left, r[j]);
      open += 2 * std::int64_t{word_magnitude(r[j])};
      open += integer::multiply(word_magnitude(left) + 2,
                                static_cast<std::int32_t>(besides & -static_cast<std::int64_t>(below)));
    }
    return (wide_magnitude(known) + open) >> defect_bits;
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
