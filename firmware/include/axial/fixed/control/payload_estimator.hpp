// The payload estimator in fixed point: formats from the declared limits; sums in 96 bits, of an observer's
// residuals in their formats; the estimate as words.
#pragma once

#include <axial/control/payload_estimator.hpp>
#include <axial/fixed/control/momentum_observer.hpp>
#include <axial/fixed/dynamics/kinematics.hpp>
#include <axial/fixed/limits/state_check.hpp>
#include <axial/fixed/words/scaled.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

// Declared speeds add up to W; a column (a, b) of the Jacobian has |a| <= 1, |b| <= L, L >= 1 m being
// what the format of lengths holds. Hence |w| <= W, |v| <= L W, a column's rate (da, db) has |da| <= W, |db| <= 2 L W
// (db = wi x b + vi x a), and with momentum b.v and b x w + v x a, drift db.v + b.g and db x w + v x da + g x a:
//   momentum |along| <= L^2 W, |across| <= 2 L W, drift |along| <= 2 L^2 W^2 + L g, |across| <= 3 L W^2 + g.
// Each vector has one exponent for all joints, from its bound and a 1000th more: words are rounded to 2^-28 of their
// bounds or better, and less than 2^10 of them add up. Sums on the way are exact modulo 2^64, results fit.
template <class S, class Word>
struct JointColumnRounding {
  static_assert((check_weighing<Stored<Word>>(), true));
  using A = ArithmeticOf<scene_of<S>, Word>;
  using Speeds = Velocities<robot_of<S>, Stored<Word>>;
  static constexpr WordRounding rounding{32, true, false, 0.0};
  static constexpr int fitting(double most) { return rounding.exponent(1.001 * most); }
  static constexpr double all_speeds() {
    double sum = 0.0;
    for (const LinkParameters& link : detail::described_by<S>::chain.links)
      sum += link.speed_limit;
    return sum;
  }
  static constexpr int length = length_exponent<S, Stored<Word>>, speed_exponent = shared_exponent<Speeds>();
  static constexpr double L = power_of_two(31 - length), W = all_speeds();
  static constexpr Vec3<double> g = world_gravity<S>();
  static constexpr double weight = length_of(g.x, g.y, g.z);
  static constexpr int gravity_exponent = fitting(weight), turning_exponent = fitting(W),
                       moving_exponent = fitting(L * W), slope_exponent = fitting(2.0 * L * W);
  /// Exponents of the columns: along, then across.
  static constexpr int momentum[2] = {fitting(L * L * W), fitting(2.0 * L * W)},
                       drift[2] = {fitting(2.0 * L * L * W * W + L * weight), fitting(3.0 * L * W * W + weight)};
  static_assert(L >= 1.0);

  static constexpr auto direction(const Vec3<Stored<Word>>& x) { return in_format<A::unit, A>(x); }
  static constexpr auto way(const Vec3<Stored<Word>>& x) { return in_format<length, A>(x); }
  static constexpr Fx<speed_exponent, A> speed(const Speeds& qd, int i) {
    return {static_cast<Word>(qd[i].raw >> (Speeds::exponent(i) - speed_exponent))};
  }
  static constexpr Vec3<Fx<gravity_exponent, A>> gravity() {
    using N = NumberTraits<Fx<gravity_exponent, A>>;
    constexpr Vec3<Fx<gravity_exponent, A>> words{N::constant(g.x), N::constant(g.y), N::constant(g.z)};
    return words;
  }
  template <int E>
  struct To {
    template <class X>
    constexpr auto operator()(const X& x) const {
      if constexpr (is_vec3_v<X>)
        return Vec3{round_to<E>(x.x), round_to<E>(x.y), round_to<E>(x.z)};
      else
        return round_to<E>(x);
    }
  };
  template <int E, int H>
  static constexpr PayloadRow<Stored<Word>> row(const Fx<E, A>& mass, const Vec3<Fx<H, A>>& moment) {
    return {{{mass.raw}, {moment.x.raw}, {moment.y.raw}, {moment.z.raw}}};
  }
  using Turning = Vec3<Fx<turning_exponent, A>>;
  using Moving = Vec3<Fx<moving_exponent, A>>;
  static constexpr To<turning_exponent> turning{};
  static constexpr To<moving_exponent> moving{};
  static constexpr To<slope_exponent> slope{};
  static constexpr To<momentum[0]> momentum_along{};
  static constexpr To<momentum[1]> momentum_across{};
  static constexpr To<drift[0]> drift_along{};
  static constexpr To<drift[1]> drift_across{};
};

/// Of drives that joints share: sums of the joints' columns by G, with the bits that a Jacobian's need more.
template <class S, class Word>
struct DriveColumnRounding {
  using OfJoints = JointColumnRounding<JointsOf<S>, Word>;  ///< what is summed
  static constexpr int headroom = column_headroom<S>;
  /// Exponents of the columns: along, then across.
  static constexpr int momentum[2] = {OfJoints::momentum[0] - headroom, OfJoints::momentum[1] - headroom},
                       drift[2] = {OfJoints::drift[0] - headroom, OfJoints::drift[1] - headroom};
};

template <class S, class Word>
struct ColumnRounding<S, Stored<Word>>
    : std::conditional_t<shares_drives_in<typename scene_of<S>::Robot>, DriveColumnRounding<S, Word>,
                         JointColumnRounding<S, Word>> {};

// Whatever the words are that formats hold:
// - lagged rows take the exponent at which 2 momentum words / period + a drift word fit, as residuals do;
// - rows and residuals are divided by their joint's deviation, by a factor below 0.9995 in 2^-31, at exponents that
//   all joints share: |words| <= 0.9995 2^31 + 1;
// - a product of two is below 2^62 - 1, and so n joints add less than n 2^62 - n a sample to a sum that forgets 2^-s of
//   itself, rounded down: |sum| <= n 2^(62 + s) stays true, and n 2^s <= 2^32 keeps that in 96 bits.
template <class S, class Word, class Tuning>
struct PayloadSums<S, Stored<Word>, Tuning> {
  using T = Stored<Word>;
  using Number = Scaled;
  using Sum = integer::WideSum;
  static constexpr int n = joint_count<S>;

  struct Formats : LaggedFormats<Tuning, 4> {
    int row[4] = {}, residual_exponent = 0, memory = 0;
    std::int32_t row_factor[n] = {}, residual_factor[n] = {};
  };
  static constexpr LaggedWords words(int k) {
    using F = ColumnRounding<S, T>;
    return {F::momentum[k > 0], F::drift[k > 0]};
  }
  static constexpr Formats formats = [] {
    Formats all;
    for (int k = 0; k < 4; ++k)
      all.choose(k, words(k));
    int rows = -60, residuals = 60;  // powers of two below which factors fit
    for (int i = 0; i < n; ++i) {
      const double per = 1.0 / residual_deviation<S, Tuning>(i);
      const int own = Residuals<S, T, Tuning>::exponent(i);
      while (per * power_of_two(-rows) > 0.999)
        ++rows;
      while (per * power_of_two(residuals - own) > 0.999)
        --residuals;
    }
    for (int i = 0; i < n; ++i) {
      const double per = 1.0 / residual_deviation<S, Tuning>(i);
      all.row_factor[i] = Formats::factor(per * power_of_two(-rows));
      all.residual_factor[i] = Formats::factor(per * power_of_two(residuals - Residuals<S, T, Tuning>::exponent(i)));
    }
    for (int k = 0; k < 4; ++k)
      all.row[k] = all.exponent[k] - rows;
    all.residual_exponent = residuals;
    while (power_of_two(all.memory) * Tuning::period * 1.4142135623730951 < Tuning::memory)
      ++all.memory;
    return all;
  }();
  static_assert(formats.memory >= 2 && formats.memory <= 28 && n <= (std::int64_t{1} << (32 - formats.memory)),
                "axial: in fixed point a payload estimator's memory is 4 to 2^28 periods");

  /// Nothing overflows.
  struct Squares {
    constexpr void add(const T&) const {}
    constexpr Zero scaled() const { return {}; }
  };
  static constexpr T lagged(int k, const T& r, const T& p, const T& p_last, const T& d, const T& d_last) {
    return {
        next_residual(formats, k, shares_of<Tuning>(), r.raw, p.raw, p_last.raw, std::int32_t{0}, d.raw, d_last.raw)};
  }
  static constexpr void forget(Sum& sum) { sum.template forget<formats.memory>(); }
  static constexpr std::int32_t scaled(std::int32_t x, std::int32_t factor) {
    return static_cast<std::int32_t>((integer::multiply(x, factor) + (std::int64_t{1} << 30)) >> 31);
  }
  static constexpr void add(Sum (&information)[4][4], Sum (&moment)[4], bool used, int joint, const PayloadRow<T>& y,
                            const T& r) {
    const std::int32_t mask = -static_cast<std::int32_t>(used);
    const std::int32_t opposite = -scaled(r.raw, formats.residual_factor[joint]);
    std::int32_t row[4] = {};
    for (int i = 0; i < 4; ++i) {
      row[i] = scaled(y.of[i].raw, formats.row_factor[joint]) & mask;
      moment[i].add(integer::multiply(row[i], opposite));
      for (int j = 0; j <= i; ++j)
        information[i][j].add(integer::multiply(row[i], row[j]));
    }
  }
  static constexpr T chosen(bool first, const T& a, const T& b) {
    const auto mask = static_cast<Word>(-static_cast<int>(first));
    return {static_cast<Word>((a.raw & mask) | (b.raw & ~mask))};
  }
  static constexpr Scaled share = NumberTraits<Scaled>::constant(sample_share<Tuning>());
  static constexpr Scaled information(const Sum& sum, int i, int j) {
    return share * Scaled::of(sum, -formats.row[i] - formats.row[j]);
  }
  static constexpr Scaled moment(const Sum& sum, int i) {
    return share * Scaled::of(sum, -formats.row[i] - formats.residual_exponent);
  }
};

template <class Word>
struct PayloadSumOf<Stored<Word>> {
  using type = integer::WideSum;
};
template <class S, class Word, class Tuning>
struct ResidualInput<S, Stored<Word>, Tuning> {
  using type = Residuals<S, Stored<Word>, Tuning>;
};

}  // namespace detail

/// An estimate in fixed point: value = raw 2^-exponent. What the declared payload has no room for is held at the
/// largest word, and the status is payload_limit.
template <class S, class Word>
struct PayloadWords {
  using Formats = InputFormats<detail::described_by<S>, Stored<Word>>;  ///< of the scene's inputs
  static constexpr int mass_exponent = Formats::payload_mass;           ///< of the mass
  static constexpr int com_exponent = Formats::payload_com;             ///< of the centre of mass
  static constexpr int first_moment_exponent =
      Formats::of(Formats::load.mass * Formats::load.com_reach);  ///< of the first moment
  Stored<Word> mass{};                                            ///< kg
  Vec3<Stored<Word>> first_moment{};                              ///< kg m, about the last link's origin in its axes
  PayloadBody<Stored<Word>> body{};  ///< as the scene's Payload takes it: a body of no extent, or none
  Status status{};                   ///< of the estimate; payload_limit beyond the declared one
};

/// An estimate as words, cut to a unit. Constant time. The robot declares its payload_limit(). Feed-forward refuses a
/// body beyond that, as any other.
template <class S, class Word = std::int32_t>
[[nodiscard]] constexpr PayloadWords<S, Word> payload_words(const PayloadEstimate<Scaled>& estimate) {
  static_assert(sizeof(Word) == 4, "axial: payload words are of Fixed32");
  static_assert(detail::described_by<S>::chain.payload_limit.declared,
                "axial: a payload's words take their formats from the declared payload; add axial::payload_limit(mass, "
                "com_reach, inertia) to the robot's chain");
  using Words = PayloadWords<S, Word>;
  bool lost = false;
  const auto at = [&lost](int exponent, const Vec3<Scaled>& v) {
    return Vec3<Stored<Word>>{
        {v.x.as_word(exponent, lost)}, {v.y.as_word(exponent, lost)}, {v.z.as_word(exponent, lost)}};
  };
  Words words;
  words.mass.raw = estimate.mass.as_word(Words::mass_exponent, lost);
  words.first_moment = at(Words::first_moment_exponent, estimate.first_moment);
  const auto body = estimate.body();
  words.body.mass.raw = body.mass.as_word(Words::mass_exponent, lost);
  words.body.com = at(Words::com_exponent, body.com);
  const int beyond = select(estimate.status.ok() & lost, static_cast<int>(Status::Code::payload_limit),
                            static_cast<int>(estimate.status.code));
  words.status.code = static_cast<Status::Code>(beyond);
  return words;
}

}  // namespace axial

#include <axial/options/end.hpp>
