// expect: joints of this robot share drives: add #include <axial/transmissions/shared_drives.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#ifdef MENDED
#include <axial/transmissions/shared_drives.hpp>
#endif
#include <robots/gripper.hpp>

auto tau(const axial::Joints<robots::Gripper, float>& u) { return axial::inverse_dynamics<robots::Gripper>(u, u, u); }
