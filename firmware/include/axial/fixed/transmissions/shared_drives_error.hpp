// Certified errors of what drives answer whose joints share them: G on bounds before and behind the kernels' own.
#pragma once

#include <axial/fixed/links/fixed_links.hpp>
#include <axial/transmissions/shared_drives.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Errors of a scene S whose joints share drives, over words T.
template <class S, class T>
class DriveErrors {
  using Word = typename T::Word;
  using Scene = scene_of<S>;
  using A = ArithmeticOf<Scene, Word>;
  using Sizes = DriveSizes<S, Word>;
  using Joint = typename Sizes::Joint;
  using JointRobot = typename Joint::Robot;
  static constexpr int joints = Sizes::joints, drives = joint_count<S>;
  static constexpr const auto& g = Sizes::g;
  static constexpr WordRounding rounding = rounding_in<Joint, A>();
  using Parameters = with_rotors<Joint, parameters_of<Joint, BaseParameters>>;
  using KinematicParameters = with_rotors<Joint, parameters_of<Joint, FullParameters>>;

  // A sum of words: as many as joints, or as pairs of them, and a drive's own.
  using Terms = bounds::TermsOf<joints*(joints + 1) / 2 + 4>;
  static constexpr void add(Terms& terms, double ratio, int exponent, double size) {
    if (magnitude(ratio) < 1.0 || magnitude(ratio) > 1.0)
      terms.add_scaled(ratio, exponent, size);
    else
      terms.add_word(exponent);
  }
  // Row i of G over words of drives, rounded as a joint's word.
  template <class From, class To>
  static constexpr double of_rates(int i, double LinkParameters::*limit, double word) {
    Terms terms;
    double given = 0.0;
    for (int k = 0; k < drives; ++k)
      if (g.is_moved(i, k)) {
        const int exponent = From::exponent(k);
        add(terms, g.ratio[i][k], exponent, Sizes::drive(k).*limit);
        given += magnitude(g.ratio[i][k]) * word * WordRounding::ulp(exponent);
      }
    return given + terms.rounding(To::exponent(i), rounding);
  }
  static constexpr double of_position(int i, double word) {
    constexpr WordRounding whole{32, true, false, 0.0};  // in any word
    const bool turns = JointRobot::chain.links[i].type == JointType::revolute;
    const double unit = turns ? bam_per_radian : 1.0;
    Terms terms;
    double given = 0.0;
    for (int k = 0; k < drives; ++k)
      if (g.is_moved(i, k)) {
        const double low = magnitude(Sizes::drive(k).position_min), high = magnitude(Sizes::drive(k).position_max);
        const int exponent = Positions<S, T>::exponent(k);
        add(terms, unit * g.ratio[i][k], exponent, low > high ? low : high);
        given += magnitude(g.ratio[i][k]) * word * WordRounding::ulp(exponent);
      }
    const bool offset = magnitude(g.offset[i]) > 0.0;
    if (offset && !turns) terms.add_literal();
    const double own = terms.rounding(Positions<JointRobot, T>::exponent(i), whole) + (offset && turns ? 0.5 : 0.0);
    return given + own / unit;
  }
  // The joints, with what their words are off; `word`: of a drive's words, in units.
  template <class P, class Role>
  static constexpr auto mechanism(double word, Role) {
    auto m = mechanism_of<Joint, P>;
    for (int i = 0; i < joints; ++i) {
      m.joints[i].effort_format = exponents_of<Joint, Word, Role>.of[i];
      m.joints[i].position_error = of_position(i, word);
      m.joints[i].speed_error =
          of_rates<Velocities<S, T>, Velocities<JointRobot, T>>(i, &LinkParameters::speed_limit, word);
      m.joints[i].acceleration_error =
          of_rates<Accelerations<S, T>, Accelerations<JointRobot, T>>(i, &LinkParameters::acceleration_limit, word);
    }
    return m;
  }
  // What drive k makes of joints: `of(i)` a Ball of a word at `from(i)`; its own rotor times words of drives at
  // `rotor`, of up to `most`, and its friction.
  template <class Of, class From>
  static constexpr double answer(int k, int exponent, const Of& of, const From& from, bool friction, double rotor,
                                 int rotor_exponent, double most, double word) {
    Terms terms;
    double error = 0.0;
    for (int i = 0; i < joints; ++i)
      if (g.is_moved(i, k)) {
        add(terms, g.ratio[i][k], from(i), Ball(of(i)).largest());
        error += magnitude(g.ratio[i][k]) * Ball(of(i)).error;
      }
    if (rotor > 0.0)
      terms.add_scaled(rotor, rotor_exponent, most), error += rotor * word * WordRounding::ulp(rotor_exponent);
    if (friction && Sizes::viscous(k) > 0.0) {
      const int speed = Velocities<S, T>::exponent(k);
      terms.add_scaled(Sizes::viscous(k), speed, Sizes::drive(k).speed_limit);
      error += Sizes::viscous(k) * word * WordRounding::ulp(speed);
    }
    if (friction && Sizes::coulomb(k) > 0.0) {
      const int effort = EffortsOf<S, T>::exponent(k);
      terms.add_word(effort), error += 0.5 * WordRounding::ulp(effort);
    }
    return error + terms.rounding(exponent, rounding);
  }
  static constexpr int joint_exponent(int i, int j) { return MassMatrixOf<Joint, T>::exponent(i, j); }
  template <class Of>
  static constexpr auto each_drive(const Of& of) {
    Row<double, drives> errors{};
    for (int k = 0; k < drives; ++k)
      errors[k] = of(k);
    return errors;
  }

 public:
  /// What bounds the joints' own quantities within the limits of the drives, with errors from what G makes of words.
  ///@{
  static constexpr auto joint_ranges(recursion::NewtonEuler, double word = 0.0) {
    return newton_euler_errors(mechanism<Parameters>(word, role::Effort{}), rounding,
                               ranges_of<Joint, Parameters, A, recursion::NewtonEuler>);
  }
  static constexpr auto joint_ranges(recursion::CompositeBodies) {
    return composite_body_ranges(mechanism<Parameters>(0.0, role::Effort{}), rounding, Wanted::errors);
  }
  static constexpr auto joint_ranges(recursion::Kinematics) {
    return kinematics_ranges(mechanism<KinematicParameters>(0.0, role::Effort{}), rounding);
  }
  ///@}
  /// Errors of efforts, N m or N; `word`: what words of drives are off by themselves, 0 or half a unit.
  static constexpr auto efforts(double word) { return efforts_of(joint_ranges(recursion::NewtonEuler{}, word), word); }
  /// Those of efforts of the joints that an analysis found.
  template <class Found>
  static constexpr auto efforts_of(const Found& found, double word) {
    return each_drive([&](int k) {
      return answer(
          k, EffortsOf<S, T>::exponent(k), [&](int i) { return found.range[i].joint_effort; },
          [](int i) { return EffortsOf<Joint, T>::exponent(i); }, true, Sizes::rotor(k),
          Accelerations<S, T>::exponent(k), Sizes::drive(k).acceleration_limit, word);
    });
  }
  /// Errors of momenta, N m s or N s.
  static constexpr auto momenta() {
    const auto found = momentum_ranges(mechanism<Parameters>(0.0, role::Momentum{}), rounding);
    return each_drive([&](int k) {
      return answer(
          k, MomentaOf<S, T>::exponent(k), [&](int i) { return found.range[i].joint_effort; },
          [](int i) { return MomentaOf<Joint, T>::exponent(i); }, false, Sizes::rotor(k), Velocities<S, T>::exponent(k),
          Sizes::drive(k).speed_limit, 0.0);
    });
  }
  /// Errors of the momenta's drifts, N m or N.
  static constexpr auto drifts() {
    const auto m = mechanism<Parameters>(0.0, role::Effort{});
    int exponents[joints] = {}, least = MomentumRatesOf<Joint, T>::exponent(0);
    for (int i = 0; i < joints; ++i)
      exponents[i] = MomentumRatesOf<Joint, T>::exponent(i), least = smaller(least, exponents[i]);
    for (int& exponent : exponents)
      exponent = Joint::template has<Looped> ? least : exponent;  // links that share formats round at one
    const auto found = bounds::drift_bounds(m, rounding, ranges_of<Joint, Parameters, A, recursion::NewtonEuler>,
                                            ranges_of<Joint, Parameters, A, recursion::Momenta>, exponents);
    return each_drive([&](int k) {
      return answer(
          k, MomentumRatesOf<S, T>::exponent(k), [&](int i) { return found[i]; },
          [](int i) { return MomentumRatesOf<Joint, T>::exponent(i); }, true, 0.0, 0, 0.0, 0.0);
    });
  }
  /// Errors of M's entries up to the diagonal.
  static constexpr auto entries() {
    const auto m = mechanism<Parameters>(0.0, role::Effort{});
    const auto& ranges = ranges_of<Joint, Parameters, A, recursion::CompositeBodies>;
    const auto found = bounds::mass_matrix_errors(m, rounding, ranges, joint_exponent);
    return entries_of([&](int i, int) { return found[i]; });
  }
  /// Those of M of the joints whose entries are off by own(i, j), i >= j.
  template <class Own>
  static constexpr auto entries_of(const Own& off) {
    using Links = decltype(links_of<S, T, BaseParameters, recursion::CompositeBodies>());
    Row<Row<double, drives>, drives> errors{};
    for (int k = 0; k < drives; ++k)
      for (int l = 0; l <= k; ++l) {
        Terms terms;
        double error = 0.0;
        driven::each_share_of<Links>([&](const driven::Share& share) {
          if (share.k != k || share.l != l) return;
          const double own = off(share.i, share.j);
          const double size =
              power_of_two(rounding.bits - 1 - joint_exponent(share.i, share.j));  // no more fits the word
          error += magnitude(share.factor) * own;
          add(terms, share.factor, joint_exponent(share.i, share.j), size);
        });
        if (k == l && Sizes::rotor(k) > 0.0) terms.add_literal();
        errors[k][l] = error + terms.rounding(MassMatrixOf<S, T>::exponent(k, l), rounding);
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
  /// Errors of the origins of the links' frames, m.
  static constexpr auto origins() {
    const auto found = joint_ranges(recursion::Kinematics{});
    Row<double, joints> errors{};
    for (int i = 0; i < joints; ++i)
      errors[i] = found.range[i].length.error;
    return errors;
  }
  /// Errors of the tool's pose.
  static constexpr auto tool() {
    return bounds::tool_error(mechanism<KinematicParameters>(0.0, role::Effort{}), rounding,
                              ranges_of<Joint, KinematicParameters, A, recursion::Kinematics>);
  }
  /// What drive k feels of words of the joints, `of(i)`, all at one exponent, rounded once with the headroom of
  /// columns; of a vector `components` is the square root of their number.
  template <class Of>
  static constexpr Ball at_actuator(int k, int exponent, double components, const WordRounding& r, const Of& of) {
    Terms terms;
    Ball whole{};
    for (int i = 0; i < joints; ++i)
      if (g.is_moved(i, k)) {
        const Ball own = of(i);
        whole.size += magnitude(g.ratio[i][k]) * own.size, whole.error += magnitude(g.ratio[i][k]) * own.error;
        add(terms, g.ratio[i][k], exponent, own.largest());
      }
    whole.error += components * terms.rounding(exponent - column_headroom<S>, r);
    return whole;
  }
  /// The joints as inverse dynamics has them, with what their words are off.
  static constexpr auto motion_mechanism() { return mechanism<Parameters>(0.0, role::Effort{}); }
  /// The joints as kinematics have them, with what their words are off.
  static constexpr auto kinematic_mechanism() { return mechanism<KinematicParameters>(0.0, role::Effort{}); }
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
  static constexpr auto jacobian() {
    const auto m = mechanism<KinematicParameters>(0.0, role::Effort{});
    const auto& ranges = ranges_of<Joint, KinematicParameters, A, recursion::Kinematics>;
    return by_drives(bounds::jacobian_bounds(m, rounding, ranges), ranges.format[0].length, rounding);
  }
  /// Errors of the linear part of the Jacobian's columns by drives.
  static constexpr auto columns() {
    const auto all = jacobian();
    return each_drive([&](int k) { return all.columns[k].linear.bound.whole.error; });
  }
};

/// Whether joints of a scene's robot share drives.
template <class S>
inline constexpr bool has_shared_drives = shares_drives_in<typename scene_of<S>::Robot>;

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
