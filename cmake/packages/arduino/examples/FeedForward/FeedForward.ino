// The torque that a two-link arm needs, every 10 ms.
#include <axial_arduino.h>

struct Arm {
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, -9.81, 0.0),
      axial::revolute().mass(0.4).com(0.1, 0, 0).inertia_com(0, 0.001, 0.001).speed_limit(6.0).effort_limit(2.0),
      axial::revolute().a(0.2).mass(0.2).com(0.08, 0, 0).inertia_com(0, 0.0005, 0.0005).speed_limit(8.0).effort_limit(1.0));
};

axial::FeedforwardState<Arm, float> state;  // the last safe torque

void setup() { Serial.begin(115200); }

void loop() {
  const float t = millis() * 1e-3f;
  const axial::Joints<Arm, float> q{0.5f * sinf(t), 0.3f * cosf(t)};
  const axial::Joints<Arm, float> qd{0.5f * cosf(t), -0.3f * sinf(t)};
  const axial::Joints<Arm, float> qdd{-0.5f * sinf(t), -0.3f * cosf(t)};
  const auto safe = axial::feedforward<Arm>(state, q, qd, qdd);
  if (!safe.status.ok()) Serial.println(axial::status_text(safe.status));
  Serial.print(safe.tau[0], 4);
  Serial.print(' ');
  Serial.println(safe.tau[1], 4);
  delay(10);
}
