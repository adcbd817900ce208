// expect: positions, velocities and accelerations are mixed up
// within: 5 lines
// at most: 12 lines
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

using namespace axial;
using R = robots::Scara;

auto effort(const Positions<R, Fixed32>& q, const Velocities<R, Fixed32>& qd) {
#ifdef MENDED
  return inverse_dynamics<Scene<R, Gravity>>(q, qd, Accelerations<R, Fixed32>{});
#else
  return inverse_dynamics<Scene<R, Gravity>>(qd, q, Accelerations<R, Fixed32>{});
#endif
}
