// Certified errors of what joints answer: their kernels run on bounds, of joint values that may be off themselves.
#pragma once

#include <axial/dynamics/momentum.hpp>
#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/links/separated_terms.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// A number of each joint or drive: of(i).
template <int N, class Of>
constexpr Row<double, N> row_of(const Of& of) {
  Row<double, N> row{};
  for (int i = 0; i < N; ++i)
    row[i] = of(i);
  return row;
}

/// Where each joint has a drive of its own: joint values are off by `word` units of their words.
template <class S, class T>
struct OwnDrives {
  using Joint = scene_of<S>;                    ///< the scene of the joints
  static constexpr bool moves_as_asked = true;  ///< whether joint values are exact where those of drives are

  /// The robot as an analysis sees it, with the formats of its efforts or of what stands for them where it asks.
  template <class Parameters, class Role = void>
  static constexpr auto mechanism(double word = 0.0) {
    using R = robot_of<S>;
    auto m = [] {
      if constexpr (std::is_void_v<Role>)
        return mechanism_of<Joint, Parameters>;
      else
        return loaded_mechanism<Joint, Parameters, typename T::Word, Role>();
    }();
    const double angle = (word + power_of_two(-20)) / bam_per_radian;
    for (int i = 0; i < joint_count<S> && word > 0.0; ++i) {
      const bool turns = R::chain.links[i].type == JointType::revolute;
      m.joints[i].position_error = turns ? angle : word * WordRounding::ulp(Positions<R, T>::exponent(i));
      m.joints[i].speed_error = word * WordRounding::ulp(Velocities<R, T>::exponent(i));
      m.joints[i].acceleration_error = word * WordRounding::ulp(Accelerations<R, T>::exponent(i));
    }
    return m;
  }
  /// What drives answer in the words of a role is what joints do.
  template <class Role, class Of>
  static constexpr auto answers(const Of& of, double) {
    return row_of<joint_count<S>>([&](int i) { return Ball(of(i)).error; });
  }
};

/// Errors of a scene S over words T, whose joints `Drives` move; `word`: what words are off by, 0 or half a unit.
template <class S, class T, class Drives = OwnDrives<S, T>>
struct JointErrors {
  using OfJoints = JointErrors;
  using A = ArithmeticOf<scene_of<S>, typename T::Word>;
  using Joint = typename Drives::Joint;
  static constexpr int joints = joint_count<Joint>;
  static constexpr WordRounding rounding = rounding_in<Joint, A>();
  using Base = with_rotors<Joint, parameters_of<Joint, BaseParameters>>;
  using Full = with_rotors<Joint, parameters_of<Joint, FullParameters>>;
  template <class Recursion, class Parameters = Base>
  static constexpr decltype((ranges_of<Joint, Parameters, A, Recursion>)) ranges =
      ranges_of<Joint, Parameters, A, Recursion>;  // by `const auto&` Clang 14 deduces it anew at each use
  template <class Parameters, class Role = void>
  static constexpr auto mechanism(double word = 0.0) {
    return Drives::template mechanism<Parameters, Role>(word);
  }

  /// What bounds the joints' own quantities, with the errors of what moves them.
  ///@{
  static constexpr auto joint_ranges(recursion::NewtonEuler, double word = 0.0) {
    if (Drives::moves_as_asked && !(word > 0.0)) return ranges<recursion::NewtonEuler>;
    return newton_euler_errors(mechanism<Base, role::Effort>(word), rounding, ranges<recursion::NewtonEuler>);
  }
  static constexpr auto joint_ranges(recursion::CompositeBodies) {
    return composite_body_ranges(mechanism<Base, role::Effort>(), rounding);
  }
  static constexpr auto joint_ranges(recursion::Momenta) {
    if constexpr (Drives::moves_as_asked)
      return ranges<recursion::Momenta>;
    else
      return momentum_ranges(mechanism<Base, role::Momentum>(), rounding);
  }
  static constexpr auto joint_ranges(recursion::Kinematics) {
    if constexpr (Drives::moves_as_asked)
      return ranges<recursion::Kinematics, Full>;
    else
      return kinematics_ranges(mechanism<Full>(), rounding);
  }
  ///@}
  /// Errors of efforts, N m or N.
  static constexpr auto efforts(double word) { return efforts_of(joint_ranges(recursion::NewtonEuler{}, word), word); }
  /// Those of efforts of the joints that an analysis found.
  template <class Found>
  static constexpr auto efforts_of(const Found& found, double word) {
    return Drives::template answers<role::Effort>([&](int i) { return found.range[i].joint_effort; }, word);
  }
  /// Errors of momenta, N m s or N s.
  static constexpr auto momenta() {
    const auto found = joint_ranges(recursion::Momenta{});
    return Drives::template answers<role::Momentum>([&](int i) { return found.range[i].joint_effort; }, 0.0);
  }
  /// Errors of the momenta's drifts, N m or N.
  static constexpr auto drifts() {
    using Rates = MomentumRatesOf<Joint, T>;
    int exponents[joints] = {};
    for (int i = 0; i < joints; ++i)  // links that share formats round at one
      exponents[i] = Joint::template has<Looped> ? shared_exponent<Rates>() : Rates::exponent(i);
    const auto found = bounds::drift_bounds(mechanism<Base>(), rounding, ranges<recursion::NewtonEuler>,
                                            ranges<recursion::Momenta>, exponents);
    return Drives::template answers<role::MomentumRate>([&](int i) { return found[i]; }, 0.0);
  }
  /// Errors of M's entries up to the diagonal, row by row.
  static constexpr auto rows() {
    return bounds::mass_matrix_errors(mechanism<Base>(), rounding, ranges<recursion::CompositeBodies>,
                                      [](int i, int j) { return MassMatrixOf<Joint, T>::exponent(i, j); });
  }
  /// Errors of the origins of the links' frames, m.
  static constexpr auto origins() {
    const auto found = joint_ranges(recursion::Kinematics{});
    return row_of<joints>([&](int i) { return found.range[i].length.error; });
  }
  /// Errors of the tool's pose.
  static constexpr auto tool() {
    return bounds::tool_error(mechanism<Full>(), rounding, ranges<recursion::Kinematics, Full>);
  }
  /// Bounds of the Jacobian's columns.
  static constexpr auto jacobian() {
    return bounds::jacobian_bounds(mechanism<Full>(), rounding, ranges<recursion::Kinematics, Full>);
  }
  /// Errors of the linear part of its columns.
  static constexpr auto columns() { return columns_of(jacobian()); }
  template <int N>
  static constexpr auto columns_of(const bounds::JacobianBounds<N>& all) {
    return row_of<N>([&](int i) { return all.columns[i].linear.bound.whole.error; });
  }
  static constexpr int length_format() { return ranges<recursion::Kinematics, Full>.format[0].length; }
  /// Bounds of separated terms as the joints have them.
  static constexpr auto joint_terms() {
    return bounds::separated_bounds(mechanism<Base>(), rounding, ranges<recursion::Separation>,
                                    SeparatedExponents<Joint, T>::all());
  }
  /// Bounds of the joints' derivatives, each rounded into its exponent.
  template <class Exponents>
  static constexpr auto joint_derivatives(const Exponents& exponents) {
    return bounds::derived(mechanism<Base, role::Effort>(), rounding, ranges<recursion::Derivatives>, exponents);
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
