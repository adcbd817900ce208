// expect: forward dynamics and separation in fixed point need a format per link
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <robots/gripper.hpp>

using R = robots::Gripper;
using T = axial::Fixed32;
#ifdef MENDED
using S = axial::Scene<R, axial::Gravity>;
#else
using S = axial::Scene<R, axial::Gravity, axial::Looped>;
#endif

auto terms(const axial::Positions<R, T>& u) { return axial::separate<S>(u); }
