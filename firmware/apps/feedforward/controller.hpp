#pragma once
/// Joins the link's messages to the control layer: the only file of this app that knows both.

#include <axial/axial.hpp>

#include <hal/link/messages.hpp>

namespace axial::apps {

constexpr hal::link::TorqueStatus link_status(Status::Code code) {
  using hal::link::TorqueStatus;
  switch (code) {
    case Status::Code::ok:
      return TorqueStatus::ok;
    case Status::Code::effort_limit:
      return TorqueStatus::effort_limited;
    case Status::Code::not_finite:
      return TorqueStatus::not_finite;
    default:
      return TorqueStatus::outside_limits;
  }
}

/// One torque is load, compute, store; `compute` alone is what a user embeds, and what is measured.
template <class Scene>
class Controller {
 public:
  static constexpr std::size_t joints = static_cast<std::size_t>(joint_count<Scene>);
  static constexpr const char* name = robot_of<Scene>::name;

  void load(const hal::link::SetPoint& request) {
    copy(request.q, q_);
    copy(request.qd, qd_);
    copy(request.qdd, qdd_);
  }

  void compute() { result_ = feedforward<Scene>(state_, q_, qd_, qdd_); }

  void store(hal::link::Torque& answer) const {
    store_efforts(result_.tau, answer);
    answer.status = static_cast<std::uint8_t>(link_status(result_.status.code));
    answer.joint = result_.status.joint < 0 ? hal::link::no_joint : static_cast<std::uint8_t>(result_.status.joint);
  }

  /// The torque to hold while nothing is requested.
  void store_last_safe(hal::link::Torque& answer) const { store_efforts(state_.last_safe, answer); }

 private:
  using Values = Joints<robot_of<Scene>, float>;
  using Wire = std::array<float, hal::link::max_joints>;

  static void copy(const Wire& from, Values& to) {
    for (std::size_t i = 0; i < joints; ++i)
      to[static_cast<int>(i)] = from[i];
  }

  static void store_efforts(const Values& tau, hal::link::Torque& answer) {
    answer.joints = joints;
    for (std::size_t i = 0; i < joints; ++i)
      answer.tau[i] = tau[static_cast<int>(i)];
  }

  Values q_{}, qd_{}, qdd_{};
  FeedforwardState<Scene, float> state_{};
  FeedforwardResult<Scene, float> result_{};
};

}  // namespace axial::apps
