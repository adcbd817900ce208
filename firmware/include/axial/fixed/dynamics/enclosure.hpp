// How far an approximate solution of M x = b in words is from the exact one: by an approximate inverse of M, of which
// nothing has to be known but what M makes of its columns, and a residual. After Rump, Acta Numerica 19 (2010), 10.
// What a certified answer of forward dynamics is, and what there is to say about one.
#pragma once

#include <axial/fixed/formats/joint_formats.hpp>
#include <axial/fixed/words/integer.hpp>
#include <axial/fixed/words/wide_words.hpp>
#include <axial/recursion/forward_result.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Accelerations, how far each can be from the exact one, and what there is to say about them.
template <class S, class T>
struct CertifiedDynamics : ForwardDynamics<S, T> {
  FreeAccelerations<S, T> bound{};  ///< of each acceleration, in its format; the largest word where nothing is known
};

namespace detail {

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

/// An error in words, from above; the largest that is of use where it is more.
constexpr std::int32_t rounded_up(double x) {
  constexpr double most = 1073741823.0;
  return x < most ? static_cast<std::int32_t>(x) + 1 : static_cast<std::int32_t>(most);
}

/// Column j of the approximate inverse from such an answer: accelerations inside the limits, for their words have 31
/// bits there. `c` has the shifts of a Certificate.
template <int size, class Shifts, class System>
AXIAL_INLINE constexpr void set_shifted_column(const Shifts& c, System& system, int j, const std::int32_t* answer,
                                               int drive) {
  constexpr int bits = 30;
  std::int64_t wide[size] = {}, seen = 0;
  for (int i = 0; i < size; ++i) {
    const int behind = c.widest - c.column_shift[i], right = behind > bits ? smaller(behind - bits, 31) : 0;
    wide[i] = integer::multiply(answer[i] >> right, std::int32_t{1} << (behind > bits ? 0 : bits - behind));
    seen |= wide[i] ^ (wide[i] >> 63);
  }
  const auto top = static_cast<std::uint32_t>(seen >> bits);
  const int down = 31 - integer::detail::leading_zeros((top << 1) | 1U);
  for (int i = 0; i < size; ++i)
    system.inverse[i][j] = static_cast<std::int32_t>(wide_shifted_by(wide[i], down));
  system.shift[j] = drive + c.drive_shift[j] + bits - c.widest - down;
}

/// Writes the corrected answer and its bound: x(i) is what was answered in units of the system, `down(i)` bits finer
/// than the answer's words. `known` says whether there is one; true where every bound is below its `tight`.
template <int size, class Answer, class System, class X, class Down>
AXIAL_INLINE constexpr bool publish_in_words(Answer& answer, const System& system, const std::int64_t (&tight)[size],
                                             bool known, const X& x, const Down& down) {
  constexpr std::int64_t most = (std::numeric_limits<std::int32_t>::max)();
  constexpr int finest = 31;
  bool all_tight = known;
  for (int i = 0; i < size; ++i) {
    const int own = down(i), right = own < 0 ? 0 : own > finest ? finest : own;
    const int left = own < 0 ? smaller(-own, finest) : 0;
    const std::int64_t bound = ((system.bound[i] >> right) + (right > 0 ? 2 : 0)) * (std::int64_t{1} << left);
    const std::int64_t value = ((x(i) + system.correction[i]) >> right) * (std::int64_t{1} << left);
    const bool bound_fits = is_less_wide(bound, most), value_fits = is_less_wide(wide_magnitude(value), most);
    const bool fits = bound_fits & value_fits & known;
    answer.bound.values[i] = {static_cast<std::int32_t>(select_wide(fits, bound, most))};
    answer.values[i] = {static_cast<std::int32_t>(select_wide(fits, value, answer.values[i].raw))};
    all_tight = all_tight & fits & !is_less_wide(tight[i], system.bound[i]);
  }
  return all_tight;
}

/// Whether the plain solve came to an answer, which may be beyond what is declared.
AXIAL_INLINE constexpr bool is_answer(Status::Code plain) {
  return (plain == Status::Code::ok) | (plain == Status::Code::rescaled) | (plain == Status::Code::acceleration_limit);
}
/// What status an answer has that the plain solve calls `plain`.
AXIAL_INLINE constexpr Status certified_status(Status plain, bool inside, bool tight) {
  const int short_of =
      select(inside, static_cast<int>(Status::Code::inaccurate), static_cast<int>(Status::Code::acceleration_limit));
  const int found = select(tight, static_cast<int>(plain.code), short_of);
  return {static_cast<Status::Code>(select(is_answer(plain.code), found, static_cast<int>(plain.code))),
          select(is_answer(plain.code) & (plain.code != Status::Code::acceleration_limit), -1, plain.joint)};
}

}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
