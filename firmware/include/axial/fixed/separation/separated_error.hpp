// Certified errors of separated terms and of the torque that is made of them: both kernels, run on bounds.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/error_bound.hpp>
#include <axial/fixed/separation/separated_torque.hpp>
#include <axial/fixed/transmissions/shared_drives_error.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Bounds of the terms of a scene S whose joints share drives, over words T.
template <class S, class T>
class DrivenTermErrors {
  using Word = typename T::Word;
  using Scene = scene_of<S>;
  using Sizes = DriveSizes<S, Word>;
  using Shares = driven::TermShares<Scene>;
  using Exponents = SeparatedExponents<S, T>;
  static constexpr int n = joint_count<S>;
  static constexpr const WordRounding& rounding = SharedDrives<S, T>::rounding;

  /// A coefficient of the drives on its way to its word.
  using Share = RatioSum<driven::inertia_share_count<Scene> + driven::rate_share_count<Scene> + Sizes::joints + 4>;

 public:
  /// Coefficients as they are stored.
  static constexpr bounds::SeparatedBounds<n> terms() {
    const auto joints = DriveErrors<S, T>::joint_terms();
    Share inertias[n][n] = {}, rates[n * n * n] = {};  // GCC 12 leaves out initialisers of members in three dimensions
    Shares::each_inertia(
        [&](const driven::Share& share) { inertias[share.k][share.l].add(share.factor, joints.A[share.i][share.j]); });
    Shares::each_rates([&](const driven::RateShare& share) {
      const auto& [i, j, p] = share.of;
      rates[(share.d * n + share.k) * n + share.l].add(share.factor,
                                                       j == p ? joints.C[i][j] : joints.B[i][joints.pair(j, p)]);
    });
    bounds::SeparatedBounds<n> all;
    for (int d = 0; d < n; ++d) {
      Share rest{};
      for (int i = 0; i < Sizes::joints; ++i)
        if (Shares::g.is_moved(i, d)) rest.add(Shares::g.ratio[i][d], joints.G[i]);
      all.G[d] = rest.stored(Exponents::rest(d), rounding);
      if (Sizes::rotor(d) > 0.0) inertias[d][d].bound.size += Sizes::rotor(d), inertias[d][d].terms.add_literal();
      for (int k = 0; k <= d; ++k)
        all.A[d][k] = all.A[k][d] = inertias[d][k].stored(Exponents::inertia(d, k), rounding);
      for (int k = 0; k < n; ++k) {
        all.C[d][k] = rates[(d * n + k) * n + k].stored(Exponents::square(d, k), rounding);
        for (int l = k + 1; l < n; ++l)
          all.B[d][all.pair(k, l)] = rates[(d * n + k) * n + l].stored(Exponents::product(d, k, l), rounding);
      }
    }
    return all;
  }
};

}  // namespace detail

namespace separation {

/// How the torque's words stand on bounds.
template <class Robot, class A>
struct BoundedTorqueWords {
  const WordRounding& rounding;  ///< of the arithmetic
  /// A coefficient in bounds.
  template <int E>
  static constexpr const bounds::Number& at(const bounds::Number& x) {
    return x;
  }
  /// qd_j qd_k, rounded once.
  template <int J, int K, class Rates>
  constexpr bounds::Number product(const Rates& qd) const {
    constexpr int exponent = TorqueWords<Robot, A>::template product_exponent<J, K>;
    bounds::NumberSum both = qd[J] * qd[K];
    both.bound.error += both.terms.rounding(exponent, rounding);
    return bounds::word_of(both.bound, exponent);
  }
};

/// Bounds of a scene's separated terms as they are stored, and of the torque that torque() makes of them.
template <class S, class T>
class BoundsOfTerms {
  using Scene = scene_of<S>;
  using A = detail::ArithmeticOf<Scene, typename T::Word>;
  static constexpr int n = joint_count<S>;
  static constexpr bool shared = detail::has_shared_drives<S>;
  using Parameters =
      std::conditional_t<shared, FullParameters, detail::with_rotors<Scene, parameters_of<Scene, BaseParameters>>>;

 public:
  /// Coefficients, by the kernel on bounds.
  static constexpr bounds::SeparatedBounds<n> terms() {
    if constexpr (shared)
      return detail::DrivenTermErrors<S, T>::terms();
    else
      return detail::JointErrors<S, T>::joint_terms();
  }
  /// Errors of efforts, of coefficients `s`.
  static constexpr Row<double, n> torque(const bounds::SeparatedBounds<n>& s) {
    const WordRounding rounding = rounding_in<Scene, A>();
    auto account = bounds::account_in_formats(mechanism_of<Scene, Parameters>, rounding, ranges());
    const bounds::detail::KernelStart<bounds::detail::NoLoads, n> start(account);
    const BoundedTorqueWords<typename scene_of<S>::Robot, A> words{rounding};
    Row<bounds::Number, n> tau{};
    sum_terms<S, T>(start.links, words, s, start.at.qd, start.at.qdd, tau);
    return detail::row_of<n>([&](int i) { return tau[i].bound.error; });
  }

 private:
  // Drives are links by themselves, with the formats of their efforts.
  static constexpr const Ranges<n>& ranges() {
    if constexpr (shared)
      return detail::DriveFormats<Scene, Parameters, A>::Table::value;
    else
      return detail::ranges_of<Scene, Parameters, A, recursion::Separation>;
  }
};

}  // namespace separation

/// Error bounds of separate(), each where Separated has it, in its SI unit.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr Separated<S, double> error_bound(algorithm::Separation) {
  static_assert((detail::check_bound<S, recursion::Separation>(), true));
  return detail::errors_of<S>(separation::BoundsOfTerms<S, T>::terms());
}
/// Error bounds of torque() from terms that separate() found, N m or N: the errors of the terms are in it.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr auto error_bound(algorithm::SeparatedTorque) {
  using Terms = separation::BoundsOfTerms<S, T>;
  static_assert((detail::check_bound<S, recursion::Separation>(), true));
  return detail::bounds_of(Terms::torque(Terms::terms()));
}

}  // namespace axial

#include <axial/options/end.hpp>
