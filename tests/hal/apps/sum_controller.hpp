#pragma once
/// A controller whose torque is plain to see: tau = q + 2 qd + 4 qdd, held by tau = q; it refuses what is not finite.

#include <cmath>
#include <cstddef>

#include <axial/control/drive_phase.hpp>

#include <hal/link/messages.hpp>

namespace axial::apps {

class SumController {
  using Values = std::array<float, hal::link::max_joints>;

 public:
  static constexpr std::size_t joints = 3;
  static constexpr const char* name = "sum";

  void load(const hal::link::SetPoint& request) { request_ = request; }

  void compute() {
    status_ = hal::link::TorqueStatus::ok;
    joint_ = hal::link::no_joint;
    for (std::size_t i = 0; i < joints; ++i) {
      tau_[i] = request_.q[i] + 2.0f * request_.qd[i] + 4.0f * request_.qdd[i];
      if (!std::isfinite(tau_[i]) && joint_ == hal::link::no_joint) {
        status_ = hal::link::TorqueStatus::not_finite;
        joint_ = static_cast<std::uint8_t>(i);
      }
    }
  }

  void settle(const hal::link::SetPoint& request) {
    if (status_ != hal::link::TorqueStatus::ok) {
      for (std::size_t i = 0; i < joints; ++i)
        if (!std::isfinite(request.q[i])) return;
      if (phases_.hold()) q_ = request.q;
    } else if (phases_.follow()) {
      q_ = request.q;
      last_ = tau_;
    } else {
      status_ = hal::link::TorqueStatus::disabled;
    }
  }

  void store(hal::link::Torque& answer) const {
    store_exerted(answer);
    answer.status = static_cast<std::uint8_t>(status_);
    answer.joint = joint_;
  }
  void store_exerted(hal::link::Torque& answer) const {
    const float share = static_cast<float>(phases_.share(times_)) / 65536.0f;
    answer.joints = joints;
    for (std::size_t i = 0; i < joints; ++i)
      answer.tau[i] = phases_.enabled() ? q_[i] + share * (last_[i] - q_[i]) : 0.0f;
    answer.phase = static_cast<std::uint8_t>(phases_.phase());
  }

  void set_times(const FallBackTimes& times) { times_ = times; }
  void advance(std::uint32_t ticks) { phases_.advance(times_, ticks); }
  void restart() { phases_.rearm(); }
  DrivePhase phase() const { return phases_.phase(); }

 private:
  hal::link::SetPoint request_{};
  Values tau_{}, q_{}, last_{};
  DrivePhases phases_{};
  FallBackTimes times_{};
  hal::link::TorqueStatus status_ = hal::link::TorqueStatus::ok;
  std::uint8_t joint_ = hal::link::no_joint;
};

}  // namespace axial::apps
