// expect: the robot has no such joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
constexpr int joint = 2;
#else
constexpr int joint = 3;
#endif

float effort(const axial::Joints<robots::Scara, float>& q) {
  return axial::joint_torque<robots::Scara, joint>(q, q, q);
}
