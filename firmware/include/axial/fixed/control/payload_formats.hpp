// What the payload estimator rounds to in fixed point: formats from the declared limits.
#pragma once

#include <axial/control/payload_formats.hpp>
#include <axial/fixed/dynamics/kinematics.hpp>
#include <axial/fixed/limits/state_check.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

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

}  // namespace axial::detail

#include <axial/options/end.hpp>
