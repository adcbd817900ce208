// expect: axial: fixed point has no JointSprings
// within: 7 lines
// at most: 16 lines
#include <axial/fixed.hpp>

struct Robot {
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, -9.81, 0.0),
      axial::revolute().mass(1.0).inertia_com(0.1, 0.1, 0.1).speed_limit(1.0).acceleration_limit(1.0).spring(5.0));
};
#ifdef MENDED
using Scene = axial::Scene<Robot, axial::Gravity>;
#else
using Scene = axial::Scene<Robot, axial::Gravity, axial::JointSprings>;
#endif
using T = axial::Fixed32;
axial::Inputs<Scene, T> in;
auto torque(const axial::Positions<Robot, T>& q, const axial::Velocities<Robot, T>& qd,
            const axial::Accelerations<Robot, T>& qdd) {
  return axial::inverse_dynamics<Scene>(q, qd, qdd, in);
}
