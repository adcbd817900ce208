// The certified error of the equations that a payload estimator sums: its columns and their lag, run on bounds.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/bounds/kinematics.hpp>
#include <axial/fixed/control/observer_error.hpp>
#include <axial/fixed/control/payload_estimator.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace algorithm {
/// update_payload() of a tuning.
template <class Tuning>
struct PayloadEstimator {};
}  // namespace algorithm

/// How far the equation of each joint, residual = -(row . (mass, first moment)), is from the one in real numbers of the
/// same samples.
template <int N>
struct PayloadEquationBound {
  ErrorBound<N> mass;          ///< of the row's entry, N m or N per kg
  ErrorBound<N> first_moment;  ///< of each of the three others, N m or N per kg m
  ErrorBound<N> residual;      ///< of what stands opposite, N m or N

  /// What a payload of so much mass (kg) and |first moment| (kg m) makes of it: N m or N, to be compared with the
  /// deviation that the tuning gives the joint's residual.
  [[nodiscard]] constexpr ErrorBound<N> of(double kg, double moment) const {
    ErrorBound<N> all;
    for (int i = 0; i < N; ++i)
      all.of[i] = mass[i] * kg + first_moment[i] * bounds::detail::root3 * moment + residual[i];
    return all;
  }
};

namespace bounds {

/// A rotation's transpose, of words, times words: three products a component. Rows are off by so much each.
constexpr VectorSum transpose_times(const Rotation& r, const BoundedVector& v) {
  using detail::hypotenuse;
  const Ball turn{1.0, hypotenuse(hypotenuse(r.x.bound.whole.error, r.y.bound.whole.error), r.z.bound.whole.error)};
  const Ball whole = turn * v.bound.whole;
  VectorSum sum{{whole, whole, whole}, {}, {}};
  for (int i = 0; i < 3; ++i)
    sum.across.add_product(r.x.exponent + v.exponent), sum.along.add_product(r.x.exponent + v.exponent);
  return sum;
}

/// A payload's row of one joint.
struct PayloadRowBound {
  Ball mass{}, moment{};  ///< of the entry per kg; of the three per kg m together
};
/// Columns, as PayloadColumns has them.
template <int N>
struct PayloadColumnBounds {
  Row<PayloadRowBound, N> momentum{}, drift{};  ///< a row for each joint
};

/// Speeds of a robot's joints whose words are off by so much.
template <class R, int N>
struct SpeedsOf {
  Row<double, N> error{};  ///< rad/s or m/s
};

/// ColumnRounding in bounds: what it makes of words at its exponents.
template <class S, class Word>
struct PayloadColumnRounding {
  using F = axial::detail::ColumnRounding<S, Stored<Word>>;  ///< of words
  /// Sums after their one rounding, and what is rounded already brought to fewer digits.
  struct To {
    int exponent;                  ///< of what is kept
    const WordRounding* rounding;  ///< of the arithmetic
    /// A vector, each component rounded.
    constexpr BoundedVector operator()(const VectorSum& x) const {
      const double across = x.across.rounding(exponent, *rounding), along = x.along.rounding(exponent, *rounding);
      return {detail::with_rounding(x.bound, detail::root2 * across, along), exponent, false, rounding};
    }
    /// A number, rounded.
    constexpr Number operator()(const NumberSum& x) const {
      return word_of({x.bound.size, x.bound.error + x.terms.rounding(exponent, *rounding)}, exponent);
    }
  };
  using Turning = BoundedVector;  ///< angular velocities
  using Moving = BoundedVector;   ///< linear ones

  const WordRounding* rounding;  ///< of the arithmetic
  /// Each sum at its exponent of ColumnRounding.
  ///@{
  To turning{F::turning_exponent, rounding}, moving{F::moving_exponent, rounding}, slope{F::slope_exponent, rounding},
      momentum_along{F::momentum[0], rounding}, momentum_across{F::momentum[1], rounding},
      drift_along{F::drift[0], rounding}, drift_across{F::drift[1], rounding};
  ///@}

  /// Words as the Jacobian stored them: nothing is rounded.
  ///@{
  static constexpr const BoundedVector& direction(const BoundedVector& x) { return x; }
  static constexpr const BoundedVector& way(const BoundedVector& x) { return x; }
  ///@}
  /// The declared limit, shifted down to the coarsest speed's exponent, of a word that is off before.
  template <class R, int N>
  static constexpr Number speed(const SpeedsOf<R, N>& speeds, int i) {
    const bool shifted = F::Speeds::exponent(i) > F::speed_exponent;
    const double error = (shifted ? WordRounding::ulp(F::speed_exponent) : 0.0) + speeds.error[i];
    return word_of({R::chain.links[i].speed_limit, error}, F::speed_exponent);
  }
  /// Gravity in world axes, m/s^2: three constants as words.
  constexpr BoundedVector gravity() const {
    const double half = 0.5 * WordRounding::ulp(F::gravity_exponent);
    const Ball whole{F::weight, F::weight > 0.0 ? detail::root3 * half : 0.0};
    return {{whole, whole, whole}, F::gravity_exponent, false, rounding};
  }
  /// What a row holds.
  static constexpr PayloadRowBound row(const Number& mass, const BoundedVector& moment) {
    return {mass.bound, moment.bound.whole};
  }
};

/// A link's axes in the world, as its pose was computed.
template <int N>
constexpr Rotation axes_of(const Ranges<N>& ranges, int link, const WordRounding& rounding) {
  const Ball any{1.0, ranges.range[link].rotation.error};
  const BoundedVector row{{any, any, any}, rounding.bits - 2, false, &rounding};
  return {row, row, row};
}

/// The columns' bounds by joints, as far as the scene's drives take them.
template <class S, class Word>
constexpr auto payload_columns_of_joints() {
  using Errors = axial::detail::ErrorsOf<S, Stored<Word>>;
  using Joint = typename Errors::Joint;
  constexpr int n = joint_count<Joint>;
  SpeedsOf<robot_of<Joint>, n> speeds;
  const auto m = Errors::template mechanism<typename Errors::Full>();
  for (int i = 0; i < n; ++i)
    speeds.error[i] = m.joints[i].speed_error;
  PayloadColumnBounds<n> all;
  const PayloadColumnRounding<Joint, Word> rounding{&Errors::rounding};
  axial::detail::write_payload_columns(rounding, n, Errors::OfJoints::jacobian().columns,
                                       axes_of(Errors::joint_ranges(recursion::Kinematics{}), n - 1, Errors::rounding),
                                       speeds, all);
  return all;
}

/// The columns' bounds, inside the declared limits; of drives that joints share sums of those of the joints.
template <class S, class Word>
constexpr auto payload_columns() {
  const auto of_joints = payload_columns_of_joints<S, Word>();
  if constexpr (!axial::detail::has_shared_drives<S>) {
    return of_joints;
  } else {
    using Errors = axial::detail::DriveErrors<S, Stored<Word>>;
    using F = axial::detail::ColumnRounding<axial::detail::JointsOf<S>, Stored<Word>>;
    PayloadColumnBounds<joint_count<S>> all;
    const auto sum = [](const auto& from, auto& to, const int(&exponent)[2]) {
      for (int k = 0; k < joint_count<S>; ++k) {
        const auto at_drive = [&](int which, double components, Ball PayloadRowBound::*part) {
          return Errors::at_actuator(k, exponent[which], components, Errors::rounding,
                                     [&](int i) { return from[i].*part; });
        };
        to[k] = {at_drive(0, 1.0, &PayloadRowBound::mass), at_drive(1, detail::root3, &PayloadRowBound::moment)};
      }
    };
    sum(of_joints.momentum, all.momentum, F::momentum), sum(of_joints.drift, all.drift, F::drift);
    return all;
  }
}

}  // namespace bounds

namespace detail {

/// The factors of PayloadSums in bounds; no effort is among a payload's own.
template <class S, class Word, class Tuning>
struct BoundedPayloadFormats : BoundedLaggedFormats<Tuning, 4> {
  constexpr BoundedPayloadFormats() {
    using Sums = PayloadSums<S, Stored<Word>, Tuning>;
    for (int k = 0; k < 4; ++k)
      this->choose(k, Sums::formats, Sums::words(k));
  }
};

/// Error of entry k of the lagged row of `joint`, SI, as it is summed: its weight is a factor in 2^-31 that is off by
/// half a unit, and its product is rounded to nearest: one unit in all.
template <class S, class Word, class Tuning>
constexpr double payload_entry_error(int joint, int k, double momentum_error, double drift_error) {
  using F = ColumnRounding<S, Stored<Word>>;
  constexpr const auto& f = PayloadSums<S, Stored<Word>, Tuning>::formats;
  const double lagged = lagged_error<Tuning>(BoundedPayloadFormats<S, Word, Tuning>{}, k,
                                             momentum_error * power_of_two(F::momentum[k > 0]),
                                             drift_error * power_of_two(F::drift[k > 0]));
  return lagged * WordRounding::ulp(f.exponent[k]) + residual_deviation<S, Tuning>(joint) * WordRounding::ulp(f.row[k]);
}

}  // namespace detail

/// Error bounds of the equations that update_payload() sums, of an observer of the same tuning. What an estimate makes
/// of them depends on how well the motion tells the payload's parameters apart: that is its variance.
template <class S, class T = Fixed32, class Tuning>
[[nodiscard]] constexpr auto error_bound(algorithm::PayloadEstimator<Tuning>) {
  using Word = typename T::Word;
  constexpr int n = joint_count<S>;
  const auto columns = bounds::payload_columns<S, Word>();
  const auto residuals = error_bound<S, T>(algorithm::MomentumObserver<Tuning>{});
  constexpr const auto& f = detail::PayloadSums<S, T, Tuning>::formats;
  PayloadEquationBound<n> all;
  for (int i = 0; i < n; ++i) {
    const auto &p = columns.momentum[i], &d = columns.drift[i];
    all.mass.of[i] = detail::payload_entry_error<S, Word, Tuning>(i, 0, p.mass.error, d.mass.error);
    all.first_moment.of[i] = detail::payload_entry_error<S, Word, Tuning>(i, 1, p.moment.error, d.moment.error);
    all.residual.of[i] =
        residuals[i] + detail::residual_deviation<S, Tuning>(i) * WordRounding::ulp(f.residual_exponent);
  }
  return all;
}

}  // namespace axial

#include <axial/options/end.hpp>
