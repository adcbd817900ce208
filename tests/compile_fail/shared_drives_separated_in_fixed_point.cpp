// expect: of joints that share drives have no formats in fixed point
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/gripper.hpp>

using R = robots::Gripper;
#ifdef MENDED
using T = double;
#else
using T = axial::Fixed32;
#endif

auto terms(const axial::Positions<R, T>& u) { return axial::separate<R>(u); }
