// How far an approximate solution of M x = b in words is from the exact one: by an approximate inverse of M, of which
// nothing has to be known but what M makes of its columns, and a residual. After Rump, Acta Numerica 19 (2010), 10.
#pragma once

#include <axial/fixed/words/integer.hpp>
#include <axial/fixed/words/wide_words.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// A linear system of up to 8 unknowns in words, each unknown and each equation in a unit of its own. Where enclose()
/// answers true the exact solution is within `bound` of x + `correction`, for the x that leaves `residual`.
template <int N>
struct Enclosure {
  static_assert(N <= 8, "axial: an answer of up to 8 joints is certified");
  static constexpr int defect_bits = 26;  ///< behind the point of `defect`
  static constexpr int least_shift = 6, largest_shift = 46;
  static constexpr std::int64_t least_weight = 16, weights = std::int64_t{1} << 30;  ///< of |b - M x|
  static constexpr std::int64_t defects = std::int64_t{8} << defect_bits;            ///< of 1 - M B

  std::int32_t inverse[N][N] = {};      ///< B(i, j) = inverse[i][j] / 2^shift[j], near M^-1; below 2^30
  int shift[N] = {};                    ///< of each column
  std::int64_t defect[N][N] = {};       ///< |1 - M B|, at least
  std::int64_t residual[N] = {};        ///< b - M x, within residual_error
  std::int64_t residual_error[N] = {};  ///< not negative
  std::int64_t correction[N] = {};      ///< B residual
  std::int64_t bound[N] = {};           ///< of |exact - x - correction|
  bool proved = true;                   ///< whether everything so far fitted

  /// Sets defect(., j) by what M makes of column j: `made`, each within `error`.
  constexpr void set_defects(int j, const std::int64_t (&made)[N], const std::int32_t (&error)[N]) {
    const bool below = is_less(shift[j], least_shift), within = is_less(shift[j], largest_shift);
    proved = proved & !below & within;
    constexpr int room = defect_bits - least_shift;
    for (int i = 0; i < N; ++i) {
      const std::int64_t wanted = i == j ? wide_power(shift[j] & 63) : 0;
      const std::int64_t off = wide_magnitude(wanted - made[i]) + error[i];
      const bool fits = is_less_wide(off, std::int64_t{1} << (62 - room));
      const std::int64_t kept = off & -static_cast<std::int64_t>(fits);
      proved = proved & fits;
      defect[i][j] = wide_shifted_by(kept << room, (shift[j] - least_shift) & 63) + 1;
    }
  }
  /// With M B = 1 - R the error is B f, where f = r + R f. If w >= |r| and |R| w <= w / 2, then |f| <= 2 w, hence
  /// |f - residual| <= residual_error + 2 |R| w, and |B| times that bounds what B residual lacks.
  constexpr bool enclose() {
    std::int64_t weight[N] = {}, unknown[N] = {};
    for (int i = 0; i < N; ++i) {
      weight[i] = wide_magnitude(residual[i]) + residual_error[i] + least_weight;
      proved = proved & is_less_wide(weight[i], weights);
    }
    for (int i = 0; i < N; ++i) {
      std::int64_t sum = 0;
      for (int k = 0; k < N; ++k) {
        proved = proved & is_less_wide(defect[i][k], defects);
        sum += product_of_words(defect[i][k] & (defects - 1), weight[k] & (weights - 1));
      }
      proved = proved & !is_less_wide((weight[i] & (weights - 1)) << (defect_bits - 1), sum);
      unknown[i] = residual_error[i] + (sum >> (defect_bits - 1)) + 1;
    }
    for (int i = 0; i < N; ++i)
      answer(i, unknown);
    return proved;
  }

 private:
  // Of 64 bits a Cortex-M0 has a routine of the compiler's, which branches. What is proved fits words.
  static constexpr std::int64_t product_of_words(std::int64_t a, std::int64_t b) {
    return integer::multiply(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
  }
  constexpr void answer(int i, const std::int64_t (&unknown)[N]) {
    const std::int64_t kept = -static_cast<std::int64_t>(proved);  // nothing overflows where all is proved
    std::int64_t sum = 0, lacks = std::int64_t{2} * N;             // every product is rounded down
    for (int j = 0; j < N; ++j) {
      sum += wide_shifted_by(product_of_words(inverse[i][j], residual[j] & kept), shift[j] & 63);
      lacks += wide_shifted_by(product_of_words(wide_magnitude(inverse[i][j]), unknown[j] & kept), shift[j] & 63);
    }
    correction[i] = sum, bound[i] = lacks;
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
