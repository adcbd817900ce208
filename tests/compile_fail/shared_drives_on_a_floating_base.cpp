// expect: joints that share drives do not go with FloatingBase or SineCosines
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using S = axial::Scene<robots::Gripper, axial::RuntimeGravity, axial::BaseMotion>;
#else
using S = axial::Scene<robots::Gripper, axial::RuntimeGravity, axial::FloatingBase>;
#endif

auto tau(const axial::Joints<robots::Gripper, float>& u, const axial::Inputs<S, float>& in) {
  return axial::inverse_dynamics<S>(u, u, u, in);
}
