// States of a robot in fixed point inside its declared limits: random ones and corners.
#pragma once

#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <cstdint>
#include <limits>

namespace exhaustive {

/// splitmix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// In [low, high].
  std::int64_t between(std::int64_t low, std::int64_t high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<std::int64_t>(bits() % span);
  }

 private:
  std::uint64_t state_;
};

/// What a request may hold at one joint, in raw words.
struct Span {
  std::int64_t low = 0, high = 0;
};

inline std::int64_t raw_inside(double limit, int exponent) {
  return static_cast<std::int64_t>(limit * axial::detail::power_of_two(exponent));
}

/// A state and the efforts that drive it.
template <class S, class T>
struct FixedState {
  using Robot = axial::robot_of<S>;
  using Word = typename T::Word;
  using Values = typename axial::scene_of<S>::Robot;  // whose joints, or drives that joints share, have values
  static constexpr int size = Values::chain.size;
  static constexpr int quantities = 4 * size;
  static constexpr std::int64_t most = std::numeric_limits<Word>::max();

  axial::Positions<Robot, T> q{};
  axial::Velocities<Robot, T> qd{};
  axial::Accelerations<Robot, T> qdd{};
  axial::EffortsOf<S, T> tau{};

  static constexpr bool turns(int joint) { return Values::chain.links[joint].type == axial::JointType::revolute; }
  /// Of number k: q, qd, qdd, tau of the joints in turn. A whole turn for an angle.
  static Span span(int k) {
    const int i = k % size;
    const auto& link = Values::chain.links[i];
    using Q = axial::Positions<Robot, T>;
    if (k / size == 0 && turns(i)) return {INT32_MIN, INT32_MAX};
    if (k / size == 0)
      return {raw_inside(link.position_min, Q::exponent(i)), raw_inside(link.position_max, Q::exponent(i))};
    if (k / size == 1) return symmetric(raw_inside(link.speed_limit, decltype(qd)::exponent(i)));
    if (k / size == 2) return symmetric(raw_inside(link.acceleration_limit, decltype(qdd)::exponent(i)));
    return symmetric(axial::detail::is_bounded(link.effort_limit)
                         ? raw_inside(link.effort_limit, decltype(tau)::exponent(i))
                         : most);
  }
  std::int64_t get(int k) const {
    const int i = k % size;
    return k / size == 0 ? q[i].raw : k / size == 1 ? qd[i].raw : k / size == 2 ? qdd[i].raw : tau[i].raw;
  }
  void set(int k, std::int64_t raw) {
    const int i = k % size;
    if (k / size == 0) q[i].raw = static_cast<std::int32_t>(raw);
    if (k / size == 1) qd[i].raw = static_cast<Word>(raw);
    if (k / size == 2) qdd[i].raw = static_cast<Word>(raw);
    if (k / size == 3) tau[i].raw = static_cast<Word>(raw);
  }

 private:
  static Span symmetric(std::int64_t limit) { return {-limit, limit}; }
};

/// A corner of number k: a limit or 0; an eighth of a turn for an angle.
template <class State>
std::int64_t corner(Random& random, int k) {
  const Span span = State::span(k);
  if (k < State::size && State::turns(k)) return random.between(-4, 3) * (std::int64_t{1} << 29);
  const std::int64_t which = random.between(0, 2);
  return which == 0 ? span.low : which == 1 ? span.high : span.low > 0 ? span.low : 0;
}

/// Efforts as large as a word holds them, whatever the robot declares.
template <class State>
void push_beyond(Random& random, State& state) {
  for (int k = 3 * State::size; k < 4 * State::size; ++k)
    state.set(k, random.between(0, 1) == 0 ? State::most : -State::most);
}

/// State number `index` of a sequence: inside, at corners, at limits wherever it turns, and a mixture, one after
/// another.
template <class State>
State next_state(Random& random, std::uint64_t index) {
  State state;
  for (int k = 0; k < State::quantities; ++k) {
    const Span span = State::span(k);
    const std::int64_t inside = random.between(span.low, span.high), at = corner<State>(random, k);
    const bool at_corner =
        index % 4 == 1 || (index % 4 == 2 && k >= State::size) || (index % 4 == 3 && random.between(0, 1) == 0);
    state.set(k, at_corner ? at : inside);
  }
  if (index % 8 == 7) push_beyond(random, state);
  return state;
}

/// Values in SI units: exact but for the last bit of an angle.
template <class R, class T>
axial::Joints<R, double> in_double(const axial::Positions<R, T>& q) {
  constexpr double turn = 6.283185307179586476925286766559;
  axial::Joints<R, double> all{};
  for (int i = 0; i < R::chain.size; ++i) {
    const bool turns = R::chain.links[i].type == axial::JointType::revolute;
    all[i] = turns ? q[i].raw * (turn * 0x1p-32) : q[i].raw * axial::detail::power_of_two(-q.exponent(i));
  }
  return all;
}
template <class R, class Values>
axial::Joints<R, double> in_double(const Values& values) {
  axial::Joints<R, double> all{};
  for (int i = 0; i < R::chain.size; ++i)
    all[i] = values[i].raw * axial::detail::power_of_two(-values.exponent(i));
  return all;
}

}  // namespace exhaustive
