#pragma once
/// Steps of joints that stick and that meet end stops, in words, hashed: the same motion on every board and host.

#include <axial/fixed.hpp>
#include <axial/fixed/simulation/sticking.hpp>
#include <firmware/apps/observer/sequence.hpp>

namespace axial::apps::held {

template <class Robot>
struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[joint_count<Robot>] = {}, damping[joint_count<Robot>] = {};
};
inline constexpr int starts = 60, steps = 6;

/// What the sequence showed.
struct Report {
  std::uint64_t hash = 0;
  observer::Cost step;         ///< instructions, where the counter counts
  int stuck = 0, stopped = 0;  ///< joints at rest, and at a limit, behind a step
};

/// Anywhere inside the limits, at any speed; every other joint at rest, or at the end of its range.
template <class S>
void start(int number, const observer::Samples<S, Fixed32>& drawn, Motion<S, Fixed32>& x) {
  x = {};
  x.q = drawn.q, x.qd = drawn.qd;
  for (int i = number % 2; i < joint_count<S>; i += 2) {
    if (number % 3 == 1) x.qd[i].raw = 0;
    if (number % 3 == 2) x.q[i].raw = detail::LimitsFor<S, Fixed32>::joint(i).max;
  }
}

/// `count(code)` runs code and says what it cost.
template <class Robot, class Count>
Report report(Count count) {
  using S = Scene<Robot, Gravity, RotorInertia, Friction>;
  Report all;
  fixed::Hash hash;
  observer::Samples<S, Fixed32> drawn;
  Motion<S, Fixed32> x;
  Held<S, Fixed32> held;
  const WithEndStops<S, Fixed32, Held<S, Fixed32>> drive(held, EndStops{});
  for (int k = 0; k < starts; ++k) {
    drawn.next();
    start(k, drawn, x);
    held.tau = drawn.tau;
    for (int s = 0; s < steps; ++s) {
      Status status;
      auto step = [&] { status = advance<StickingFor<Soft<Robot>>>(x, drive); };
      all.step.add(count(step));
      hash.add(static_cast<int>(status.code)), hash.add(status.joint);
      for (int i = 0; i < joint_count<S>; ++i) {
        hash.add(x.q[i].raw), hash.add(x.qd[i].raw);
        const bool ends = x.q[i].raw == detail::LimitsFor<S, Fixed32>::joint(i).max;
        all.stuck += static_cast<int>(x.qd[i].raw == 0), all.stopped += static_cast<int>(ends);
      }
    }
  }
  all.hash = hash.value();
  return all;
}

}  // namespace axial::apps::held
