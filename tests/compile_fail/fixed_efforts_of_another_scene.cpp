// expect: these efforts are in the formats of another scene
// within: 5 lines
// at most: 12 lines
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

using namespace axial;
using R = robots::Scara;
using S = Scene<R, Gravity>;

auto motion(const Positions<R, Fixed32>& q, const Velocities<R, Fixed32>& qd) {
#ifdef MENDED
  return forward_dynamics<S>(q, qd, EffortsOf<S, Fixed32>{});
#else
  return forward_dynamics<S>(q, qd, Efforts<R, Fixed32>{});
#endif
}
