// expect: joints that share drives have no formats in fixed point
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/wrist_arm.hpp>

using R = robots::WristArm;
#ifdef MENDED
auto tau(const axial::Joints<R, float>& u) { return axial::inverse_dynamics<R>(u, u, u); }
#else
using T = axial::Fixed32;
auto tau(const axial::Positions<R, T>& u, const axial::Velocities<R, T>& ud, const axial::Accelerations<R, T>& udd) {
  return axial::inverse_dynamics<R>(u, ud, udd);
}
#endif
