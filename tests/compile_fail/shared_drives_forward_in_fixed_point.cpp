// expect: of joints that share drives have no formats in fixed point
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/gripper.hpp>

using R = robots::Gripper;
using T = axial::Fixed32;
using Q = axial::Positions<R, T>;
using V = axial::Velocities<R, T>;
#ifdef MENDED
auto udd(const Q& u, const V& ud) { return axial::bias_torque<R>(u, ud); }
#else
auto udd(const Q& u, const V& ud, const axial::Efforts<R, T>& tau) { return axial::forward_dynamics<R>(u, ud, tau); }
#endif
