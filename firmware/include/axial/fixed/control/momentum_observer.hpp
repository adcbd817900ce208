// The momentum observer in fixed point: residuals as words, in integers, and a collision's thresholds in their formats.
#pragma once

#include <axial/control/collision.hpp>
#include <axial/fixed/control/limits.hpp>
#include <axial/fixed/dynamics/momentum.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// Exponents of the words that pass an observer's lag as one number; an effort may be missing.
struct LaggedWords {
  int momentum = 0, drift = 0, effort = none;
  static constexpr int none = 1000;
  constexpr bool has_effort() const { return effort != none; }
};

/// Exponents of what passes an observer's lag, and the factors in 2^-31 that bring momenta, efforts and drifts there.
/// Sums of the largest words that those formats hold fit, so no input overflows.
template <class Tuning, int size>
struct LaggedFormats {
  int exponent[size] = {};
  std::int32_t momentum[size] = {}, effort[size] = {}, half_drift[size] = {};

  constexpr void choose(int i, const LaggedWords& words) {
    constexpr WordRounding rounding{32, true, false, 0.0};
    const int p = words.momentum, d = words.drift, e = words.effort;
    const int own = rounding.exponent(power_of_two(32 - p) / Tuning::period +
                                      (words.has_effort() ? power_of_two(31 - e) : 0.0) + power_of_two(31 - d));
    exponent[i] = own;
    momentum[i] = factor(power_of_two(own - p) / Tuning::period);
    effort[i] = words.has_effort() ? factor(power_of_two(own - e)) : 0;
    half_drift[i] = factor(0.5 * power_of_two(own - d));
  }
  static constexpr std::int32_t factor(double x) {
    return static_cast<std::int32_t>(nearest_integer(x * power_of_two(31)));
  }
};

/// What joint i's residual is made of.
template <class S, class T>
constexpr LaggedWords residual_words(int i) {
  return {MomentaOf<S, T>::exponent(i), MomentumRatesOf<S, T>::exponent(i), EffortsOf<S, T>::exponent(i)};
}
template <class S, class Word, class Tuning>
constexpr auto chosen_residual_formats() {
  check_observed<Stored<Word>>();
  LaggedFormats<Tuning, joint_count<S>> all;
  for (int i = 0; i < joint_count<S>; ++i)
    all.choose(i, residual_words<S, Stored<Word>>(i));
  return all;
}
template <class S, class Word, class Tuning>
inline constexpr auto residual_formats = chosen_residual_formats<S, Word, Tuning>();

}  // namespace detail

/// Residuals in fixed point: value = raw 2^-exponent(i).
template <class S, class Word, class Tuning>
struct Residuals<S, Stored<Word>, Tuning> {
  static constexpr int size = joint_count<S>;  ///< number of joints
  Stored<Word> values[size];                   ///< from the base outwards
  /// Exponent of joint i's residual.
  [[nodiscard]] static constexpr int exponent(int i) { return detail::residual_formats<S, Word, Tuning>.exponent[i]; }
  AXIAL_INLINE constexpr Stored<Word>& operator[](int i) {
    return values[i];
  }  ///< residual of joint i; the index is not checked
  /// Residual of joint i; the index is not checked.
  AXIAL_INLINE constexpr const Stored<Word>& operator[](int i) const { return values[i]; }
};

namespace detail {

/// x 2^-bits to nearest.
template <int bits>
AXIAL_INLINE constexpr std::int32_t lowered(std::int64_t x) {
  return static_cast<std::int32_t>((x + (std::int64_t{1} << (bits - 1))) >> bits);
}
/// The share of a new sample in 2^-30, and what is left of the old ones.
template <class Factor>
struct Shares {
  Factor taken, kept;
};
template <class Tuning>
constexpr Shares<std::int32_t> shares_of() {
  const auto taken = static_cast<std::int32_t>(nearest_integer(residual_share<Tuning>() * power_of_two(30)));
  return {taken, (1 << 30) - taken};
}

/// The next residual of joint i, in integers or in what bounds them.
template <class Formats, class Factor, class X>
AXIAL_INLINE constexpr X next_residual(const Formats& f, int i, const Shares<Factor>& share, const X& r, const X& p,
                                       const X& p_last, const X& tau, const X& drift, const X& drift_last) {
  using integer::multiply;
  const auto known =
      multiply(tau, f.effort[i]) + multiply(drift, f.half_drift[i]) + multiply(drift_last, f.half_drift[i]);
  const auto change = multiply(p, f.momentum[i]) - multiply(p_last, f.momentum[i]);
  const X e = lowered<31>(change - known);
  return lowered<30>(multiply(e, share.taken) + multiply(r, share.kept));
}

template <class S, class Word, class Tuning>
struct ResidualStep<S, Stored<Word>, Tuning> {
  using T = Stored<Word>;
  using Terms = MomentumTerms<S, T>;
  /// `r` of joint i.
  static constexpr void take(Soundness<T>&, T& r, int i, bool ready, const Terms& now, const Terms& last,
                             const EffortsOf<S, T>& tau) {
    constexpr const auto& f = residual_formats<S, Word, Tuning>;
    constexpr auto share = shares_of<Tuning>();
    const std::int32_t next = next_residual(f, i, share, r.raw, now.momentum[i].raw, last.momentum[i].raw, tau[i].raw,
                                            now.drift[i].raw, last.drift[i].raw);
    const std::int32_t known = -static_cast<std::int32_t>(ready);
    r.raw = (next & known) | (r.raw & ~known);
  }
};

template <class S, class Word, class Tuning>
struct ResidualValue<S, Stored<Word>, Tuning> {
  using T = Stored<Word>;
  static constexpr T of(double x, int i) { return {raw_limit<Word>(x, Residuals<S, T, Tuning>::exponent(i))}; }
  AXIAL_INLINE static constexpr bool beyond(const T& x, const T& most) {
    const Word sign = static_cast<Word>(x.raw >> (8 * static_cast<int>(sizeof(Word)) - 1));
    return is_less(most.raw, std::int64_t{x.raw ^ sign} - sign);
  }
};

}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
