// Collisions in fixed point: raw thresholds, in the residuals' formats.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/collision.hpp>
#include <axial/fixed/control/momentum_observer.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

template <class S, class Word, class Tuning>
struct ResidualValue<S, Stored<Word>, Tuning> {
  using T = Stored<Word>;
  /// `x` N m or N at joint i
  static constexpr T of(double x, int i) { return {raw_limit<Word>(x, Residuals<S, T, Tuning>::exponent(i))}; }
  /// Whether |x| > most.
  AXIAL_INLINE static constexpr bool beyond(const T& x, const T& most) {
    const Word sign = static_cast<Word>(x.raw >> (8 * static_cast<int>(sizeof(Word)) - 1));
    return is_less(most.raw, std::int64_t{x.raw ^ sign} - sign);
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
