#pragma once
/// Number systems by name, and joint values in each of them: for probes, and for the host that judges their errors.

#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <cstdint>
#include <limits>

namespace axial::apps {

/// Numbers T as the API takes them, and the tags that say how fixed point rounds and multiplies.
template <class T, class... Tags>
struct NumberSystem {
  using Number = T;
  /// A scene with this system's tags.
  template <template <class, class...> class Scene, class Robot, class... Others>
  using scene = Scene<Robot, Tags..., Others...>;
};

namespace number_systems {
using as_float = NumberSystem<float>;
using as_double = NumberSystem<double>;
using as_fixed32 = NumberSystem<Fixed32>;                  ///< exact products, rounded to nearest
using as_fixed32_down = NumberSystem<Fixed32, RoundDown>;  ///< exact products, rounded down
using as_fixed32_high = NumberSystem<Fixed32, HighWord>;   ///< upper words of products
using as_fixed16 = NumberSystem<Fixed16>;
}  // namespace number_systems

/// The nearest integer to value 2^exponent, held within the word.
template <class Word>
constexpr Word nearest_raw(double value, int exponent) {
  using Limits = std::numeric_limits<Word>;
  const double scaled = value * detail::power_of_two(exponent);
  if (scaled >= static_cast<double>(Limits::max())) return Limits::max();
  if (scaled <= static_cast<double>(Limits::min())) return Limits::min();
  return static_cast<Word>(scaled + (scaled < 0.0 ? -0.5 : 0.5));
}

/// The nearest BAM32 to an angle of at most a few turns, rad.
constexpr std::int32_t nearest_bam(double angle) {
  constexpr double units_per_radian = 0x1p32 / 6.283185307179586476925;
  const double scaled = angle * units_per_radian;
  return static_cast<std::int32_t>(
      static_cast<std::uint32_t>(static_cast<std::int64_t>(scaled + (scaled < 0.0 ? -0.5 : 0.5))));
}

/// Values of a role, as `To` holds them, nearest to those given.
template <class To, class From>
constexpr To nearest(const From& values) {
  To result{};
  for (int i = 0; i < To::size; ++i) {
    using Value = std::decay_t<decltype(result[i])>;
    if constexpr (is_stored_v<Value>)
      result[i].raw = nearest_raw<typename Value::Word>(static_cast<double>(values[i]), To::exponent(i));
    else
      result[i] = static_cast<Value>(values[i]);
  }
  return result;
}
template <class Robot, class T, class From>
constexpr Positions<Robot, T> nearest_positions(const From& q) {
  auto result = nearest<Positions<Robot, T>>(q);
  if constexpr (is_stored_v<T>)
    for (int i = 0; i < joint_count<Robot>; ++i)
      if (scene_of<Robot>::Robot::chain.links[i].type == JointType::revolute)
        result[i].raw = nearest_bam(static_cast<double>(q[i]));
  return result;
}

}  // namespace axial::apps
