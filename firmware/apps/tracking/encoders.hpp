#pragma once
/// What encoders say, as joint positions: rad or m within the joint's turn, or words of the position's format.

#include <array>
#include <cstdint>
#include <utility>

#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <hal/link/messages.hpp>

namespace axial::apps {

/// What a slide's encoder counts a metre; a turning joint's counts 2^32 a turn.
constexpr std::uint32_t slide_counts = 10'000'000;

template <class Scene, class Number>
struct Encoders {
  using Robot = robot_of<Scene>;
  using Q = Positions<Robot, Number>;
  using Counts = std::array<std::int32_t, hal::link::max_joints>;
  static constexpr bool slides(int i) { return Robot::chain.links[i].type == JointType::prismatic; }

  static Q positions(const Counts& counts) {
    return positions(counts, std::make_integer_sequence<int, Robot::chain.size>{});
  }

 private:
  static constexpr float turn = 6.28318530717958647692F;

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
      if (q < static_cast<float>(Robot::chain.links[I].position_min)) return q + turn;
      return q > static_cast<float>(Robot::chain.links[I].position_max) ? q - turn : q;
    }
  }
};

}  // namespace axial::apps
