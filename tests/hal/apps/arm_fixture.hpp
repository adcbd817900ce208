// Arms on the host's board, and what a controller and a host send to them.
#pragma once

#include <firmware/apps/plant/arm.hpp>

#include <limits>
#include <vector>

#include <robots/scara.hpp>

#include "app_fixture.hpp"

namespace axial::apps {

constexpr float nan_of = std::numeric_limits<float>::quiet_NaN();
constexpr double counts_a_rad = 4294967296.0 / 6.283185307179586;

using JointValues = std::array<float, link::max_joints>;

/// Where the SCARA's arm is placed, and what it weighs.
constexpr JointValues pose = {0.3F, -0.4F, 0.1F};
constexpr float slide = 1.25F, earth = 9.8125F;  // kg, m/s^2
constexpr JointValues balance = {0.0F, 0.0F, -slide* earth};
/// In which arms move; the host's is in double.
using Numbers = ::testing::Types<float, Fixed32>;

inline link::Torque efforts(const JointValues& tau, DrivePhase phase = DrivePhase::running, std::size_t joints = 3) {
  link::Torque out{};
  out.joints = joints, out.tau = tau, out.phase = byte_of(phase);
  return out;
}
inline link::ArmCommand command(link::ArmAction action, const JointValues& values = {}, std::size_t joints = 3) {
  return {joints, values, static_cast<std::uint8_t>(action)};
}

/// An arm on the host's board, on its line.
template <class R, class Number, class Worker = plant::OnThisCore>
class ArmApp : public App<plant::Arm<R, Number, 1, Worker>> {
 protected:
  static constexpr std::size_t joints = plant::Arm<R, Number, 1, Worker>::joints;

  link::Encoders ask(const JointValues& tau, std::uint32_t number, DrivePhase phase = DrivePhase::running) {
    this->send(this->framed(efforts(tau, phase, joints), number));
    return this->template answer<link::Encoders>().value();
  }
  link::Encoders tell(link::ArmAction action, const JointValues& values = {}) {
    this->send(this->framed(command(action, values, joints), 0));
    return this->template answer<link::Encoders>().value();
  }
  std::uint32_t refused(link::Fault fault) { return this->faults(fault); }
};

/// What an arm answers in lock-step, from where it is placed on; at the end four numbers are left out.
template <class R, class Number, class Worker = plant::OnThisCore>
class Answers : public ArmApp<R, Number, Worker> {
 public:
  void TestBody() override {}
  std::vector<link::Encoders> of(std::uint32_t ticks) {
    this->open(link::Mode::lock_step);
    std::vector<link::Encoders> all{this->tell(link::ArmAction::place, pose)};
    for (std::uint32_t k = 1; k <= ticks; ++k)
      all.push_back(this->ask({2.0F, -1.0F, 3.0F}, k));
    all.push_back(this->ask({2.0F, -1.0F, 3.0F}, ticks + 5));
    return all;
  }
};

}  // namespace axial::apps
