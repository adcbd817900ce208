#pragma once
/// Joins the link's messages to the control layer: the only file of this app that knows both.

#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <hal/link/messages.hpp>

namespace axial::apps {

constexpr hal::link::TorqueStatus link_status(Status::Code code) {
  using hal::link::TorqueStatus;
  switch (code) {
    case Status::Code::ok:
      return TorqueStatus::ok;
    case Status::Code::effort_limit:
    case Status::Code::effort_rate:
    case Status::Code::command_limit:
    case Status::Code::current_limit:
      return TorqueStatus::effort_limited;
    case Status::Code::not_finite:
      return TorqueStatus::not_finite;
    default:
      return TorqueStatus::outside_limits;
  }
}

/// The run-time inputs of a controller's scene; of one that names none they take no byte.
template <class Scene, class Number, bool any = has_run_time_inputs<Scene, Number>>
struct GivenInputs {
  Inputs<Scene, Number> in_{};
};
template <class Scene, class Number>
struct GivenInputs<Scene, Number, false> {
  static constexpr Inputs<Scene, Number> in_{};
};

/// One torque is load, compute, settle, store; `compute` alone is what is measured. The wire carries float; `Number` is
/// what the control layer computes in: float, or fixed point, to and from which load and store convert. What is stored
/// is what the fall-back exerts, whatever was asked for.
template <class Scene, class Number = float>
class Controller : protected GivenInputs<Scene, Number> {
 protected:
  using Robot = robot_of<Scene>;
  using Real = Joints<Robot, float>;
  using Tau = EffortsOf<Scene, Number>;
  using Q = Positions<Robot, Number>;

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
    result_ = feedforward<Scene>(state_, request_.q, request_.qd, request_.qdd, this->in_);
  }

  /// Gives the request to the fall-back: to follow; or, where it was refused, to hold the arm at its position.
  void settle(const hal::link::SetPoint& request) {
    if (met())
      follow(result_.tau);
    else
      hold_at(request);
  }

  void store(hal::link::Torque& answer) const {
    store_exerted(answer);
    store_status(answer);
  }

  /// The torque now, and what the drives are doing.
  void store_exerted(hal::link::Torque& answer) const { put(fall_back_.torque(), answer); }

  void set_times(const FallBackTimes& times) { fall_back_.set_times(times); }
  void advance(std::uint32_t ticks) { fall_back_.advance(ticks); }
  /// A session begins.
  void restart() { fall_back_.rearm(); }
  DrivePhase phase() const { return fall_back_.phase(); }

 protected:
  bool met() const { return result_.status.met(); }

  void store_status(hal::link::Torque& answer) const {
    answer.status = static_cast<std::uint8_t>(status_);
    answer.joint = result_.status.joint < 0 ? hal::link::no_joint : static_cast<std::uint8_t>(result_.status.joint);
  }

  /// Efforts as the wire carries them, and what the drives are doing.
  void put(const Tau& efforts, hal::link::Torque& answer) const {
    Real tau{};
    if constexpr (is_stored_v<Number>)
      tau = to_real<float>(efforts);
    else
      tau = efforts;
    answer.joints = joints;
    for (std::size_t i = 0; i < joints; ++i)
      answer.tau[i] = tau[static_cast<int>(i)];
    answer.phase = static_cast<std::uint8_t>(fall_back_.phase());
  }

  void follow(const Tau& tau) { follow(request_.q, tau); }
  void follow(const Q& q, const Tau& tau) {
    const bool followed = fall_back_.follow(q, tau, this->in_);
    status_ = followed ? link_status(result_.status.code) : hal::link::TorqueStatus::disabled;
  }

  /// True where the fall-back begins to hold.
  bool hold_at(const hal::link::SetPoint& request) {
    status_ = link_status(result_.status.code);
    if constexpr (is_stored_v<Number>) {
      const auto position = to_fixed<Q>(real(request.q));
      return position.status.ok() && fall_back_.hold_at(position.values, this->in_);
    } else {
      return fall_back_.hold_at(real(request.q), this->in_);
    }
  }

  static Real real(const std::array<float, hal::link::max_joints>& from) {
    Real to{};
    for (std::size_t i = 0; i < joints; ++i)
      to[static_cast<int>(i)] = from[i];
    return to;
  }

  Request<Scene, Number> request_{};
  FeedforwardState<Scene, Number> state_{};
  FeedforwardResult<Scene, Number> result_{};
  FallBack<Scene, Number> fall_back_{};
  hal::link::TorqueStatus status_ = hal::link::TorqueStatus::ok;
};

}  // namespace axial::apps
