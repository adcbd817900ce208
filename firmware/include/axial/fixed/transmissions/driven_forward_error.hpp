// The certified error of forward dynamics of joints that share drives: what errors of M and of the bias do to the exact
// solution, by the energy norm and mobilities, and what the solve in words leaves
// (fixed/dynamics/driven_forward_dynamics.hpp).
#pragma once

#include <axial/fixed/formats/drive_units.hpp>
#include <axial/fixed/transmissions/shared_drives_error.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Errors of accelerations of drives of a scene S, over words T. With |v| = sqrt(v^T M v), |v[k]| <= mobility[k] |v|
/// and |M^-1 f| <= sum mobility |f|; words of M that are off by e change M by at most the sum of mobility e mobility,
/// relative to it.
template <class S, class T>
class DrivenForwardError {
  using Units = DriveUnits<S, typename T::Word>;
  using Sizes = DriveSizes<S, typename T::Word>;
  using Answers = typename Units::Answers;
  static constexpr int size = Units::size, most_lost = 2;  // M may lose half of what it resists by
  static constexpr const auto& u = drive_units<S, typename T::Word>;

 public:
  /// rad/s^2 or m/s^2, where efforts are within the declared ones.
  static constexpr auto accelerations() {
    DrivenForwardError found;
    return row_of<size>([&](int k) {
      return found.known() ? Sizes::mobility(k) * found.energy() + WordRounding::ulp(Answers::exponent(k))
                           : unknown_size;
    });
  }

 private:
  double relative_ = 0.0, efforts_ = 0.0, residual_ = 0.0, rounding_ = 0.0, scaled_ = 0.0, eliminated_ = 0.0,
         substituted_ = 0.0;

  constexpr DrivenForwardError() {
    if (!u.resisted) return;
    const auto entries = DriveErrors<S, T>::entries();
    const auto bias = DriveErrors<S, T>::efforts(0.0);
    int normed = 0;
    double mobile = 0.0, gains = 2.0;
    for (int k = 0; k < size; ++k) {
      for (int l = 0; l <= k; ++l)
        relative_ += (k == l ? 1.0 : 2.0) * Sizes::mobility(k) * Sizes::mobility(l) * entries[k][l];
      efforts_ += Sizes::mobility(k) * bias[k];
      residual_ += Sizes::mobility(k) * size * WordRounding::ulp(u.residual[k]);
      rounding_ += square_root(Sizes::inertia(k)) * WordRounding::ulp(Answers::exponent(k));
      mobile += u.mobility[k], gains += power_of_two(u.gain_bits[k]) + 4.0;
      substituted_ += size * u.mobility[k] + (size + 2.0) * power_of_two(u.gain_bits[k]);
      normed = u.norm_bits[k] > normed ? u.norm_bits[k] : normed;
    }
    const double unit = WordRounding::ulp(Units::bits);
    // An entry of M' is rounded once into its word; each pivot takes a rounded product by a rounded gain.
    eliminated_ = gains * unit * mobile * mobile;
    // Some word of the right-hand side has its first bit set, so that its norm is 2^-(normed + 1) at least.
    substituted_ *= unit * power_of_two(normed + 1);
  }
  constexpr bool known() const { return u.resisted && most_lost * (relative_ + eliminated_) < 1.0; }
  // What one solve leaves of an error, relative to it; M in words resists by most_lost less at most.
  constexpr double left_by_a_solve() const {
    return (most_lost * eliminated_ + substituted_) / (1.0 - most_lost * eliminated_);
  }
  constexpr double energy() const {
    const double left = left_by_a_solve();
    double error = most_lost * Sizes::energy();
    for (int s = 1; s < Units::solves; ++s)
      error = left * error + most_lost * (residual_ + rounding_);
    return (efforts_ + relative_ * Sizes::energy()) / (1.0 - relative_) + left * error + most_lost * residual_;
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
