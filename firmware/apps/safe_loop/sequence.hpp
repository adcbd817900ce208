#pragma once
/// The safe calls of a loop over a fixed sequence of good and bad ticks, hashed: the same numbers on every board and
/// host.

#include <firmware/apps/fixed/golden.hpp>
#include <firmware/apps/hand_guiding/controller.hpp>
#include <firmware/apps/observer/sequence.hpp>
#include <firmware/apps/safe_loop/drive_calls.hpp>

namespace axial::apps::safe_loop {

using observer::Cost;

/// What the sequence showed.
struct Report {
  std::uint64_t hash = 0;
  Cost gravity, tracking;  ///< instructions of a good call, where the counter counts
  Cost bad;                ///< of a call that was refused, of either kind
  Cost limiting, telling;  ///< of limit_currents() and position_command(), where there are they: not in fixed point
  int met = 0, refused = 0;
};

inline constexpr int ticks = 200;

/// A word beyond every limit, or what is no number.
template <class S, class T, class Q>
void spoil(Q& q) {
  if constexpr (is_stored_v<T>)
    q[0].raw = fixed_limits_of<S, typename T::Word>.joints[0].max + 1;
  else
    q[0] = std::numeric_limits<T>::quiet_NaN();
}

/// `count(code)` runs code and says what it cost. Two of three ticks are good; errors are anything that limits allow,
/// so that efforts are clamped, slowed, both or neither.
template <class Robot, class T, class Count>
Report report(Count count) {
  using S = GuidedScene<Robot>;
  using Words = LoopWords<S, T>;
  observer::Samples<S, T> wanted, seen;
  seen.next();  // another place in the same sequence
  SafeLoopState<S, T> state{};
  state.output.step = Words::steps(20);
  Inputs<S, T> in{};
  constexpr auto held = Words::payload(mounted_payload<S>(gripper));
  in.payload = held;
  fixed::Hash hash;
  Report all;
  [[maybe_unused]] std::conditional_t<is_stored_v<T>, Cost, DriveCalls<S, T>> drives;
  for (int k = 0; k < ticks; ++k) {
    wanted.next(), seen.next();
    Request<S, T> request{wanted.q, wanted.qd, {}, {}};
    MeasuredMotion<S, T> measured{seen.q, seen.qd, {}};
    const bool guides = k % 2 == 0, good = k % 3 != 0;
    if (!good && (guides || k % 9 == 3))
      spoil<S, T>(measured.q);
    else if (!good)
      spoil<S, T>(request.q);
    FeedforwardResult<S, T> result;
    auto carry = [&] { result = compensate_gravity<S>(state, measured.q, in); };
    auto follow = [&] { result = track<S>(state, request, measured, Words::gains, in); };
    const std::uint32_t cost = guides ? count(carry) : count(follow);
    (good ? guides ? all.gravity : all.tracking : all.bad).add(cost);
    ++(result.status.met() ? all.met : all.refused);
    for (int i = 0; i < joint_count<S>; ++i)
      hash.add(observer::bits(result.tau[i]));
    hash.add(static_cast<int>(result.status.code)), hash.add(result.status.joint);
    if constexpr (!is_stored_v<T>) drives.run(count, result.tau, wanted.q, all.limiting, all.telling, hash);
  }
  all.hash = hash.value();
  return all;
}

}  // namespace axial::apps::safe_loop
