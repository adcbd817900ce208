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

/// One torque is load, compute, store; `compute` alone is what a user embeds, and what is measured. The wire carries
/// float; `Number` is what the control layer computes in: float, or fixed point, to and from which load and store
/// convert.
template <class Scene, class Number = float>
class Controller {
 protected:
  using Robot = robot_of<Scene>;
  using Real = Joints<Robot, float>;

 public:
  static constexpr std::size_t joints = static_cast<std::size_t>(joint_count<Scene>);
  static constexpr const char* name = Robot::name;

  void load(const hal::link::SetPoint& request) {
    if constexpr (is_stored_v<Number>)
      request_ = to_fixed_request<Scene, typename Number::Word>(real(request.q), real(request.qd), real(request.qdd));
    else
      request_ = {real(request.q), real(request.qd), real(request.qdd), {}};
  }

  void compute() {
    if constexpr (is_stored_v<Number>) {
      if (!request_.status.ok()) {  // it was brought within limits: not what was asked
        result_ = {state_.last_safe, request_.status};
        return;
      }
    }
    result_ = feedforward<Scene>(state_, request_.q, request_.qd, request_.qdd);
  }

  void store(hal::link::Torque& answer) const {
    store_efforts(result_.tau, answer);
    answer.status = static_cast<std::uint8_t>(link_status(result_.status.code));
    answer.joint = result_.status.joint < 0 ? hal::link::no_joint : static_cast<std::uint8_t>(result_.status.joint);
  }

  /// The torque to hold while nothing is requested.
  void store_last_safe(hal::link::Torque& answer) const { store_efforts(state_.last_safe, answer); }

 protected:
  static Real real(const std::array<float, hal::link::max_joints>& from) {
    Real to{};
    for (std::size_t i = 0; i < joints; ++i)
      to[static_cast<int>(i)] = from[i];
    return to;
  }

  static void store_efforts(const EffortsOf<Scene, Number>& efforts, hal::link::Torque& answer) {
    Real tau{};
    if constexpr (is_stored_v<Number>)
      tau = to_real<float>(efforts);
    else
      tau = efforts;
    answer.joints = joints;
    for (std::size_t i = 0; i < joints; ++i)
      answer.tau[i] = tau[static_cast<int>(i)];
  }

  Request<Scene, Number> request_{};
  FeedforwardState<Scene, Number> state_{};
  FeedforwardResult<Scene, Number> result_{};
};

}  // namespace axial::apps
