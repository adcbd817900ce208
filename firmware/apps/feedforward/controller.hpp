#pragma once
/// Joins the link's messages to the dynamics: the only file of this app that knows both.

#include <axial/axial.hpp>

#include <hal/link/messages.hpp>

namespace axial::apps {

template <class Robot>
class Controller {
 public:
  static constexpr std::size_t joints = static_cast<std::size_t>(joint_count<Robot>);
  static constexpr const char* name = Robot::name;

  void torque(const hal::link::SetPoint& in, hal::link::Torque& out) {
    Joints<Robot, float> q{}, qd{}, qdd{};
    for (std::size_t i = 0; i < joints; ++i) {
      const int joint = static_cast<int>(i);
      q[joint] = in.q[i];
      qd[joint] = in.qd[i];
      qdd[joint] = in.qdd[i];
    }
    const auto tau = inverse_dynamics<Robot>(q, qd, qdd);
    for (std::size_t i = 0; i < joints; ++i) safe_[i] = out.tau[i] = tau[static_cast<int>(i)];
    out.status = static_cast<std::uint8_t>(hal::link::TorqueStatus::ok);
    out.joint = hal::link::no_joint;
  }

  void last_safe(hal::link::Torque& out) const { out.tau = safe_; }

 private:
  std::array<float, hal::link::max_joints> safe_{};
};

}  // namespace axial::apps
