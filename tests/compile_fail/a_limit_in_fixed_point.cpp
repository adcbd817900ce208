// expect: give every link a speed_limit()
// within: 5 lines
// at most: 12 lines
#include <axial/fixed.hpp>

#ifdef MENDED
#define LIMITS .speed_limit(1.0).acceleration_limit(1.0)
#else
#define LIMITS
#endif
struct Robot {
  static constexpr auto chain =
      axial::chain(axial::gravity(0.0, -9.81, 0.0), axial::revolute().mass(1.0).inertia_com(0.1, 0.1, 0.1) LIMITS);
};
using T = axial::Fixed32;
axial::Positions<Robot, T> q;
axial::Velocities<Robot, T> qd;
axial::Accelerations<Robot, T> qdd;
auto torque() { return axial::inverse_dynamics<Robot>(q, qd, qdd); }
