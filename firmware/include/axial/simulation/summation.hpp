// How numbers are summed over time: what an integrator adds to positions and velocities, and which states it keeps.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/links/soundness.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// x + rest += dx, with x the sum rounded and rest what that left.
template <class T>
AXIAL_INLINE constexpr void add_exactly(T& x, T& rest, const T& dx) {
  const T y = dx + rest;
  const T sum = x + y;
  const T of_y = sum - x;
  rest = (x - (sum - of_y)) + (y - of_y);
  x = sum;
}

/// Sums of float and double. Numbers with formats specialise it (fixed/simulation/integrators.hpp); X is the motion
/// that is moved, `rates` one rate or the four slopes of a Runge-Kutta step, then with a sixth of the step.
template <class S, class T>
struct Summation {
  /// whether T is summed: float, double, what counts operations
  static constexpr bool is_there =
      is_number_v<T> && !is_word<T> && !std::is_integral_v<T> && std::is_same_v<Lane<T>, T>;
  using Step = T;  ///< a step of time, s
  using Time = T;  ///< s since step 0
  /// Parts of a step.
  ///@{
  AXIAL_INLINE static constexpr T half(const T& h) { return h * constant(0.5); }
  AXIAL_INLINE static constexpr T sixth(const T& h) { return h / constant(6.0); }
  ///@}
  /// Seconds after that many steps of h and half steps, rounded twice, however many there were.
  AXIAL_INLINE static constexpr T time(std::uint64_t steps, const T& h, int halves) {
    const T whole = number(steps + static_cast<std::uint64_t>(halves / 2)) * h;
    return halves % 2 == 0 ? whole : whole + half(h);
  }
  /// f(i) for every joint.
  template <class F>
  AXIAL_INLINE static constexpr void each(int joints, const F& f) {
    for (int i = 0; i < joints; ++i)
      f(i);
  }
  /// qd_i += h rate, q_i += h rate.
  ///@{
  template <class X, class... Rates>
  AXIAL_INLINE static constexpr void add_velocity(X& x, int i, const T& h, const Rates&... rates) {
    if constexpr (X::is_compensated)
      add_exactly(x.qd[i], x.qd_rest[i], T(h * total(rates[i]...)));
    else
      x.qd[i] = x.qd[i] + h * total(rates[i]...);
  }
  template <class X, class... Rates>
  AXIAL_INLINE static constexpr void add_position(X& x, int i, const T& h, const Rates&... rates) {
    if constexpr (X::is_compensated)
      add_exactly(x.q[i], x.q_rest[i], T(h * total(rates[i]...)));
    else
      x.q[i] = x.q[i] + h * total(rates[i]...);
  }
  ///@}
  /// qd_i = speed.
  template <class X>
  AXIAL_INLINE static constexpr void set_velocity(X& x, int i, const T& speed) {
    x.qd[i] = speed;
    if constexpr (X::is_compensated) x.qd_rest[i] = constant(0.0);
  }
  /// to_i = from_i - Coefficient::of(i) rate_i; whether it does not fit.
  template <class Coefficient, class To, class From, class Rate>
  AXIAL_INLINE static constexpr bool subtract(To& to, const From& from, const Rate& rate, int i) {
    to[i] = from[i] - constant(Coefficient::of(i)) * rate[i];
    return false;
  }
  /// Joint i of `moved` into x, or nothing.
  template <class X>
  AXIAL_INLINE static constexpr void keep_joint(bool keep, const X& moved, X& x, int i) {
    x.q[i] = select(keep, moved.q[i], x.q[i]), x.qd[i] = select(keep, moved.qd[i], x.qd[i]);
    if constexpr (X::is_compensated) {
      x.q_rest[i] = select(keep, moved.q_rest[i], x.q_rest[i]);
      x.qd_rest[i] = select(keep, moved.qd_rest[i], x.qd_rest[i]);
    }
  }
  /// What is wrong with a state that a step of h led to.
  template <class X>
  AXIAL_INLINE static constexpr Status judged(const X& x, const T&, int joints) {
    Soundness<T> all;
    each(joints, [&](int i) AXIAL_INLINE { all.number(x.q[i]), all.number(x.qd[i]); });
    return all.status();
  }
  /// Whether nothing that follows from an answer of that status is right.
  AXIAL_INLINE static constexpr bool is_lost(const Status& status) { return status.code == Status::Code::not_finite; }
  AXIAL_INLINE static constexpr bool is_kept(const Status& asked, const Status& led_to) {
    const bool is_right = led_to.ok(), was_lost = is_lost(asked);
    return is_right & !was_lost;
  }
  /// Puts into the status of accelerations at a state that they are lost, where it does not tell: it does.
  template <class Q, class V>
  AXIAL_INLINE static constexpr void name_lost(Status&, const Q&, const V&) {}

 private:
  AXIAL_INLINE static constexpr T constant(double value) { return NumberTraits<T>::constant(value); }
  AXIAL_INLINE static constexpr T number(std::uint64_t count) {
    if constexpr (std::is_floating_point_v<T>)
      return static_cast<T>(count);
    else
      return constant(static_cast<double>(count));
  }
  AXIAL_INLINE static constexpr const T& total(const T& rate) { return rate; }
  AXIAL_INLINE static constexpr T total(const T& a, const T& b, const T& c, const T& d) {
    return a + (constant(2.0) * (b + c) + d);
  }
};

/// Of a motion X.
template <class X>
using SummationOf = Summation<typename X::Subject, typename X::Scalar>;

/// Says which numbers are not summed.
template <class S, class T>
constexpr auto check_summed() {
  static_assert(Summation<S, T>::is_there,
                "axial: integrators move float and double; in fixed point add #include "
                "<axial/fixed/simulation/integrators.hpp>");
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
