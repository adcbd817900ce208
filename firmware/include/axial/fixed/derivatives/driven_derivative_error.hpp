// Certified errors of the derivatives of drives that joints share: those of the joints' entries, and what G makes of
// their words.
#pragma once

#include <axial/fixed/derivatives/derivatives.hpp>
#include <axial/fixed/transmissions/shared_drives_error.hpp>

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
  using Terms = bounds::TermsOf<Sizes::joints * Sizes::joints + 1>;
  static constexpr int size = joint_count<S>;

  template <class By, class Exponent, class Own>
  static constexpr bounds::EntryBounds<size> jacobian(By by, const bounds::EntryBounds<Sizes::joints>& joints,
                                                      const Own& own, const Exponent& exponent) {
    bounds::EntryBounds<size> all;
    Terms terms[size * size] = {};
    DrivenSlopeSizes<S, Word>::each_share(by, [&](int k, int l, int i, int j, double factor) {
      const Ball& entry = joints(i, j);
      Terms& sum = terms[k * size + l];
      all(k, l).error += magnitude(factor) * entry.error;
      SharedDrives<S, T>::add(sum, factor, own(i, j), entry.largest());
    });
    for (int k = 0; k < size; ++k)
      for (int l = 0; l < size; ++l) {
        Terms& sum = terms[k * size + l];
        if (k == l && std::is_same_v<By, by::Velocity> && Sizes::viscous(k) > 0.0) sum.add_literal();
        all(k, l).error += sum.rounding(exponent(k, l), SharedDrives<S, T>::rounding);
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

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
