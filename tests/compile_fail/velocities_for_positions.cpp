// expect: positions, velocities and accelerations are mixed up
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using R = robots::Scara;

auto torque(const axial::JointPositions<R>& q, const axial::JointVelocities<R>& qd) {
#ifdef MENDED
  return axial::inverse_dynamics<R>(q, qd, axial::JointAccelerations<R>{});
#else
  return axial::inverse_dynamics<R>(qd, q, axial::JointAccelerations<R>{});
#endif
}
