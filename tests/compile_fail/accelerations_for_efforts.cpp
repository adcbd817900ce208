// expect: positions, velocities and accelerations are mixed up
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using R = robots::Scara;

auto motion(const axial::JointPositions<R>& q, const axial::JointVelocities<R>& qd) {
#ifdef MENDED
  return axial::forward_dynamics<R>(q, qd, axial::Efforts<R, float>{});
#else
  return axial::forward_dynamics<R>(q, qd, axial::JointAccelerations<R>{});
#endif
}
