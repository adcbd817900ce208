#pragma once
/// A board that stands in for an arm: efforts in, encoders out, for the main job (feedforward.hpp) as a controller is.
/// README.md has the table of what its drives do when efforts are late, absent or wrong.

#include <firmware/apps/feedforward/controller.hpp>
#include <firmware/apps/feedforward/deadlines.hpp>

#include "elastic.hpp"
#include "encoders.hpp"
#include "input.hpp"
#include "noise.hpp"
#include "worker.hpp"

namespace axial::apps::plant {

/// `substeps`: steps of the integrator a tick of 1 ms. `Worker`: who makes them (worker.hpp); one beside this core
/// makes those of a tick while this one speaks, so that in free-running encoders tell of the tick before.
template <class R, class Number = float, int substeps = 1, class Worker = OnThisCore>
class Arm : GivenInputs<typename DrivesOf<R, Number>::S, Number> {
  using Joined = DrivesOf<R, Number>;
  using S = typename Joined::S;
  using M = MechanicsOf<R>;
  using Method = typename ArmMethod<R, Number, substeps>::type;
  using X = std::conditional_t<is_stored_v<Number>, Motion<S, Number>, CompensatedMotion<S, Number>>;
  using Tau = typename Joined::Tau;
  using Values = std::array<float, hal::link::max_joints>;
  using Status = hal::link::TorqueStatus;

 public:
  static constexpr std::size_t joints = static_cast<std::size_t>(joint_count<R>);
  static constexpr const char* name = R::name;
  static constexpr std::uint32_t ticks_a_second = 1000;
  static constexpr bool carries = has_payload<M>;  ///< whether it takes a load on command

  // --- what the main job asks

  /// In lock-step a frame's number is the time, and the board's timer moves nothing.
  void choose(hal::link::Mode mode, std::uint32_t tick_Hz) {
    free_running_ = mode == hal::link::Mode::free_running;
    ticks_a_board_tick_ = ticks_a_second / tick_Hz;
    times_ = {watchdog_ticks, ticks_of(ramp_ms, free_running_ ? tick_Hz : ticks_a_second), 1};
  }
  void restart() { phases_ = {}, asked_ = {}, passed_ = 0; }
  DrivePhase phase() const { return phases_.phase(); }

  /// So many numbers came since the last efforts, these included.
  void pass(std::uint32_t numbers) { passed_ += numbers; }
  /// The board's timer.
  void advance(std::uint32_t ticks) {
    if (!free_running_) return;
    for (; ticks > 0; --ticks) {
      phases_.advance(times_, 1);
      for (std::uint32_t k = 0; k < ticks_a_board_tick_; ++k)
        move();
    }
  }

  /// Ticks that were left out pass under the efforts before; then the drives take the new ones, if these are good.
  void load(const hal::link::Torque& request) {
    for (; passed_ > 1; --passed_)
      wait(), move();
    told_ = Status::ok, joint_ = hal::link::no_joint;
    take(request);
    if (told_ == Status::not_finite || !phases_.follow())
      wait();
    else
      asked_ = wanted_;
  }
  /// What is measured: a tick in lock-step; in free-running ticks are the timer's.
  void compute() {
    if (!free_running_) move(), finish();
  }
  void settle(const hal::link::Torque&) {
    passed_ = 0;
    tell(moved_), moved_ = {};
    if (told_ != Status::not_finite && phases_.phase() == DrivePhase::disabled)
      told_ = Status::disabled, joint_ = hal::link::no_joint;
  }

  void store(hal::link::Encoders& answer) const {
    store_exerted(answer);
    answer.status = static_cast<std::uint8_t>(told_), answer.joint = joint_;
  }
  void store_exerted(hal::link::Encoders& answer) const {
    const auto now = read();
    answer.joints = joints;
    for (std::size_t i = 0; i < joints; ++i) {
      answer.position[i] = blind_[i] ? 0 : now.position[i];
      answer.speed[i] = now.speed[i];
    }
    answer.joint = hal::link::no_joint;
    answer.phase = static_cast<std::uint8_t>(phases_.phase());
  }

  /// False where there is no such action, or its values are no numbers of that kind.
  bool command(const hal::link::ArmCommand& wanted) {
    using hal::link::ArmAction;
    switch (static_cast<ArmAction>(wanted.action)) {
      case ArmAction::place:
        return place(wanted.values);
      case ArmAction::push:
        return push(wanted.values);
      case ArmAction::blind:
        for (std::size_t i = 0; i < joints; ++i)
          blind_[i] = (word_of(wanted.values[i]) << 1) != 0;  // neither 0 nor -0, by integers alone
        return true;
      case ArmAction::stop:
      case ArmAction::go:
        stopped_ = static_cast<ArmAction>(wanted.action) == ArmAction::stop;
        return true;
    }
    return false;
  }
  /// What it carries from now on. False, and nothing changes, where that is no body, or beyond the declared limit.
  bool carry([[maybe_unused]] const hal::link::ArmLoad& load) {
    if constexpr (carries) {
      const auto& c = load.com;
      const auto& j = load.inertia;
      return hold(PayloadBody<float>{load.mass, {c[0], c[1], c[2]}, {j[0], j[1], j[2], j[3], j[4], j[5]}});
    }
    return false;
  }

  /// As it is: rad or m, and per second; of elastic joints motors and springs.
  const X& state() const { return x_; }

 private:
  static Joints<R, float> joint_values(const Values& from) {
    Joints<R, float> to{};
    for (std::size_t i = 0; i < joints; ++i)
      to[static_cast<int>(i)] = from[i];
    return to;
  }
  template <class V>
  static auto real(const V& values) {
    if constexpr (is_stored_v<Number>)
      return to_real<float>(values);
    else
      return values;
  }

  /// One tick without good efforts, where frames are the time.
  void wait() {
    if (!free_running_) phases_.advance(times_, 1);
  }

  /// Efforts within the declared limits. Those of a controller whose drives are off are none.
  void take(const hal::link::Torque& request) {
    const auto phase = static_cast<DrivePhase>(request.phase);
    const bool off = phase == DrivePhase::idle || phase == DrivePhase::disabled;
    const auto tau = joint_values(off ? Values{} : request.tau);
    if constexpr (is_stored_v<Number>) {
      const auto kept = to_fixed<Tau>(tau);
      wanted_ = kept.values;
      tell(kept.status);
    } else {
      axial::Status found{};
      for (int i = static_cast<int>(joints); i-- > 0;) {
        constexpr const auto& limits = limits_of<R, Number>;
        const Number most = limits.joints[i].effort, asked = static_cast<Number>(tau[i]);
        wanted_[i] = asked > most ? most : asked < -most ? -most : asked;
        if (!(asked <= most && asked >= -most)) found = {axial::Status::Code::effort_limit, i};
      }
      for (int i = static_cast<int>(joints); i-- > 0;)
        if (!is_finite(tau[i])) found = {axial::Status::Code::not_finite, i};
      tell(found);
    }
  }
  /// Keeps the first that there is to say.
  void tell(const axial::Status& found) {
    if (found.ok() || told_ != Status::ok) return;
    told_ = link_status(found.code);
    joint_ = found.joint < 0 ? hal::link::no_joint : static_cast<std::uint8_t>(found.joint);
  }

  bool place(const Values& values) {
    finish();
    X there{};
    if constexpr (is_stored_v<Number>) {
      const auto kept = to_fixed<Positions<R, Number>>(joint_values(values));
      if (!kept.status.ok()) return false;
      Joined::place(there, kept.values);
    } else {
      Positions<R, Number> q{};
      if (!put(values, q)) return false;
      Joined::place(there, q);
    }
    x_ = there;
    encoders_.place(Joined::motors(x_));
    show();
    noise_.restart();
    return true;
  }
  bool hold(const PayloadBody<float>& body) {
    if constexpr (is_stored_v<Number>) {
      const auto kept = to_fixed_payload<S, typename Number::Word>(body);
      if (kept.status.ok()) this->in_.payload = kept.load;
      return kept.status.ok();
    } else {
      const bool carried = check_payload<S>(body).ok();
      const auto& [mass, com, j] = body;
      const auto n = [](float x) { return static_cast<Number>(x); };
      if (carried)
        this->in_.payload = {
            n(mass), {n(com.x), n(com.y), n(com.z)}, {n(j.xx), n(j.yy), n(j.zz), n(j.xy), n(j.xz), n(j.yz)}};
      return carried;
    }
  }
  bool push(const Values& values) {
    if constexpr (is_stored_v<Number>) {
      const auto kept = to_fixed<Tau>(joint_values(values));
      if (kept.status.ok()) pushed_ = kept.values;
      return kept.status.ok();
    } else {
      return put(values, pushed_);
    }
  }
  /// False, and nothing is put, where one is no number.
  template <class To>
  static bool put(const Values& values, To& to) {
    for (std::size_t i = 0; i < joints; ++i)
      if (!is_finite(values[i])) return false;
    for (std::size_t i = 0; i < joints; ++i)
      to[static_cast<int>(i)] = static_cast<Number>(values[i]);
    return true;
  }

  /// What acts now: the drives' share of what was asked for, their noise, and a hand's push.
  Tau acting() {
    Tau sum{};
    const std::uint32_t share = phases_.enabled() ? phases_.share(times_) : 0;
    for (int i = 0; i < static_cast<int>(joints); ++i) {
      if constexpr (is_stored_v<Number>) {
        using Word = typename Tau::Value::Word;
        const std::int64_t drive = integer::multiply(asked_[i].raw, static_cast<std::int32_t>(share)) >> 16;
        sum[i] = {detail::nearest_word<Word>(drive + pushed_[i].raw)};
      } else {
        sum[i] = asked_[i] * (static_cast<Number>(share) * Number(1.0F / 65536.0F)) + pushed_[i];
      }
    }
    if (phases_.enabled()) noise_.add(sum);
    return sum;
  }

  /// 1 ms. A step that is not made leaves the arm where it was, and is told.
  void move() {
    if (stopped_) return;
    finish();
    held_ = {Joined::efforts(acting(), pushed_), this->in_};
    Worker::begin([](void* arm) { static_cast<Arm*>(arm)->make_steps(); }, this);
    moving_ = true;
    if constexpr (!Worker::is_beside) finish();
  }
  void make_steps() {
    found_ = {};
    for (int k = 0; k < substeps; ++k) {
      const axial::Status each = step(held_);
      if (found_.ok()) found_ = each;
    }
    encoders_.follow(Joined::motors(x_));
  }
  /// Until then nobody but the worker looks at the arm.
  void finish() {
    if (!moving_) return;
    Worker::join();
    moving_ = false;
    if (moved_.ok()) moved_ = found_;
    show();
  }
  struct Reading {
    std::array<std::int32_t, joints> position{};
    std::array<float, joints> speed{};
  };
  Reading read_now() const {
    Reading now;
    const auto speed = real(encoders_.speeds(Joined::motors(x_)));
    for (std::size_t i = 0; i < joints; ++i) {
      const int k = static_cast<int>(i);
      now.position[i] = encoders_.counts(k);
      now.speed[i] = static_cast<float>(speed[k]);
    }
    return now;
  }
  /// What encoders tell: of a worker beside, what they told when it had done.
  Reading read() const {
    if constexpr (Worker::is_beside)
      return shown_;
    else
      return read_now();
  }
  void show() {
    if constexpr (Worker::is_beside) shown_ = read_now();
  }
  axial::Status step(const Held<S, Number>& held) {
    if constexpr (has_stops<M>)
      return advance_by(WithEndStops<S, Number, Held<S, Number>>(held, M::stops));
    else
      return advance_by(held);
  }
  template <class Drive>
  axial::Status advance_by(const Drive& drive) {
    constexpr auto one = static_cast<StepOf<S, Number>>(1e-3 / substeps);  // by the compiler: boards have no double
    if constexpr (knows_its_step<Method>)
      return axial::advance<Method>(x_, drive);
    else
      return axial::advance<Method>(x_, one, drive);
  }

  X x_{};
  ArmEncoders<R, Number> encoders_{};
  NoiseOf<typename Joined::Given, Number, M> noise_{};
  Tau wanted_{}, asked_{}, pushed_{};
  Held<S, Number> held_{};
  axial::Status found_{}, moved_{};  // of a tick's steps; of all since the last answer
  struct Nothing {};
  std::conditional_t<Worker::is_beside, Reading, Nothing> shown_{};
  DrivePhases phases_{};
  FallBackTimes times_{};
  Status told_ = Status::ok;
  std::uint8_t joint_ = hal::link::no_joint;
  std::uint32_t passed_ = 0, ticks_a_board_tick_ = 1;
  std::array<bool, hal::link::max_joints> blind_{};
  bool free_running_ = false, stopped_ = false, moving_ = false;
};

}  // namespace axial::apps::plant
