#pragma once
/// Controlled stops from full speed, hashed: the same efforts on every board and host.

#include <firmware/apps/fixed/golden.hpp>
#include <firmware/apps/observer/sequence.hpp>

namespace axial::apps::controlled_stop {

using observer::Cost;

/// Half of each joint's acceleration limit, at 1 kHz.
struct Stop {
  static constexpr double period = 1e-3;
};
constexpr FallBackTimes times{5, 50, 200};
/// Until every robot's drives are disabled.
constexpr int ticks = 900;

/// What the sequence showed.
struct Report {
  std::uint64_t hash = 0;
  Cost braking;     ///< instructions of a tick of braking, where the counter counts
  int to_rest = 0;  ///< ticks from the last request to rest, of the longest stop
};

/// Every joint in the middle of its range and at its whole speed, forwards or backwards.
template <class Robot, class T>
Request<Robot, T> full_speed(bool forwards) {
  Request<Robot, T> r;
  for (int i = 0; i < joint_count<Robot>; ++i) {
    const auto& l = detail::LimitsFor<Robot, T>::joint(i);
    if constexpr (is_stored_v<T>) {
      const bool ends = l.span != (std::numeric_limits<std::uint32_t>::max)();  // else the middle is 0
      r.q[i].raw = static_cast<std::int32_t>(static_cast<std::uint32_t>(l.min) + (ends ? l.span / 2 : 0)),
      r.qd[i].raw = forwards ? l.speed.raw : -l.speed.raw;
    } else {
      r.q[i] = T(0.5) * (l.position_min + l.position_max), r.qd[i] = forwards ? l.speed : -l.speed;
    }
  }
  return r;
}

/// `count(code)` runs code and says what it cost; `see(fall_back, tick)` is shown what is exerted from now on.
template <class Robot, class T, class Count, class See>
void stop(bool forwards, Count count, const See& see, Report& all, fixed::Hash& hash) {
  FallBack<Robot, T, Stop> fall_back(times);
  FeedforwardState<Robot, T> state;
  const auto r = full_speed<Robot, T>(forwards);
  const auto safe = feedforward<Robot>(state, r.q, r.qd, r.qdd);
  hash.add(static_cast<int>(safe.status.met() && fall_back.follow(r, safe.tau)));
  for (int k = 0; k < ticks; ++k) {
    const auto tau = fall_back.torque();
    for (int i = 0; i < joint_count<Robot>; ++i)
      hash.add(observer::bits(tau[i]));
    see(fall_back, k);
    const DrivePhase before = fall_back.phase();
    auto tick = [&] { fall_back.advance(1); };
    const std::uint32_t cost = count(tick);
    const bool braking = before == DrivePhase::fading;
    if (braking && fall_back.phase() == before) all.braking.add(cost);
    if (braking && fall_back.phase() != before && k + 1 > all.to_rest) all.to_rest = k + 1;
  }
}

template <class Robot, class T, class Count>
Report report(Count count) {
  Report all;
  fixed::Hash hash;
  for (const bool forwards : {true, false})
    stop<Robot, T>(
        forwards, count, [](const auto&, int) {}, all, hash);
  all.hash = hash.value();
  return all;
}

}  // namespace axial::apps::controlled_stop
