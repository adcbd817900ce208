#pragma once
/// A loop whose angles come as sines and cosines, and a wire of one of them that breaks: every way of breaking ends
/// with the drives disabled, in the fall-back's time.

#include <firmware/apps/fixed/golden.hpp>
#include <firmware/apps/observer/sequence.hpp>

namespace axial::apps::broken_pair {

constexpr FallBackTimes times{5, 50, 200};
/// Tick of the break, and of the end.
constexpr int breaks_at = 20, ticks = 400;

/// How a pair breaks: both lines, the sine's, the cosine's, or a sine that no angle has.
constexpr int ways = 4;

/// What the sequence showed.
struct Report {
  std::uint64_t hash = 0;  ///< of all efforts' bits
  int soonest = ticks;     ///< ticks from the break until the drives are disabled, of the quickest way
  int latest = 0;          ///< and of the slowest
  bool refused = true;     ///< whether every tick behind the break had a status, none before it
};

/// The pair of 0.6 rad, or what is left of it.
template <class T>
SinCos<T> pair(int way) {
  const double sine = 0.5646424733950354, cosine = 0.8253356149096783;
  const double values[][2] = {{sine, cosine}, {0.0, 0.0}, {0.0, cosine}, {sine, 0.0}, {1.9, cosine}};
  const auto& of = values[way];
  if constexpr (is_stored_v<T>)
    return {T{static_cast<std::int32_t>(of[0] * 1073741824.0)}, T{static_cast<std::int32_t>(of[1] * 1073741824.0)}};
  else
    return {static_cast<T>(of[0]), static_cast<T>(of[1])};
}

/// The loop, with the pair of joint 1 broken in that way.
template <class S, class T>
void run(int way, Report& all, fixed::Hash& hash) {
  FallBack<S, T> fall_back(times);
  FeedforwardState<S, T> state;
  int disabled = 0;
  for (int k = 0; k < ticks; ++k) {
    Inputs<S, T> in;
    for (auto& turn : in.turns.values)
      turn = pair<T>(0);
    if (k >= breaks_at) in.turns[0] = pair<T>(way);
    const Positions<robot_of<S>, T> q{};
    const auto safe = feedforward<S>(state, q, {}, {}, in);
    all.refused = all.refused && safe.status.met() == (k < breaks_at);
    if (safe.status.met()) all.refused = fall_back.follow(q, safe.tau, in) && all.refused;
    fall_back.advance(1);
    const auto tau = fall_back.torque();
    for (int i = 0; i < joint_count<S>; ++i)
      hash.add(observer::bits(tau[i]));
    if (disabled == 0 && k >= breaks_at && !fall_back.enabled()) disabled = k + 1 - breaks_at;
  }
  if (disabled == 0) disabled = ticks;
  all.soonest = disabled < all.soonest ? disabled : all.soonest;
  all.latest = disabled > all.latest ? disabled : all.latest;
}

template <class Robot, class T>
Report report() {
  using S = Scene<Robot, Gravity, RotorInertia, SineCosines>;
  Report all;
  fixed::Hash hash;
  for (int way = 1; way <= ways; ++way)
    run<S, T>(way, all, hash);
  all.hash = hash.value();
  return all;
}

}  // namespace axial::apps::broken_pair
