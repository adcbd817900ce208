// expect: this function does not know joints that share drives
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using R = axial::JointCoordinates<robots::Gripper>;
#else
using R = robots::Gripper;
#endif

auto tau(const axial::Joints<R, float>& u) { return axial::joint_torque<R, 0>(u, u, u); }
