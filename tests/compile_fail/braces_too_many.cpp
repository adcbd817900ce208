// expect: axial: braces hold one number for each joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

float torque(float q);
float torque(float q) {
#ifdef MENDED
  return axial::gravity_torque<robots::Scara>({q, q, q})[0];
#else
  return axial::gravity_torque<robots::Scara>({q, q, q, q, q, q})[0];
#endif
}
