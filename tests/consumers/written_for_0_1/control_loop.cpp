// What a control loop embeds: tracking, hand guiding, a fall-back.
#include "arm.hpp"

#include <cmath>

int main() {
  using Joints = axial::Joints<Arm, float>;
  const Joints q{0.3F, -0.5F, 0.1F}, still{};
  const axial::Request<Arm, float> desired{q, still, still, {}};
  const axial::MeasuredMotion<Arm, float> measured{q, still, {}};
  const axial::TrackingGains<Arm, float> gains{{100, 100, 100}, {10, 10, 10}};
  axial::SafeLoopState<Arm, float> state;
  for (int i = 0; i < axial::joint_count<Arm>; ++i)
    state.output.step[i] = axial::limits_of<Arm, float>.joints[i].effort;
  const auto answer = axial::track<Arm>(state, desired, measured, gains);
  const auto weight = axial::compensate_gravity<Arm>(state, q);
  bool right = answer.status.met() && weight.status.met() && std::fabs(answer.tau[2] - weight.tau[2]) < 1e-3F;

  axial::FallBack<Arm, float> fall_back;
  right = right && fall_back.follow(q, answer.tau) && fall_back.phase() == axial::DrivePhase::running &&
          fall_back.enabled();
  fall_back.advance(2000);
  return right && fall_back.phase() == axial::DrivePhase::disabled && !fall_back.enabled() ? 0 : 1;
}
