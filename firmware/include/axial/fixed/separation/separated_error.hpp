// Certified errors of separated terms and of the torque that is made of them: both kernels, run on bounds.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/error_bound.hpp>
#include <axial/fixed/separation/separated_torque.hpp>
#include <axial/fixed/transmissions/driven_separation_error.hpp>

#include <axial/options/begin.hpp>

namespace axial {
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
  using Parameters = detail::with_rotors<Scene, parameters_of<Scene, BaseParameters>>;
  static constexpr int n = joint_count<S>;
  static constexpr bool shared = detail::has_shared_drives<S>;

 public:
  /// Coefficients, by the kernel on bounds.
  static constexpr bounds::SeparatedBounds<n> terms() {
    if constexpr (shared)
      return detail::DrivenTermErrors<S, T>::terms();
    else
      return detail::JointErrors<S, T>::joint_terms();
  }
  /// Efforts, of coefficients `s`.
  static constexpr Row<bounds::Number, n> torque(const bounds::SeparatedBounds<n>& s) {
    const WordRounding rounding = rounding_in<Scene, A>();
    auto account = bounds::account_in_formats(mechanism(), rounding, ranges());
    const bounds::detail::KernelStart<bounds::detail::NoLoads, n> start(account);
    const BoundedTorqueWords<typename scene_of<S>::Robot, A> words{rounding};
    Row<bounds::Number, n> tau{};
    sum_terms<S, T>(start.links, words, s, start.at.qd, start.at.qdd, tau);
    return tau;
  }

 private:
  // Of the links, or of drives by themselves.
  static constexpr const auto& mechanism() {
    if constexpr (shared)
      return detail::DrivenTermErrors<S, T>::mechanism();
    else
      return mechanism_of<Scene, Parameters>;
  }
  static constexpr Ranges<n> ranges() {
    if constexpr (shared)
      return detail::DrivenTermErrors<S, T>::ranges();
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
  return detail::bounds_of(Terms::torque(Terms::terms()), [](const bounds::Number& x) { return x.bound.error; });
}

}  // namespace axial

#include <axial/options/end.hpp>
