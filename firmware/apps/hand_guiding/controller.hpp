#pragma once
/// An arm that a hand guides or that follows set-points, by the two safe calls alone.

#include <firmware/apps/feedforward/deadlines.hpp>
#include <firmware/apps/tracking/controller.hpp>

#include "loop_words.hpp"

namespace axial::apps {

/// The arm, and what it carries in its hand.
template <class Robot>
using GuidedScene = Scene<Robot, Gravity, RotorInertia, Payload>;

/// A gripper of half a kilogram, in the tool's frame.
constexpr PayloadBody<double> gripper{0.5, {0.01, 0.0, 0.04}, {6e-4, 8e-4, 5e-4, 0.0, 0.0, 0.0}};

/// Each measurement says what is wanted: gravity compensation, or the set-point tracked; every set-point takes a
/// measurement of its own. Efforts change by no more than their whole range in the fall-back's ramp for as long as the
/// drives are enabled: track() and compensate_gravity() see to it while requests are good, a ramp behind the fall-back
/// when they are not. One tick moves them once.
template <class Robot, class Number = float>
class HandGuidingController : public Controller<GuidedScene<Robot>, Number> {
  using S = GuidedScene<Robot>;
  using Base = Controller<S, Number>;
  using typename Base::Q;
  using typename Base::Tau;
  using Words = LoopWords<S, Number>;
  static constexpr PayloadBody<Number> held = Words::payload(mounted_payload<S>(gripper));

 public:
  constexpr HandGuidingController() {
    this->in_.payload = held;
    loop_.output.step = Words::steps(ramp_ms * control_Hz / 1000);
  }

  void measure(const hal::link::Measurement& measurement) {
    const Q last = seen_.q;
    seen_.q = Encoders<S, Number>::positions(measurement.position);
    seen_.qd = Words::speeds(seen_.q, started_ ? last : seen_.q);
    tracks_ = measurement.feeds_forward != 0;
    measured_ = ever_measured_ = started_ = true;
  }

  void compute() {
    loop_.output.last = exerted_.last;
    if (!measured_)
      this->result_ = {exerted_.last, {Status::Code::not_ready, -1}};
    else if (tracks_)
      this->result_ = track<S>(loop_, this->request_, seen_, Words::gains, this->in_);
    else
      this->result_ = guide();
  }

  void settle(const hal::link::SetPoint&) {
    if (this->met())
      this->follow(seen_.q, this->result_.tau);
    else
      refuse();
    measured_ = false;
    if (!moved_) exert();
    moved_ = false;
  }

  void store(hal::link::Torque& answer) const {
    store_exerted(answer);
    this->store_status(answer);
  }
  void store_exerted(hal::link::Torque& answer) const { this->put(exerted_.last, answer); }

  void set_times(const FallBackTimes& times) {
    Base::set_times(times);
    exerted_.step = Words::steps(times.ramp);
  }

  void advance(std::uint32_t ticks) {
    this->fall_back_.advance(ticks);
    if (this->phase() != DrivePhase::running) started_ = false;
    moved_ = exert();
  }

  void restart() {
    Base::restart();
    measured_ = ever_measured_ = started_ = false;
  }

 private:
  /// A set-point that is none means a host that is not well, whoever guides.
  FeedforwardResult<S, Number> guide() {
    const auto& wanted = this->request_;
    const Status asked = wanted.status.ok() ? check_request<S>(wanted.q, wanted.qd, wanted.qdd) : wanted.status;
    auto result = compensate_gravity<S>(loop_, seen_.q, this->in_);
    if (result.status.met() && !asked.ok()) result.status = asked;
    return result;
  }

  /// Before anything was good the arm is held where the encoders see it.
  void refuse() {
    this->status_ = measured_ ? link_status(this->result_.status.code) : hal::link::TorqueStatus::not_measured;
    if (ever_measured_) (void)this->fall_back_.hold_at(seen_.q, this->in_);  // or it is held already
    started_ = false;
  }

  /// Moves what is exerted towards what the fall-back asks for; true where it moved. Disabled drives exert nothing.
  bool exert() {
    const Tau before = exerted_.last;
    Tau tau = this->fall_back_.torque();
    if (this->fall_back_.enabled())
      (void)exerted_.limit(tau);  // the status is that of the request
    else
      exerted_.last = tau;
    return Words::differ(before, exerted_.last);
  }

  SafeLoopState<S, Number> loop_{};
  EffortRamp<S, Number> exerted_{};
  MeasuredMotion<S, Number> seen_{};
  bool tracks_ = false, started_ = false, measured_ = false, ever_measured_ = false, moved_ = false;
};

}  // namespace axial::apps
