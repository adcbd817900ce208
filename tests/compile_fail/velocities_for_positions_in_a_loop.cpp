// expect: positions, velocities and accelerations are mixed up
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using R = robots::Scara;

auto torque(axial::FeedforwardState<R, float>& state, const axial::JointPositions<R>& q,
            const axial::JointVelocities<R>& qd) {
#ifdef MENDED
  return axial::feedforward<R>(state, q, qd, axial::JointAccelerations<R>{});
#else
  return axial::feedforward<R>(state, q, axial::JointAccelerations<R>{}, qd);
#endif
}
