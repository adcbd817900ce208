// Feed-forward current of one joint of an arm, for a field-oriented controller such as SimpleFOC's: the arm's model says
// what torque the joint needs, the drive's torque constant and gear make a current of it.
#include <axial_arduino.h>

struct Arm {
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, -9.81, 0.0),
      axial::revolute().mass(0.4).com(0.1, 0, 0).inertia_com(0, 0.001, 0.001).rotor_inertia(2e-6, 36.0),
      axial::revolute().a(0.2).mass(0.2).com(0.08, 0, 0).inertia_com(0, 0.0005, 0.0005).rotor_inertia(2e-6, 36.0));
};

const int joint = 0;                  // the joint that this controller drives
const float torque_constant = 0.05f;  // N m / A of the motor
const float gear = 36.0f;             // turns of the motor per turn of the joint
const float largest_current = 4.0f;   // A

// Replace these by your encoders and your trajectory.
axial::Joints<Arm, float> positions() { return {0.5f * sinf(millis() * 1e-3f), 0.2f}; }
axial::Joints<Arm, float> wanted_speeds() { return {0.5f * cosf(millis() * 1e-3f), 0.0f}; }
axial::Joints<Arm, float> wanted_accelerations() { return {-0.5f * sinf(millis() * 1e-3f), 0.0f}; }

float feed_forward_current() {
  const auto tau = axial::inverse_dynamics<Arm>(positions(), wanted_speeds(), wanted_accelerations());
  const float current = tau[joint] / (torque_constant * gear);
  if (!(current >= -largest_current)) return current < 0.0f ? -largest_current : 0.0f;  // NaN is no current
  return current > largest_current ? largest_current : current;
}

void setup() { Serial.begin(115200); }

void loop() {
  // With SimpleFOC: motor.feed_forward_current.q = feed_forward_current();
  Serial.println(feed_forward_current(), 4);
  delay(1);
}
