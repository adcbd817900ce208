// Certified errors of the derivatives of inverse dynamics: their kernel, run on bounds; of drives that joints share
// what G makes of their words besides.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/derivatives/derivatives.hpp>
#include <axial/fixed/error_bound.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Exponents of a scene's derivatives.
template <class S, class T>
struct DerivativeExponents {
  static constexpr int mass(int i, int j) { return MassMatrixOf<S, T>::exponent(i, j); }
  static constexpr int position(int i, int j) { return JointMatrixOf<S, T, by::Position>::exponent(i, j); }
  static constexpr int velocity(int i, int j) { return JointMatrixOf<S, T, by::Velocity>::exponent(i, j); }
};

/// Errors of the derivatives of a scene S whose joints share drives, over words T.
template <class S, class T>
class DrivenSlopeErrors {
  using Word = typename T::Word;
  using Errors = DriveErrors<S, T>;
  using Sizes = DriveSizes<S, Word>;
  using Sum = RatioSum<Sizes::joints * Sizes::joints + 1>;
  static constexpr int size = joint_count<S>;

  template <class By, class Exponent, class Own>
  static constexpr bounds::EntryBounds<size> jacobian(By by, const bounds::EntryBounds<Sizes::joints>& joints,
                                                      const Own& own, const Exponent& exponent) {
    bounds::EntryBounds<size> all;
    Sum sums[size * size] = {};
    DrivenSlopeSizes<S, Word>::each_share(by, [&](int k, int l, int i, int j, double factor) {
      sums[k * size + l].add(factor, own(i, j), joints(i, j));
    });
    for (int k = 0; k < size; ++k)
      for (int l = 0; l < size; ++l) {
        Sum& sum = sums[k * size + l];
        if (k == l && std::is_same_v<By, by::Velocity> && Sizes::viscous(k) > 0.0) sum.terms.add_literal();
        all(k, l).error = sum.rounded(exponent(k, l), SharedDrives<S, T>::rounding);
      }
    return all;
  }

 public:
  /// Errors of M and of both Jacobians.
  bounds::DerivativeBounds<size> entries{};
  /// Errors of efforts, N m or N.
  Row<double, size> efforts{};

  /// All of them.
  static constexpr DrivenSlopeErrors found() {
    using Own = DerivativeExponents<typename Sizes::Joint, T>;
    using Exponents = DerivativeExponents<S, T>;
    const auto joints = Errors::joint_derivatives(Own{});
    const auto mass = Errors::entries_of([&](int i, int j) { return joints.entries.mass(i, j).error; });
    DrivenSlopeErrors all;
    for (int k = 0; k < size; ++k)
      for (int l = 0; l <= k; ++l)
        all.entries.mass(k, l).error = all.entries.mass(l, k).error = mass[k][l];
    all.entries.position = jacobian(by::Position{}, joints.entries.position, Own::position, Exponents::position);
    all.entries.velocity = jacobian(by::Velocity{}, joints.entries.velocity, Own::velocity, Exponents::velocity);
    all.efforts = Errors::efforts_of(joints.ranges, 0.0);
    return all;
  }
};

/// Errors of the entries of one matrix.
template <class Matrix, int N>
constexpr Matrix errors_in(const bounds::EntryBounds<N>& all) {
  Matrix errors{};
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      errors.set(i, j, all(i, j).error);
  return errors;
}

/// Errors of the entries and of efforts.
template <class S, class T>
constexpr auto found_slope_errors() {
  using Errors = ErrorsOf<S, T>;
  if constexpr (has_shared_drives<S>) {
    return DrivenSlopeErrors<S, T>::found();
  } else {
    const auto joints = Errors::joint_derivatives(DerivativeExponents<S, T>{});
    struct {
      bounds::DerivativeBounds<joint_count<S>> entries;
      Row<double, joint_count<S>> efforts;
    } all{joints.entries, Errors::efforts_of(joints.ranges, 0.0)};
    return all;
  }
}

}  // namespace detail

/// Error bounds of efforts, M and both Jacobians, each where inverse_dynamics_derivatives() has it, in its SI unit.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr InverseDynamicsDerivatives<S, double> error_bound(algorithm::InverseDynamicsDerivatives) {
  using Result = InverseDynamicsDerivatives<S, double>;
  static_assert((detail::check_bound<S, recursion::Derivatives>(), true));
  const auto found = detail::found_slope_errors<S, T>();
  const auto& all = found.entries;
  Result errors{};
  for (int i = 0; i < joint_count<S>; ++i)
    errors.tau[i] = found.efforts[i];
  errors.M = detail::errors_in<decltype(Result::M)>(all.mass);
  errors.dtau_dq = detail::errors_in<decltype(Result::dtau_dq)>(all.position);
  errors.dtau_dqd = detail::errors_in<decltype(Result::dtau_dqd)>(all.velocity);
  return errors;
}

}  // namespace axial

#include <axial/options/end.hpp>
