// expect: derivatives of forward dynamics of joints that share drives have no formats in fixed point
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/gripper.hpp>

using R = robots::Gripper;
#ifdef MENDED
using T = float;
#else
using T = axial::Fixed32;
#endif

auto slopes(const axial::Positions<R, T>& u, const axial::Velocities<R, T>& ud, const axial::Efforts<R, T>& tau) {
  return axial::forward_dynamics_derivatives<R>(u, ud, tau);
}
