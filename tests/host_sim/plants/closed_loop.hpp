// A SCARA in a closed loop: the plant in double, and controllers that see it through encoders and a current command.
#pragma once

#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <host_sim/robots/trajectory/set_point.hpp>
#include <robots/scara.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace closed_loop {

using Arm = robots::Scara;
constexpr int joints = 3;
template <class T>
using PerJoint = std::array<T, joints>;
using Values = axial::Joints<Arm, double>;

constexpr int ticks_a_second = 1000;
constexpr int steps_a_tick = 10;  // of the plant
constexpr double tick = 1.0 / ticks_a_second;

// The border, the same for every controller: 20 bits a turn, 0.1 um, 16 bits of current; gains for some 7 Hz.
using Turning = axial::RotaryEncoder<1U << 20>;
using Sliding = axial::LinearEncoder<10'000'000>;
constexpr PerJoint<double> units_a_count{2.0 * 3.14159265358979323846 / (1 << 20),
                                         2.0 * 3.14159265358979323846 / (1 << 20), 1e-7};
template <int i>
struct Drive {
  static constexpr double effort_a_count = Arm::chain.links[i].effort_limit / 32767.0;
  static constexpr std::int32_t most_counts = 32767;
  static constexpr int direction = 1;
};
constexpr PerJoint<double> stiffness{2000.0, 400.0, 3000.0};  // N m/rad, N/m
constexpr PerJoint<double> damping{80.0, 16.0, 150.0};        // N m s/rad, N s/m

/// What encoders say: positions, and by differences speeds, in counts and counts a second.
struct Reading {
  PerJoint<std::int32_t> position{}, speed{};
};

/// An arm that moves by the efforts it gets, in double. `Scene` is what it is like, which a controller may not know.
template <class Scene>
class Plant {
 public:
  using Inputs = axial::Inputs<Scene, double>;
  Plant(const Values& q, const Inputs& in) : q_(q), in_(in) { counts_ = counted(); }

  /// Reads the encoders, once a tick.
  Reading read() {
    Reading now;
    now.position = counted();
    for (int i = 0; i < joints; ++i)
      now.speed[i] = (now.position[i] - counts_[i]) * ticks_a_second;
    counts_ = now.position;
    return now;
  }
  const Values& position() const { return q_; }

  /// One tick under a constant current command.
  void run(const PerJoint<std::int32_t>& command) {
    const Values tau{command[0] * Drive<0>::effort_a_count, command[1] * Drive<1>::effort_a_count,
                     command[2] * Drive<2>::effort_a_count};
    for (int k = 0; k < steps_a_tick; ++k)
      step(tau, tick / steps_a_tick);
  }

 private:
  struct Rate {
    Values qd{}, qdd{};
  };
  Rate rate(const Values& q, const Values& qd, const Values& tau) const {
    const auto qdd = axial::forward_dynamics<Scene>(q, qd, tau, in_);
    Rate r{qd, {}};
    for (int i = 0; i < joints; ++i)
      r.qdd[i] = qdd[i];
    return r;
  }
  Rate rate_after(const Rate& r, double h, const Values& tau) const {
    return rate(moved(q_, r.qd, h), moved(qd_, r.qdd, h), tau);
  }
  static Values moved(Values x, const Values& dx, double h) {
    for (int i = 0; i < joints; ++i)
      x[i] += h * dx[i];
    return x;
  }
  // The classical Runge-Kutta method of fourth order.
  void step(const Values& tau, double h) {
    const Rate a = rate(q_, qd_, tau), b = rate_after(a, h / 2, tau), c = rate_after(b, h / 2, tau),
               d = rate_after(c, h, tau);
    for (int i = 0; i < joints; ++i) {
      q_[i] += h / 6 * (a.qd[i] + 2 * (b.qd[i] + c.qd[i]) + d.qd[i]);
      qd_[i] += h / 6 * (a.qdd[i] + 2 * (b.qdd[i] + c.qdd[i]) + d.qdd[i]);
    }
  }
  PerJoint<std::int32_t> counted() const {
    PerJoint<std::int32_t> counts{};
    for (int i = 0; i < joints; ++i)
      counts[i] = static_cast<std::int32_t>(std::floor(q_[i] / units_a_count[i]));
    return counts;
  }

  Values q_, qd_{};
  Inputs in_;
  PerJoint<std::int32_t> counts_{};
};

inline Values joints_of(const std::vector<double>& values) { return {values[0], values[1], values[2]}; }

/// Feed-forward and PD loop in double. Without feed-forward it carries the arm's weight alone.
class DoubleController {
 public:
  explicit DoubleController(bool feeds_forward = true) : feeds_forward_(feeds_forward) {}

  PerJoint<std::int32_t> command(const host_sim::SetPoint& wanted, const Reading& seen) {
    const Values q = joints_of(wanted.q), qd = joints_of(wanted.qd), qdd = joints_of(wanted.qdd);
    const auto ff = axial::feedforward<Arm>(state_, q, qd, qdd);
    const Values weight = axial::gravity_torque<Arm>(q);
    all_ok_ = all_ok_ && ff.status.ok();
    PerJoint<std::int32_t> counts{};
    for (int i = 0; i < joints; ++i) {
      const double e = q[i] - seen.position[i] * units_a_count[i], ed = qd[i] - seen.speed[i] * units_a_count[i];
      const double tau = (feeds_forward_ ? ff.tau[i] : weight[i]) + stiffness[i] * e + damping[i] * ed;
      const double count = tau / (Arm::chain.links[i].effort_limit / 32767.0);
      counts[i] = static_cast<std::int32_t>(std::lround(std::clamp(count, -32767.0, 32767.0)));
    }
    return counts;
  }
  bool all_ok() const { return all_ok_; }

 private:
  bool feeds_forward_;
  bool all_ok_ = true;
  axial::FeedforwardState<Arm, double> state_{};
};

/// The same by integers alone, once the set-point has passed the border.
template <class Number>
class FixedController {
  using Q = axial::Positions<Arm, Number>;
  using Qd = axial::Velocities<Arm, Number>;
  using Tau = axial::EffortsOf<Arm, Number>;

 public:
  PerJoint<std::int32_t> command(const host_sim::SetPoint& wanted, const Reading& seen) {
    const auto request = axial::to_fixed_request<Arm, typename Number::Word>(joints_of(wanted.q), joints_of(wanted.qd),
                                                                             joints_of(wanted.qdd));
    const auto ff = axial::feedforward<Arm>(state_, request.q, request.qd, request.qdd);
    all_ok_ = all_ok_ && request.status.ok() && ff.status.ok();
    return {joint<0>(request, ff.tau, seen), joint<1>(request, ff.tau, seen), joint<2>(request, ff.tau, seen)};
  }
  bool all_ok() const { return all_ok_; }

 private:
  // Units of the effort's format a unit of the position's, or of the velocity's.
  template <int i>
  struct StiffnessFactor {
    static constexpr double unit =
        i < 2 ? 2.0 * 3.14159265358979323846 / 4294967296.0 : axial::detail::power_of_two(-Q::exponent(i));
    static constexpr double value = stiffness[i] * unit * axial::detail::power_of_two(Tau::exponent(i));
  };
  template <int i>
  struct DampingFactor {
    static constexpr double value = damping[i] * axial::detail::power_of_two(Tau::exponent(i) - Qd::exponent(i));
  };

  template <int i, class Request>
  std::int32_t joint(const Request& wanted, const Tau& ff, const Reading& seen) {
    using axial::detail::scaled;
    constexpr std::int32_t most = std::numeric_limits<typename Number::Word>::max();
    const auto difference = static_cast<std::int32_t>(static_cast<std::uint32_t>(wanted.q[i].raw) -
                                                      static_cast<std::uint32_t>(position<i>(seen.position[i])));
    bool ignored = false;
    const std::int64_t p = scaled<StiffnessFactor<i>>(difference, most, ignored);
    const std::int64_t slower = std::int64_t{wanted.qd[i].raw} - speed<i>(seen.speed[i]);
    const auto lag = static_cast<std::int32_t>(std::clamp(slower, -std::int64_t{most}, std::int64_t{most}));
    const std::int64_t d = scaled<DampingFactor<i>>(lag, most, ignored);
    const std::int64_t sum = std::clamp(ff[i].raw + p + d, -std::int64_t{most}, std::int64_t{most});
    return axial::current_command<Drive<i>, Tau, i>({static_cast<typename Number::Word>(sum)}).value;
  }
  template <int i>
  static std::int32_t position(std::int32_t counts) {
    if constexpr (i < 2)
      return Turning::position(counts).raw;
    else
      return Sliding::position<Q, i>(counts).value.raw;
  }
  template <int i>
  static std::int32_t speed(std::int32_t counts_a_second) {
    if constexpr (i < 2)
      return Turning::velocity<Qd, i>(counts_a_second).value.raw;
    else
      return Sliding::velocity<Qd, i>(counts_a_second).value.raw;
  }

  bool all_ok_ = true;
  axial::FeedforwardState<Arm, Number> state_{};
};

/// Tracking error of one joint, rad or m.
struct Tracking {
  double largest = 0.0, squares = 0.0;
  long count = 0;
  void add(double error) { largest = std::max(largest, std::abs(error)), squares += error * error, ++count; }
  double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

/// Follows a cycle again and again for a time.
template <class Scene, class Controller>
PerJoint<Tracking> follow(const host_sim::Trajectory& cycle, double seconds, Controller& controller,
                          const axial::Inputs<Scene, double>& in) {
  Plant<Scene> plant(joints_of(cycle.front().q), in);
  PerJoint<Tracking> tracking;
  const auto ticks = static_cast<std::size_t>(std::lround(seconds * ticks_a_second));
  for (std::size_t k = 0; k < ticks; ++k) {
    const host_sim::SetPoint& wanted = cycle[k % cycle.size()];
    for (int i = 0; i < joints; ++i)
      tracking[i].add(wanted.q[i] - plant.position()[i]);
    plant.run(controller.command(wanted, plant.read()));
  }
  return tracking;
}

}  // namespace closed_loop
