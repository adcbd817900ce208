// What the payload estimator sums: normal equations.
#pragma once

#include <axial/control/momentum_observer.hpp>
#include <axial/control/payload_columns.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// What a residual may be wrong by, N m or N.
template <class S, class Tuning>
constexpr double residual_deviation(int joint) {
  constexpr double share = Tuning::deviation > 0.0 ? Tuning::deviation : 1.0;  // update_payload() says what no share is
  const double most = scene_of<S>::Robot::chain.links[joint].effort_limit;
  return share * (is_bounded(most) ? most : 1.0);
}
/// Information in samples that the lag makes alike, as a share of that in as many without it.
template <class Tuning>
constexpr double sample_share() {
  return residual_share<Tuning>() / (2.0 - residual_share<Tuning>());
}

/// Lag, weights and forgetting of an estimator: floating point.
template <class S, class T, class Tuning>
struct PayloadSums {
  using Number = T;    ///< of estimates
  using Residual = T;  ///< of a joint
  struct Weights {
    T of[joint_count<S>] = {};
  };
  static constexpr Weights weights = [] {
    Weights all;
    constexpr double share = residual_share<Tuning>();
    for (int i = 0; i < joint_count<S>; ++i) {
      const double deviation = residual_deviation<S, Tuning>(i);
      all.of[i] = NumberTraits<T>::constant(share / ((2.0 - share) * deviation * deviation));
    }
    return all;
  }();
  /// Sum of the squares of a sample's numbers, made infinite where a sum of such samples could exceed a quarter of T's
  /// range: it weighs no more than so many of them, however many there were.
  struct Squares {
    static constexpr double samples = Tuning::memory / Tuning::period + 2.0;
    static constexpr T room = [] {
      T heaviest = T(1);
      for (const T& weight : weights.of)
        heaviest = weight > heaviest ? weight : heaviest;
      return T(4) * NumberTraits<T>::constant(samples) * heaviest;
    }();
    T sum = T(0);
    constexpr void add(const T& x) { sum += x * x; }
    constexpr T scaled() const { return room * sum; }
  };
  static constexpr T lagged(int, const T& r, const T& p, const T& p_last, const T& d, const T& d_last) {
    return next_residual<Tuning>(r, p, p_last, T(Zero{}), d, d_last);
  }
  static constexpr void forget(T& sum) {
    constexpr T kept = NumberTraits<T>::constant(Tuning::memory / (Tuning::memory + Tuning::period));
    sum *= kept;
  }
  static constexpr void add(T (&information)[4][4], T (&moment)[4], bool used, int joint, const PayloadRow<T>& y,
                            const T& r) {
    const T weight = select(used, weights.of[joint], T(Zero{}));
    for (int i = 0; i < 4; ++i) {
      const T scaled = weight * y.of[i];
      moment[i] -= scaled * r;
      for (int j = 0; j <= i; ++j)
        information[i][j] += scaled * y.of[j];
    }
  }
  static constexpr T chosen(bool first, const T& a, const T& b) { return select(first, a, b); }
  static constexpr const T& information(const T& sum, int, int) { return sum; }
  static constexpr const T& moment(const T& sum, int) { return sum; }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
