// expect: derivatives do not know joints that share drives
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using R = axial::JointCoordinates<robots::Gripper>;
#else
using R = robots::Gripper;
#endif

auto slopes(const axial::Joints<R, float>& u) { return axial::inverse_dynamics_derivatives<R>(u, u, u); }
