#pragma once
/// What drives exert beside what they are asked for: noise of a declared size, by integers, so that every board and
/// number system draws the same.

#include <iterator>
#include <utility>

#include <firmware/apps/states.hpp>

#include "mechanics.hpp"

namespace axial::apps::plant {

/// Near to normal: sums of four equal chances of 16 bits.
class Draws {
 public:
  /// Of mean 0 and of this deviation.
  std::int32_t next() {
    const std::uint32_t a = random_.bits(), b = random_.bits();
    return part(a) + part(a >> 16) + part(b) + part(b >> 16) + 2;
  }
  static constexpr double deviation = 37837.226;  // the root of (2^32 - 1) / 3

 private:
  static std::int32_t part(std::uint32_t bits) { return static_cast<std::int16_t>(bits & 0xFFFFU); }

  Random random_{2463534242U};
};

/// Noise of a scene's efforts.
template <class S, class Number, class M>
class DriveNoise {
  using Tau = EffortsOf<S, Number>;
  static constexpr int n = joint_count<S>;
  static_assert(std::size(M::torque_noise) == n, "torque_noise has a value for each joint, or drive that joints share");

 public:
  /// As after a start: a motion that begins anew meets the same noise.
  void restart() { draws_ = {}; }
  /// Adds another draw to each effort.
  void add(Tau& tau) { add(tau, std::make_integer_sequence<int, n>{}); }

 private:
  template <int I>
  struct Factor {
    static_assert(M::torque_noise[I] >= 0.0, "torque_noise is a standard deviation, which is not negative");
    static constexpr double value = M::torque_noise[I] / Draws::deviation;
  };
  template <int I>
  struct WordFactor {
    static constexpr double value = Factor<I>::value * detail::power_of_two(Tau::exponent(I));
  };

  template <int... I>
  void add(Tau& tau, std::integer_sequence<int, I...>) {
    (add_to<I>(tau, draws_.next()), ...);
  }
  template <int I>
  static void add_to(Tau& tau, std::int32_t draw) {
    if constexpr (Factor<I>::value == 0.0) {
      static_cast<void>(tau), static_cast<void>(draw);
    } else if constexpr (is_stored_v<Number>) {
      using Word = typename Tau::Value::Word;
      bool ignored = false;
      constexpr std::int32_t all = 2147483647;
      const std::int64_t noise = detail::scaled<WordFactor<I>>(draw, all, ignored);
      tau.values[I].raw = detail::nearest_word<Word>(tau.values[I].raw + noise);
    } else {
      tau[I] += static_cast<Number>(draw) * static_cast<Number>(Factor<I>::value);
    }
  }

  Draws draws_{};
};
/// Of drives that name none.
struct NoNoise {
  static void restart() {}
  template <class Tau>
  static void add(const Tau&) {}
};
template <class S, class Number, class M>
using NoiseOf = std::conditional_t<has_noise<M>, DriveNoise<S, Number, M>, NoNoise>;

}  // namespace axial::apps::plant
