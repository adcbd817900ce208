#pragma once
/// What the loop's constants and differences are in float, and in fixed point by integers alone.

#include <firmware/apps/tracking/controller.hpp>

namespace axial::apps {

template <class S, class Number>
struct LoopWords {
  using Robot = robot_of<S>;
  using Q = Positions<Robot, Number>;
  using Qd = Velocities<Robot, Number>;
  using Tau = EffortsOf<S, Number>;
  static constexpr int n = Robot::chain.size;
  static constexpr bool fixed = is_stored_v<Number>;

  /// The tracking image's gains.
  static constexpr auto make_gains() {
    constexpr auto exact = tracking_gains<Robot>();
    TrackingGains<S, double> real{};
    for (int i = 0; i < n; ++i)
      real.stiffness[i] = exact.stiffness[i], real.damping[i] = exact.damping[i];
    if constexpr (fixed) {
      return to_fixed_gains<S, typename Number::Word>(real);
    } else {
      struct Plain {
        TrackingGains<S, float> gains{};
        Status status{};
      } plain;
      for (int i = 0; i < n; ++i) {
        plain.gains.stiffness[i] = static_cast<float>(real.stiffness[i]);
        plain.gains.damping[i] = static_cast<float>(real.damping[i]);
      }
      return plain;
    }
  }
  static constexpr auto made = make_gains();
  static_assert(made.status.ok(), "The gains of this robot do not fit words.");
  static constexpr auto gains = made.gains;

  static constexpr PayloadBody<Number> payload(const PayloadBody<double>& load) {
    if constexpr (fixed) {
      return to_fixed_payload<S, typename Number::Word>(load).load;
    } else {
      const auto& j = load.inertia_com;
      const auto f = [](double x) { return static_cast<float>(x); };
      return {f(load.mass),
              {f(load.com.x), f(load.com.y), f(load.com.z)},
              {f(j.xx), f(j.yy), f(j.zz), f(j.xy), f(j.xz), f(j.yz)}};
    }
  }

  /// The range of each joint's effort in so many steps.
  static constexpr Tau steps(std::uint32_t count) {
    Tau step{};
    for (int i = 0; i < n; ++i) {
      const auto& most = detail::LimitsFor<S, Number>::joint(i).effort;
      if constexpr (fixed)
        step[i] = {static_cast<typename Number::Word>(2 * std::int64_t{most.raw} / count)};
      else
        step[i] = 2.0F * most / static_cast<float>(count);
    }
    return step;
  }

  /// How fast positions changed since the last sample, as far as speeds go.
  static Qd speeds(const Q& q, const Q& last) { return speeds(q, last, std::make_integer_sequence<int, n>{}); }

  static bool differ(const Tau& a, const Tau& b) {
    for (int i = 0; i < n; ++i) {
      if constexpr (fixed) {
        if (a[i].raw != b[i].raw) return true;
      } else if (a[i] < b[i] || a[i] > b[i]) {
        return true;
      }
    }
    return false;
  }

 private:
  template <int... I>
  static Qd speeds(const Q& q, const Q& last, std::integer_sequence<int, I...>) {
    return {{speed<I>(q[I], last[I])...}};
  }
  template <int I>
  struct RateFactor {
    static constexpr double value() {
      if constexpr (fixed) {
        const double unit =
            detail::is_angle<Q>(I) ? detail::whole_turn / 4294967296.0 : detail::power_of_two(-Q::exponent(I));
        return unit * detail::power_of_two(Qd::exponent(I)) * control_Hz;
      } else {
        return control_Hz;
      }
    }
  };
  template <int I>
  struct Factor {
    static constexpr double value = RateFactor<I>::value();
  };
  template <int I, class Value>
  static auto speed(const Value& q, const Value& last) {
    const auto& most = detail::LimitsFor<S, Number>::joint(I).speed;
    if constexpr (fixed) {
      bool ignored = false;
      const auto change =
          static_cast<std::int32_t>(static_cast<std::uint32_t>(q.raw) - static_cast<std::uint32_t>(last.raw));
      using Word = typename Qd::Value::Word;
      return typename Qd::Value{static_cast<Word>(detail::scaled<Factor<I>>(change, most.raw, ignored))};
    } else {
      return detail::LimitsFor<S, Number>::nearest(most, (q - last) * static_cast<float>(control_Hz));
    }
  }
};

}  // namespace axial::apps
