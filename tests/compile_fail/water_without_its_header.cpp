// expect: axial: water is a header of its own: add #include <axial/base/water.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#ifdef MENDED
#include <axial/base/water.hpp>
#endif

#include <robots/planar2r.hpp>

using Scene = axial::Scene<robots::Planar2r, axial::Gravity, axial::Underwater>;
using Joints = axial::Joints<robots::Planar2r, float>;
auto torque(const Joints& q) { return axial::inverse_dynamics<Scene>(q, q, q); }
