#pragma once
/// What encoders say, as joint positions: rad or m within the joint's turn, or words of the position's format. Where
/// joints share drives, encoders are the drives', and each counts a number over all of its turns.

#include <array>
#include <cstdint>
#include <utility>

#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <hal/link/messages.hpp>

namespace axial::apps {

/// What a slide's encoder counts a metre, and one of a drive that joints share per unit of the drive; a turning
/// joint's counts 2^32 a turn.
constexpr std::uint32_t slide_counts = 10'000'000;

template <class Scene, class Number>
struct Encoders {
  using Robot = robot_of<Scene>;
  using Values = typename scene_of<Scene>::Robot;  ///< what has values: joints, or drives that they share
  using Q = Positions<Robot, Number>;
  using Counts = std::array<std::int32_t, hal::link::max_joints>;
  static constexpr const LinkParameters& value(int i) { return Values::chain.links[i]; }
  static constexpr bool slides(int i) { return value(i).type == JointType::prismatic; }
  static_assert(
      [] {
        bool fit = true;
        for (int i = 0; i < Values::chain.size; ++i) {
          const double most =
              value(i).position_max > -value(i).position_min ? value(i).position_max : -value(i).position_min;
          fit = fit && (!slides(i) || !(most < LinkParameters::unlimited) || most * slide_counts < 2147483648.0);
        }
        return fit;
      }(),
      "axial: a position limit is beyond what 32 bits of slide_counts hold; declare narrower limits");

  /// Whether no arm gets from one reading to the other between two measurements: farther than at its declared speed in
  /// 16 ms. A broken wire reads so.
  static bool jumps(const Counts& from, const Counts& to) {
    bool any = false;
    for (int i = 0; i < Values::chain.size; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const std::uint32_t way = static_cast<std::uint32_t>(to[k]) - static_cast<std::uint32_t>(from[k]);
      any = any | (way + most.counts[k] > 2 * most.counts[k]);  // either way, round the circle too
    }
    return any;
  }

  static Q positions(const Counts& counts) {
    return positions(counts, std::make_integer_sequence<int, Values::chain.size>{});
  }

 private:
  static constexpr float turn = 6.28318530717958647692F;
  struct Most {
    std::uint32_t counts[Values::chain.size] = {};
    constexpr Most() {
      for (int i = 0; i < Values::chain.size; ++i) {
        const double way = 0.016 * value(i).speed_limit * (slides(i) ? slide_counts : 4294967296.0 / 6.283185307179586);
        counts[i] = way < 2147483647.0 ? static_cast<std::uint32_t>(way) : 2147483647U;
      }
    }
  };
  static constexpr Most most{};

  template <int... I>
  static Q positions(const Counts& counts, std::integer_sequence<int, I...>) {
    return {{position<I>(counts[static_cast<std::size_t>(I)])...}};
  }
  template <int I>
  static auto position(std::int32_t counts) {
    if constexpr (is_stored_v<Number>) {
      if constexpr (slides(I))
        return LinearEncoder<slide_counts>::template position<Q, I>(counts).value;
      else
        return typename Q::Value{counts};
    } else if constexpr (slides(I)) {
      return static_cast<float>(counts) * (1.0F / slide_counts);
    } else {
      const float q = static_cast<float>(counts) * (turn / 4294967296.0F);
      if (q < static_cast<float>(value(I).position_min)) return q + turn;
      return q > static_cast<float>(value(I).position_max) ? q - turn : q;
    }
  }
};

}  // namespace axial::apps
