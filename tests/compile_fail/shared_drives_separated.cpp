// expect: this function does not know joints that share drives
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using R = axial::JointCoordinates<robots::Gripper>;
#else
using R = robots::Gripper;
#endif

auto terms(const axial::Joints<R, float>& u) { return axial::separate<R>(u); }
