// The payload estimator in fixed point: sums in 96 bits, of an observer's residuals in their formats.
#pragma once

#include <axial/control/payload_estimator.hpp>
#include <axial/fixed/control/momentum_observer.hpp>
#include <axial/fixed/control/payload_formats.hpp>
#include <axial/fixed/words/scaled.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

// Whatever the words are that formats hold:
// - lagged rows take the exponent at which 2 momentum words / period + a drift word fit, as residuals do;
// - rows and residuals are divided by their joint's deviation, by a factor below 0.9995 in 2^-31, at exponents that
//   all joints share: |words| <= 0.9995 2^31 + 1;
// - a product of two is below 2^62 - 1, and so n joints add less than n 2^62 - n a sample to a sum that forgets 2^-s of
//   itself, rounded down: |sum| <= n 2^(62 + s) stays true, and n 2^s <= 2^32 keeps that in 96 bits.
template <class S, class Word, class Tuning>
struct PayloadSums<S, Stored<Word>, Tuning> {
  using T = Stored<Word>;
  using Number = Scaled;
  using Sum = integer::WideSum;
  static constexpr int n = joint_count<S>;

  struct Formats : LaggedFormats<Tuning, 4> {
    int row[4] = {}, residual_exponent = 0, memory = 0;
    std::int32_t row_factor[n] = {}, residual_factor[n] = {};
  };
  static constexpr LaggedWords words(int k) {
    using F = ColumnRounding<S, T>;
    return {F::momentum[k > 0], F::drift[k > 0]};
  }
  static constexpr Formats formats = [] {
    Formats all;
    for (int k = 0; k < 4; ++k)
      all.choose(k, words(k));
    int rows = -60, residuals = 60;  // powers of two below which factors fit
    for (int i = 0; i < n; ++i) {
      const double per = 1.0 / residual_deviation<S, Tuning>(i);
      const int own = Residuals<S, T, Tuning>::exponent(i);
      while (per * power_of_two(-rows) > 0.999)
        ++rows;
      while (per * power_of_two(residuals - own) > 0.999)
        --residuals;
    }
    for (int i = 0; i < n; ++i) {
      const double per = 1.0 / residual_deviation<S, Tuning>(i);
      all.row_factor[i] = Formats::factor(per * power_of_two(-rows));
      all.residual_factor[i] = Formats::factor(per * power_of_two(residuals - Residuals<S, T, Tuning>::exponent(i)));
    }
    for (int k = 0; k < 4; ++k)
      all.row[k] = all.exponent[k] - rows;
    all.residual_exponent = residuals;
    while (power_of_two(all.memory) * Tuning::period * 1.4142135623730951 < Tuning::memory)
      ++all.memory;
    return all;
  }();
  static_assert(formats.memory >= 2 && formats.memory <= 28 && n <= (std::int64_t{1} << (32 - formats.memory)),
                "axial: in fixed point a payload estimator's memory is 4 to 2^28 periods");

  /// Nothing overflows.
  struct Squares {
    constexpr void add(const T&) const {}
    constexpr Zero scaled() const { return {}; }
  };
  static constexpr T lagged(int k, const T& r, const T& p, const T& p_last, const T& d, const T& d_last) {
    return {
        next_residual(formats, k, shares_of<Tuning>(), r.raw, p.raw, p_last.raw, std::int32_t{0}, d.raw, d_last.raw)};
  }
  static constexpr void forget(Sum& sum) { sum.template forget<formats.memory>(); }
  static constexpr std::int32_t scaled(std::int32_t x, std::int32_t factor) {
    return static_cast<std::int32_t>((integer::multiply(x, factor) + (std::int64_t{1} << 30)) >> 31);
  }
  static constexpr void add(Sum (&information)[4][4], Sum (&moment)[4], bool used, int joint, const PayloadRow<T>& y,
                            const T& r) {
    const std::int32_t mask = -static_cast<std::int32_t>(used);
    const std::int32_t opposite = -scaled(r.raw, formats.residual_factor[joint]);
    std::int32_t row[4] = {};
    for (int i = 0; i < 4; ++i) {
      row[i] = scaled(y.of[i].raw, formats.row_factor[joint]) & mask;
      moment[i].add(integer::multiply(row[i], opposite));
      for (int j = 0; j <= i; ++j)
        information[i][j].add(integer::multiply(row[i], row[j]));
    }
  }
  static constexpr T chosen(bool first, const T& a, const T& b) {
    const auto mask = static_cast<Word>(-static_cast<int>(first));
    return {static_cast<Word>((a.raw & mask) | (b.raw & ~mask))};
  }
  static constexpr Scaled share = NumberTraits<Scaled>::constant(sample_share<Tuning>());
  static constexpr Scaled information(const Sum& sum, int i, int j) {
    return share * Scaled::of(sum, -formats.row[i] - formats.row[j]);
  }
  static constexpr Scaled moment(const Sum& sum, int i) {
    return share * Scaled::of(sum, -formats.row[i] - formats.residual_exponent);
  }
};

template <class Word>
struct PayloadSumOf<Stored<Word>> {
  using type = integer::WideSum;
};
template <class S, class Word, class Tuning>
struct ResidualInput<S, Stored<Word>, Tuning> {
  using type = Residuals<S, Stored<Word>, Tuning>;
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
