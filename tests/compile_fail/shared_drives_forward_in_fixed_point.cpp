// expect: of joints that share drives in fixed point is that of Fixed32
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/gripper.hpp>

using R = robots::Gripper;
#ifdef MENDED
using T = axial::Fixed32;
#else
using T = axial::Fixed16;
#endif
using Q = axial::Positions<R, T>;
using V = axial::Velocities<R, T>;

auto udd(const Q& u, const V& ud, const axial::Efforts<R, T>& tau) { return axial::forward_dynamics<R>(u, ud, tau); }
