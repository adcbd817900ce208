#pragma once
/// The tracking loop of an arm whose joints are elastic and whose encoders are on its motors.

#include <firmware/apps/tracking/controller.hpp>

#include "elastic_robot.hpp"

namespace axial::apps {

/// As TrackingController, with the feed-forward of elastic joints: torque and position of each motor for a motion of
/// the links with four derivatives. The feedback's error is theta - what the encoder says. Asked to, it takes the
/// joints as rigid: the same gains, q in theta's place (hal::link::FeedForward). A set-point without its third and
/// fourth derivative is refused as one without a measurement. What the fall-back holds are positions of motors.
template <class Scene>
class ElasticController : public TrackingController<Scene, float> {
  using Tracking = TrackingController<Scene, float>;
  using Plain = Controller<Scene, float>;
  using Real = Joints<robot_of<Scene>, float>;

 public:
  void take(const hal::link::Derivatives& derivatives) {
    q3_ = Plain::real(derivatives.q3), q4_ = Plain::real(derivatives.q4);
    complete_ = true;
  }
  void measure(const hal::link::Measurement& measurement) {
    Tracking::measure(measurement);
    as_rigid_ = measurement.feeds_forward == static_cast<std::uint8_t>(hal::link::FeedForward::rigid);
  }

  void compute() {
    Plain::compute();
    this->sum_ = this->result_.tau;
    if (this->met() && !as_rigid_) look_through_the_springs();
    if (this->met()) this->add_feedback();
  }

  void settle(const hal::link::SetPoint& request) {
    if (!complete_) this->forget_measurement();
    complete_ = false;
    Tracking::settle(request);
  }

  void restart() {
    Tracking::restart();
    complete_ = false;
  }

 private:
  void look_through_the_springs() {
    auto& wanted = this->request_;
    const auto motors = elastic_feedforward<Scene>(wanted.q, wanted.qd, wanted.qdd, q3_, q4_);
    const Status status = check_finite(motors.tau_m, motors.theta);
    if (!status.ok()) {
      this->result_.status = status;
      return;
    }
    this->sum_ = motors.tau_m;
    wanted.q = motors.theta;  // from here on the request is about the motors
  }

  Real q3_{}, q4_{};
  bool as_rigid_ = false, complete_ = false;
};

}  // namespace axial::apps
