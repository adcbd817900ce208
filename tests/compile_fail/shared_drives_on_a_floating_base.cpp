// expect: forward dynamics of joints that share drives knows no free base
#include <axial/axial.hpp>
#include <robots/gripper.hpp>

#ifdef MENDED
using S = axial::Scene<robots::Gripper, axial::RuntimeGravity, axial::BaseMotion>;
#else
using S = axial::Scene<robots::Gripper, axial::RuntimeGravity, axial::FloatingBase>;
#endif

auto udd(const axial::Joints<robots::Gripper, float>& u, const axial::Inputs<S, float>& in) {
  return axial::forward_dynamics<S>(u, u, u, in);
}
