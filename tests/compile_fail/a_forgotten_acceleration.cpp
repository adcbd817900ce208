// expect: axial: no such call: inverse_dynamics<Robot>(q, qd, qdd)
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>

struct Robot {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.81, 0.0), axial::revolute().mass(1.0));
};
axial::Joints<Robot, float> torque(const axial::Joints<Robot, float>& q) {
#ifdef MENDED
  return axial::inverse_dynamics<Robot>(q, q, q);
#else
  return axial::inverse_dynamics<Robot>(q, q);
#endif
}
