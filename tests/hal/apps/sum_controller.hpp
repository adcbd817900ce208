#pragma once
/// A controller whose torque is plain to see: tau = q + 2 qd + 4 qdd; it refuses what is not finite.

#include <cmath>
#include <cstddef>

#include <hal/link/messages.hpp>

namespace axial::apps {

struct SumController {
  static constexpr std::size_t joints = 3;
  static constexpr const char* name = "sum";

  void torque(const hal::link::SetPoint& in, hal::link::Torque& out) {
    out.status = static_cast<std::uint8_t>(hal::link::TorqueStatus::ok);
    out.joint = hal::link::no_joint;
    for (std::size_t i = 0; i < joints; ++i) {
      const float tau = in.q[i] + 2.0f * in.qd[i] + 4.0f * in.qdd[i];
      if (!std::isfinite(tau)) return refuse(i, out);
      out.tau[i] = tau;
    }
    safe_ = out.tau;
  }

  void last_safe(hal::link::Torque& out) const { out.tau = safe_; }

 private:
  void refuse(std::size_t joint, hal::link::Torque& out) {
    out.tau = safe_;
    out.status = static_cast<std::uint8_t>(hal::link::TorqueStatus::not_finite);
    out.joint = static_cast<std::uint8_t>(joint);
  }

  std::array<float, hal::link::max_joints> safe_{};
};

}  // namespace axial::apps
