// expect: axial: joint values are axial::Joints, or arrays with one number for each joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>

using M = axial::Model<3, axial::Gravity>;
float torque(const M& model, const float (&q)[3], const float (&few)[2]);
float torque(const M& model, const float (&q)[3], const float (&few)[2]) {
  static_cast<void>(few);
#ifdef MENDED
  return axial::gravity_torque(model, q)[0];
#else
  return axial::gravity_torque(model, few)[0];
#endif
}
