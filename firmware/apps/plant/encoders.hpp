#pragma once
/// What an arm's encoders count, as a measurement has it: 2^-32 turns, or 0.1 um on a slide; as coarse and as late as
/// they are, and with the play between motor and joint. By integers, for a float has 24 bits of a count of 32. Where
/// joints share drives, encoders are the drives'.

#include <firmware/apps/tracking/encoders.hpp>

#include "mechanics.hpp"

namespace axial::apps::plant {

/// What was some ticks ago.
template <class Value, int ticks>
class Delay {
 public:
  void fill(const Value& value) {
    for (Value& each : past_)
      each = value;
  }
  Value after(const Value& now) {
    const Value then = past_[oldest_];
    past_[oldest_] = now;
    oldest_ = oldest_ + 1 == ticks ? 0 : oldest_ + 1;
    return then;
  }

 private:
  Value past_[ticks] = {};
  int oldest_ = 0;
};

template <class R, class Number>
class ArmEncoders {
  using M = MechanicsOf<R>;
  using Values = typename scene_of<R>::Robot;
  static constexpr int n = joint_count<R>;
  static constexpr int delay = encoder_delay<M>;
  static_assert(delay >= 0 && delay <= 100, "encoder_delay is from 0 to 100 ticks of 1 ms");
  static constexpr bool slides(int i) { return Values::chain.links[i].type == JointType::prismatic; }
  static constexpr double counts_a_unit(int i) {
    return slides(i) ? slide_counts : 4294967296.0 / 6.283185307179586477;
  }

 public:
  /// The motors stand in the middle of their play.
  template <class X>
  void place(const X& x) {
    each([&](auto i) { motor_[i] = joint<i>(x); });
    if constexpr (delay > 0) read(x), past_.fill(seen_);
  }
  template <class X>
  void follow(const X& x) {
    each([&](auto i) {
      const std::int32_t counts = joint<i>(x);
      if constexpr (has_backlash<M>)
        motor_[i] = dragged(motor_[i], counts, half_play(i));
      else
        motor_[i] = counts;
    });
    if constexpr (delay > 0) read(x), seen_ = past_.after(seen_);
  }
  std::int32_t counts(int i) const {
    if constexpr (delay > 0)
      return coarse(seen_.position[i], slides(i));
    else
      return coarse(motor_[i], slides(i));
  }
  /// rad/s or m/s
  template <class X>
  const Velocities<R, Number>& speeds(const X& x) const {
    if constexpr (delay > 0)
      return seen_.speed;
    else
      return x.qd;
  }

 private:
  struct Reading {
    std::int32_t position[n] = {};
    Velocities<R, Number> speed{};
  };
  struct Nothing {};
  using History = Delay<Reading, (delay > 0 ? delay : 1)>;

  template <class X>
  void read(const X& x) {
    for (int i = 0; i < n; ++i)
      seen_.position[i] = motor_[i];
    seen_.speed = x.qd;
  }

  template <class F>
  static void each(const F& f) {
    each(f, std::make_integer_sequence<int, n>{});
  }
  template <class F, int... I>
  static void each(const F& f, std::integer_sequence<int, I...>) {
    (f(std::integral_constant<int, I>{}), ...);
  }

  template <int I, class X>
  static std::int32_t joint(const X& x) {
    if constexpr (!is_stored_v<Number>) {
      // q = k 2^-20 and the rest of it, of which a float holds enough.
      constexpr double unit = counts_a_unit(I) / 1048576.0;
      constexpr auto whole = static_cast<std::int64_t>(unit * 1048576.0 + 0.5);
      constexpr Number most = 2047;
      const Number q = x.q[I] < -most ? -most : x.q[I] > most ? most : x.q[I];
      const auto k = static_cast<std::int32_t>(q * Number(1048576));
      const Number rest = (q * Number(1048576) - static_cast<Number>(k)) + x.q_rest[I] * Number(1048576);
      const Number counts = rest * static_cast<Number>(unit);
      const auto nearest = static_cast<std::int32_t>(counts + (counts < Number(0) ? Number(-0.5) : Number(0.5)));
      return static_cast<std::int32_t>(static_cast<std::uint32_t>((k * whole + 524288) >> 20) +
                                       static_cast<std::uint32_t>(nearest));
    } else if constexpr (slides(I)) {
      bool ignored = false;
      constexpr std::int32_t all = 2147483647;
      return detail::nearest_word<std::int32_t>(detail::scaled<SlideFactor<I>>(x.q[I].raw, all, ignored));
    } else {
      return x.q[I].raw;
    }
  }
  template <int I>
  struct SlideFactor {
    static constexpr double value = slide_counts * detail::power_of_two(-Positions<R, Fixed32>::exponent(I));
  };

  static constexpr std::int32_t half_play(int i) {
    if constexpr (has_backlash<M>) return static_cast<std::int32_t>(0.5 * M::backlash[i] * counts_a_unit(i));
    return 0;
  }
  /// A motor is where it was, but that the joint drags it along at either end of the play.
  static std::int32_t dragged(std::int32_t motor, std::int32_t joint, std::int32_t half) {
    const auto off = static_cast<std::int32_t>(static_cast<std::uint32_t>(joint) - static_cast<std::uint32_t>(motor));
    const std::int32_t by = off > half ? off - half : off < -half ? off + half : 0;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(motor) + static_cast<std::uint32_t>(by));
  }

  static constexpr std::int32_t coarse(std::int32_t counts, [[maybe_unused]] bool slide) {
    constexpr int bits = encoder_bits<M>;
    static_assert(bits >= 1 && bits <= 32, "an encoder has from 1 to 32 bits");
    if constexpr (bits < 32) {
      if (slide) return to_step(counts, step_of_slide(bits));
      constexpr std::uint32_t half = 1U << (31 - bits), below = 2 * half - 1;
      return static_cast<std::int32_t>((static_cast<std::uint32_t>(counts) + half) & ~below);
    }
    return counts;
  }
  static constexpr std::int32_t step_of_slide(int bits) {
    const auto step = static_cast<std::int32_t>((std::int64_t{slide_counts} + (std::int64_t{1} << (bits - 1))) >> bits);
    return step < 1 ? 1 : step;
  }
  static constexpr std::int32_t to_step(std::int32_t counts, std::int32_t step) {
    return (counts < 0 ? counts - step / 2 : counts + step / 2) / step * step;
  }

  std::int32_t motor_[n] = {};
  std::conditional_t<(delay > 0), Reading, Nothing> seen_{};
  std::conditional_t<(delay > 0), History, Nothing> past_{};
};

}  // namespace axial::apps::plant
