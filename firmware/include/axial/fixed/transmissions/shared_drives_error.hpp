// Certified errors of what drives answer whose joints share them: G on bounds before and behind the kernels' own.
#pragma once

#include <axial/fixed/transmissions/joint_errors.hpp>
#include <axial/transmissions/shared_drives.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// A sum of up to `most` words times constants, in bounds, before it is rounded once.
template <int most>
struct RatioSum {
  Ball bound{};                   ///< of the sum
  bounds::TermsOf<most> terms{};  ///< of its rounding

  /// A word at an exponent, of such a size and off by `error`.
  constexpr void add(double ratio, int exponent, double size, double error) {
    bound.size += magnitude(ratio) * size, bound.error += magnitude(ratio) * error;
    add_term(ratio, exponent, size);
  }
  constexpr void add(double ratio, int exponent, const Ball& of) {
    bound.size += magnitude(ratio) * of.size, bound.error += magnitude(ratio) * of.error;
    add_term(ratio, exponent, of.largest());
  }
  constexpr void add(double ratio, const bounds::Number& of) { add(ratio, of.exponent, of.bound); }
  /// The sum as a word at an exponent.
  [[nodiscard]] constexpr bounds::Number stored(int exponent, const WordRounding& r) const {
    return bounds::word_of({bound.size, rounded(exponent, r)}, exponent);
  }
  /// How far it is off then.
  [[nodiscard]] constexpr double rounded(int exponent, const WordRounding& r) const {
    return bound.error + terms.rounding(exponent, r);
  }

 private:
  constexpr void add_term(double ratio, int exponent, double size) {
    if (magnitude(ratio) < 1.0 || magnitude(ratio) > 1.0)
      terms.add_scaled(ratio, exponent, size);
    else
      terms.add_word(exponent);
  }
};

/// Where joints share drives: what G makes of words of drives, and of words of joints.
template <class S, class T>
class SharedDrives {
  using Word = typename T::Word;
  using Sizes = DriveSizes<S, Word>;
  using JointRobot = typename Sizes::Joint::Robot;
  static constexpr int joints = Sizes::joints, drives = joint_count<S>;
  static constexpr const auto& g = Sizes::g;

 public:
  using Joint = typename Sizes::Joint;
  static constexpr bool moves_as_asked = false;
  static constexpr WordRounding rounding = rounding_in<Joint, ArithmeticOf<scene_of<S>, Word>>();

  // A sum of words: as many as joints, or as pairs of them, and a drive's own.
  using Sum = RatioSum<joints*(joints + 1) / 2 + 4>;

 private:
  // Row i of G over words of drives, rounded as a joint's word.
  template <class From, class To>
  static constexpr double of_rates(int i, double LinkParameters::*limit, double word) {
    Sum sum;
    for (int k = 0; k < drives; ++k)
      if (g.is_moved(i, k)) {
        const int exponent = From::exponent(k);
        sum.add(g.ratio[i][k], exponent, Sizes::drive(k).*limit, word * WordRounding::ulp(exponent));
      }
    return sum.rounded(To::exponent(i), rounding);
  }
  static constexpr double of_position(int i, double word) {
    constexpr WordRounding whole{32, true, false, 0.0};  // in any word
    const bool turns = JointRobot::chain.links[i].type == JointType::revolute;
    const double unit = turns ? bam_per_radian : 1.0;
    Sum sum;
    double given = 0.0;
    for (int k = 0; k < drives; ++k)
      if (g.is_moved(i, k)) {
        const double low = magnitude(Sizes::drive(k).position_min), high = magnitude(Sizes::drive(k).position_max);
        const int exponent = Positions<S, T>::exponent(k);
        sum.add(unit * g.ratio[i][k], exponent, low > high ? low : high, 0.0);
        given += magnitude(g.ratio[i][k]) * word * WordRounding::ulp(exponent);
      }
    const bool offset = magnitude(g.offset[i]) > 0.0;
    if (offset && !turns) sum.terms.add_literal();
    const double own = sum.rounded(Positions<JointRobot, T>::exponent(i), whole) + (offset && turns ? 0.5 : 0.0);
    return given + own / unit;
  }

 public:
  /// The joints, with what their words are off.
  template <class P, class Role>
  static constexpr auto mechanism(double word) {
    auto m = mechanism_of<Joint, P>;
    for (int i = 0; i < joints; ++i) {
      if constexpr (!std::is_void_v<Role>) m.joints[i].effort_format = exponents_of<Joint, Word, Role>.of[i];
      m.joints[i].position_error = of_position(i, word);
      m.joints[i].speed_error =
          of_rates<Velocities<S, T>, Velocities<JointRobot, T>>(i, &LinkParameters::speed_limit, word);
      m.joints[i].acceleration_error =
          of_rates<Accelerations<S, T>, Accelerations<JointRobot, T>>(i, &LinkParameters::acceleration_limit, word);
    }
    return m;
  }
  /// What each drive makes of joints, `of(i)` a Ball of a word of a role: with its own rotor, and its friction.
  template <class Role, class Of>
  static constexpr Row<double, drives> answers(const Of& of, double word) {
    return row_of<drives>([&](int k) { return answer<Role>(k, of, word); });
  }

 private:
  template <class Role, class Of>
  static constexpr double answer(int k, const Of& of, double word) {
    constexpr bool is_momentum = std::is_same_v<Role, role::Momentum>;
    using Rates = std::conditional_t<is_momentum, Velocities<S, T>, Accelerations<S, T>>;
    Sum sum;
    for (int i = 0; i < joints; ++i)
      if (g.is_moved(i, k)) sum.add(g.ratio[i][k], exponents_of<Joint, Word, Role>.of[i], Ball(of(i)));
    auto& terms = sum.terms;
    double& error = sum.bound.error;
    if (!std::is_same_v<Role, role::MomentumRate> && Sizes::rotor(k) > 0.0) {
      const LinkParameters& drive = Sizes::drive(k);
      terms.add_scaled(Sizes::rotor(k), Rates::exponent(k), is_momentum ? drive.speed_limit : drive.acceleration_limit);
      error += Sizes::rotor(k) * word * WordRounding::ulp(Rates::exponent(k));
    }
    if (!is_momentum && Sizes::viscous(k) > 0.0) {
      const int speed = Velocities<S, T>::exponent(k);
      terms.add_scaled(Sizes::viscous(k), speed, Sizes::drive(k).speed_limit);
      error += Sizes::viscous(k) * word * WordRounding::ulp(speed);
    }
    if (!is_momentum && Sizes::coulomb(k) > 0.0) {
      const int effort = EffortsOf<S, T>::exponent(k);
      terms.add_word(effort), error += 0.5 * WordRounding::ulp(effort);
    }
    return sum.rounded(exponents_of<S, Word, Role>.of[k], rounding);
  }
};

/// Errors of a scene S whose joints share drives, over words T.
template <class S, class T>
struct DriveErrors : JointErrors<S, T, SharedDrives<S, T>> {
  using Shared = SharedDrives<S, T>;
  using Joints = JointErrors<S, T, Shared>;
  using Sizes = DriveSizes<S, typename T::Word>;
  using Sum = typename Shared::Sum;
  using Joints::joints;
  using Joints::rounding;
  using typename Joints::Joint;
  static constexpr int drives = joint_count<S>;
  static constexpr const auto& g = Sizes::g;
  static constexpr int joint_exponent(int i, int j) { return MassMatrixOf<Joint, T>::exponent(i, j); }

  /// Errors of M's entries up to the diagonal.
  static constexpr auto entries() {
    const auto found = Joints::rows();
    return entries_of([&](int i, int) { return found[i]; });
  }
  /// Those of M of the joints whose entries are off by own(i, j), i >= j.
  template <class Own>
  static constexpr auto entries_of(const Own& off) {
    using Links = decltype(links_of<S, T, BaseParameters, recursion::CompositeBodies>());
    Row<Row<double, drives>, drives> errors{};
    for (int k = 0; k < drives; ++k)
      for (int l = 0; l <= k; ++l) {
        Sum sum;
        driven::each_share_of<Links>([&](const driven::Share& share) {
          if (share.k != k || share.l != l) return;
          const int exponent = joint_exponent(share.i, share.j);
          const double size = power_of_two(rounding.bits - 1 - exponent);  // no more fits the word
          sum.add(share.factor, exponent, size, off(share.i, share.j));
        });
        if (k == l && Sizes::rotor(k) > 0.0) sum.terms.add_literal();
        errors[k][l] = sum.rounded(MassMatrixOf<S, T>::exponent(k, l), rounding);
      }
    return errors;
  }
  /// Errors of M, row by row.
  static constexpr auto rows() {
    const auto all = entries();
    Row<double, drives> errors{};
    for (int k = 0; k < drives; ++k)
      for (int l = 0; l <= k; ++l)
        if (all[k][l] > errors[k]) errors[k] = all[k][l];
    return errors;
  }
  /// What drive k feels of words of the joints, `of(i)`, all at one exponent, rounded once with the headroom of
  /// columns; of a vector `components` is the square root of their number.
  template <class Of>
  static constexpr Ball at_actuator(int k, int exponent, double components, const WordRounding& r, const Of& of) {
    Sum sum;
    for (int i = 0; i < joints; ++i)
      if (g.is_moved(i, k)) sum.add(g.ratio[i][k], exponent, Ball(of(i)));
    sum.bound.error += components * sum.terms.rounding(exponent - column_headroom<S>, r);
    return sum.bound;
  }
  /// Bounds of the Jacobian's columns by drives, from those by joints; `lengths` is the exponent of the latter.
  static constexpr bounds::JacobianBounds<drives> by_drives(const bounds::JacobianBounds<joints>& found, int lengths,
                                                            const WordRounding& r) {
    bounds::JacobianBounds<drives> all{};
    const auto sum = [&](int k, bounds::BoundedVector bounds::BoundedMotion::*part, int exponent) {
      const Ball whole =
          at_actuator(k, exponent, root3, r, [&](int i) { return Ball((found.columns[i].*part).bound.whole); });
      return bounds::detail::anywhere(whole, exponent - column_headroom<S>, &r);
    };
    for (int k = 0; k < drives; ++k) {
      all.columns[k].angular = sum(k, &bounds::BoundedMotion::angular, r.bits - 2);
      all.columns[k].linear = sum(k, &bounds::BoundedMotion::linear, lengths);
    }
    return all;
  }
  /// Bounds of the Jacobian of the scene.
  static constexpr auto jacobian() { return by_drives(Joints::jacobian(), Joints::length_format(), rounding); }
  /// Errors of the linear part of its columns.
  static constexpr auto columns() { return Joints::columns_of(jacobian()); }
};

/// Whether joints of a scene's robot share drives.
template <class S>
inline constexpr bool has_shared_drives = shares_drives_in<typename scene_of<S>::Robot>;
/// Errors of a scene, whoever moves its joints.
template <class S, class T>
using ErrorsOf = std::conditional_t<has_shared_drives<S>, DriveErrors<S, T>, JointErrors<S, T>>;

}  // namespace axial::detail

#include <axial/options/end.hpp>
