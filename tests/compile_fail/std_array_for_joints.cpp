// expect: joint values are axial::Joints<Robot, float>, not an array
// within: 5 lines
#include <array>
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Values = axial::Joints<robots::Scara, float>;
#else
using Values = std::array<float, 3>;
#endif

auto accelerate(const Values& q) { return axial::forward_dynamics<robots::Scara>(q, q, q); }
float effort(const Values& q) { return axial::joint_torque<robots::Scara, 1>(q, q, q); }
