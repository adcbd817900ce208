// expect: torque rates do not know joints that share drives
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using R = axial::JointCoordinates<robots::Gripper>;
#else
using R = robots::Gripper;
#endif

auto rates(const axial::Joints<R, float>& u) { return axial::torque_rates<R>(u, u, u, u); }
