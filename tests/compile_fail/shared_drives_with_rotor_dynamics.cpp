// expect: joints that share drives do not go with RotorDynamics
#include <axial/axial.hpp>
#include <axial/dynamics/rotor_dynamics.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using S = axial::Scene<robots::Gripper, axial::Gravity, axial::RotorInertia>;
#else
using S = axial::Scene<robots::Gripper, axial::Gravity, axial::RotorInertia, axial::RotorDynamics>;
#endif

auto tau(const axial::Joints<robots::Gripper, float>& u) { return axial::inverse_dynamics<S>(u, u, u); }
