// expect: joints that share drives are solved by composite bodies
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using S = axial::Scene<robots::Gripper, axial::Gravity, axial::RotorInertia, axial::CompositeBody>;
#else
using S = axial::Scene<robots::Gripper, axial::Gravity, axial::RotorInertia, axial::ArticulatedBody>;
#endif

auto udd(const axial::Joints<robots::Gripper, float>& u) { return axial::forward_dynamics<S>(u, u, u); }
