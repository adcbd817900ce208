// The certified error of residuals: the observer's step in integers, run on bounds, and what a detector makes of it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/control/momentum_observer.hpp>
#include <axial/fixed/error_bound.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace algorithm {
/// observe() and detect() of a tuning.
///@{
template <class Tuning>
struct MomentumObserver {};
template <class Tuning>
struct CollisionDetector {};
///@}
}  // namespace algorithm

namespace detail {

/// A raw word in bounds: in units of its format.
struct RawBound {
  Ball bound{};  ///< of the exact value, and of the word's distance from it
};
/// A factor as it is stored, for an exact one.
struct RawFactor {
  Ball bound{};  ///< both in units of the stored one
};
constexpr RawFactor raw_factor(std::int32_t stored, double exact) {
  return {{magnitude(exact), magnitude(static_cast<double>(stored) - exact)}};
}

/// A sum of products in bounds.
struct RawSum {
  Ball bound{};  ///< in units of the product's format
};

/// What the observer's step does with words.
///@{
constexpr RawSum multiply(const RawBound& x, const RawFactor& factor) { return {x.bound * factor.bound}; }
constexpr RawSum operator+(const RawSum& a, const RawSum& b) { return {a.bound + b.bound}; }
constexpr RawSum operator-(const RawSum& a, const RawSum& b) { return a + b; }
template <int bits>
constexpr RawBound lowered(const RawSum& x) {
  return {{x.bound.size * power_of_two(-bits), x.bound.error * power_of_two(-bits) + 0.5}};
}
///@}

/// The factors of LaggedFormats in bounds.
template <class Tuning, int size>
struct BoundedLaggedFormats {
  RawFactor momentum[size] = {}, effort[size] = {}, half_drift[size] = {};

  constexpr void choose(int i, const LaggedFormats<Tuning, size>& f, const LaggedWords& words) {
    const int own = f.exponent[i] + 31;
    momentum[i] = raw_factor(f.momentum[i], power_of_two(own - words.momentum) / Tuning::period);
    if (words.has_effort()) effort[i] = raw_factor(f.effort[i], power_of_two(own - words.effort));
    half_drift[i] = raw_factor(f.half_drift[i], 0.5 * power_of_two(own - words.drift));
  }
};
template <class S, class Word, class Tuning>
struct BoundedResidualFormats : BoundedLaggedFormats<Tuning, joint_count<S>> {
  constexpr BoundedResidualFormats() {
    for (int i = 0; i < joint_count<S>; ++i)
      this->choose(i, residual_formats<S, Word, Tuning>, residual_words<S, Stored<Word>>(i));
  }
};

/// Error of what passes the observer's lag, raw: of joint i's, or of the i-th entry of a payload's rows. p and drift
/// are off by their errors, tau is exact. What is off moves on as b + k times that, k < 1: it never exceeds b / (1 -
/// k).
template <class Tuning, class Formats>
constexpr double lagged_error(const Formats& f, int i, double momentum_error, double drift_error) {
  constexpr double most = power_of_two(31), share = residual_share<Tuning>() * power_of_two(30);
  constexpr auto stored = shares_of<Tuning>();
  constexpr Shares<RawFactor> shares{raw_factor(stored.taken, share),
                                     raw_factor(stored.kept, power_of_two(30) - share)};
  const RawBound p{{most, momentum_error}}, drift{{most, drift_error}}, tau{{most, 0.0}};
  const auto next = [&](double error) {
    return next_residual(f, i, shares, RawBound{{most, error}}, p, p, tau, drift, drift).bound.error;
  };
  const double fresh = next(0.0), kept = next(1.0) - fresh;
  return fresh / (1.0 - kept);
}

/// Error of joint i's residual, raw, where momenta and drifts are off by at most so much (SI).
template <class S, class Word, class Tuning>
constexpr double residual_error(int i, double momentum_error, double drift_error) {
  using T = Stored<Word>;
  return lagged_error<Tuning>(BoundedResidualFormats<S, Word, Tuning>{}, i,
                              momentum_error * power_of_two(MomentaOf<S, T>::exponent(i)),
                              drift_error * power_of_two(MomentumRatesOf<S, T>::exponent(i)));
}

}  // namespace detail

/// Error bounds of residuals, N m or N: how far they are from those that the observer's difference equation gives in
/// real numbers, of the same samples from the first on; words are taken as what they say.
template <class S, class T = Fixed32, class Tuning>
[[nodiscard]] constexpr auto error_bound(algorithm::MomentumObserver<Tuning>) {
  const auto momenta = error_bound<S, T>(algorithm::Momentum{}), drifts = error_bound<S, T>(algorithm::MomentumDrift{});
  return detail::bounds_of(detail::row_of<joint_count<S>>([&](int i) {
    return detail::residual_error<S, typename T::Word, Tuning>(i, momenta[i], drifts[i]) *
           WordRounding::ulp(Residuals<S, T, Tuning>::exponent(i));
  }));
}
/// Error bounds of a detector's comparison, N m or N: a residual in real numbers that is so far from its threshold is
/// on the same side of it in words.
template <class S, class T = Fixed32, class Tuning>
[[nodiscard]] constexpr auto error_bound(algorithm::CollisionDetector<Tuning>) {
  auto all = error_bound<S, T>(algorithm::MomentumObserver<Tuning>{});
  for (int i = 0; i < all.size; ++i)
    all.of[i] += 0.5 * WordRounding::ulp(Residuals<S, T, Tuning>::exponent(i));
  return all;
}

}  // namespace axial

#include <axial/options/end.hpp>
