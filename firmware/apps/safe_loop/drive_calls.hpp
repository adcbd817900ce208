#pragma once
/// What stands between the safe calls of a loop and its drives: currents that windings stand, positions for servos. In
/// float and double.

#include <firmware/apps/observer/sequence.hpp>

namespace axial::apps::safe_loop {

/// Drives of a robot that get hot within the sequence, and servos whose commands reach their limits.
template <class S, class T>
class DriveCalls {
  static constexpr int n = joint_count<S>;
  struct Ratings {
    DriveRating of[n];
  };
  static constexpr auto ratings() {
    Ratings all{};
    for (int i = 0; i < n; ++i)
      all.of[i] = DriveRating().continuous_current(1.0).peak_current(2.5).time_constant_s(0.2).torque_constant(
          0.4 * robot_of<S>::chain.links[i].effort_limit);
    return all;
  }
  static constexpr auto rated = ratings();
  static constexpr auto limits = current_limits<S, T>(rated.of, 1e-3);
  static_assert(limits.status.ok());
  static constexpr auto servos() {
    PositionLoop<S, T> loop{};
    for (int i = 0; i < n; ++i)
      loop.stiffness[i] = static_cast<T>(8.0 * robot_of<S>::chain.links[i].effort_limit),
      loop.largest_offset[i] = static_cast<T>(0.0625);
    return loop;
  }

 public:
  /// `count(code)` runs code and says what it cost; into `limiting` and `telling`, and every bit into `hash`.
  template <class Count, class Hash>
  void run(const Count& count, EffortsOf<S, T> tau, const Positions<robot_of<S>, T>& q, observer::Cost& limiting,
           observer::Cost& telling, Hash& hash) {
    Status limited;
    auto limit = [&] { limited = limit_currents(windings_, limits, tau); };
    limiting.add(count(limit));
    PositionCommand<S, T> command;
    auto tell = [&] { command = position_command<S>(told_, loop_, q, tau); };
    telling.add(count(tell));
    for (int i = 0; i < n; ++i)
      hash.add(observer::bits(tau[i])), hash.add(observer::bits(command.q[i]));
    for (const Status& status : {limited, command.status})
      hash.add(static_cast<int>(status.code)), hash.add(status.joint);
  }

 private:
  WindingHeat<S, T> windings_;
  PositionCommandState<S, T> told_{};
  PositionLoop<S, T> loop_ = servos();
};

}  // namespace axial::apps::safe_loop
