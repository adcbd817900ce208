// expect: axial: a robot is a struct with static constexpr auto chain = axial::chain(...)
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.81, 0.0), axial::revolute().mass(1.0));
#endif
};
axial::Joints<Robot, float> q;
auto torque() { return axial::inverse_dynamics<Robot>(q, q, q)[0]; }
