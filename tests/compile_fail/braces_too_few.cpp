// expect: axial: braces hold one number for each joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

float torque(const float (&q)[3]);
float torque(const float (&q)[3]) {
#ifdef MENDED
  return axial::inverse_dynamics<robots::Scara>(q, {0, 0, 0}, {0, 0, 0})[0];
#else
  return axial::inverse_dynamics<robots::Scara>(q, {0}, {0, 0, 0})[0];
#endif
}
