// expect: axial::Positions<Robot, T> and its like of the robot, not of a scene
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using R = robots::Scara;
using S = axial::Scene<R, axial::Gravity, axial::Friction>;
using T = float;

#ifdef MENDED
using Of = R;
#else
using Of = S;
#endif

auto torque(const axial::Positions<Of, T>& q, const axial::Velocities<Of, T>& qd,
            const axial::Accelerations<Of, T>& qdd) {
  return axial::inverse_dynamics<S>(q, qd, qdd);
}
