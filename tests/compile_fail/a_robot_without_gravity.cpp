// expect: axial: the chain does not say which way gravity pulls
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.81, 0.0), axial::revolute().mass(1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0));
#endif
};
auto torque(const axial::Joints<Robot, float>& q) { return axial::gravity_torque<Robot>(q); }
