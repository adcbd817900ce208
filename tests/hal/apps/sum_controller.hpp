#pragma once
/// A controller whose torque is plain to see: tau = q + 2 qd + 4 qdd; it refuses what is not finite.

#include <cmath>
#include <cstddef>

#include <hal/link/messages.hpp>

namespace axial::apps {

class SumController {
 public:
  static constexpr std::size_t joints = 3;
  static constexpr const char* name = "sum";

  void load(const hal::link::SetPoint& request) { request_ = request; }

  void compute() {
    result_ = {joints, safe_, 0, static_cast<std::uint8_t>(hal::link::TorqueStatus::ok), hal::link::no_joint};
    for (std::size_t i = 0; i < joints; ++i) {
      const float tau = request_.q[i] + 2.0f * request_.qd[i] + 4.0f * request_.qdd[i];
      if (!std::isfinite(tau)) return refuse(i);
      result_.tau[i] = tau;
    }
    safe_ = result_.tau;
  }

  void store(hal::link::Torque& answer) const { answer = result_; }
  void store_last_safe(hal::link::Torque& answer) const { answer.tau = safe_; }

 private:
  void refuse(std::size_t joint) {
    result_.tau = safe_;
    result_.status = static_cast<std::uint8_t>(hal::link::TorqueStatus::not_finite);
    result_.joint = static_cast<std::uint8_t>(joint);
  }

  hal::link::SetPoint request_{};
  hal::link::Torque result_{};
  std::array<float, hal::link::max_joints> safe_{};
};

}  // namespace axial::apps
