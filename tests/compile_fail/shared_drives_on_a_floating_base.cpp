// expect: joints that share drives do not go with FloatingBase, SineCosines or ExternalWrenches
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using S = axial::Scene<robots::Gripper, axial::Gravity, axial::TipWrench>;
#else
using S = axial::Scene<robots::Gripper, axial::Gravity, axial::ExternalWrenches>;
#endif

auto tau(const axial::Joints<robots::Gripper, float>& u, const axial::Inputs<S, float>& in) {
  return axial::inverse_dynamics<S>(u, u, u, in);
}
