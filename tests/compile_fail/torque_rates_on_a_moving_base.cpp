// expect: torque rates are those of a base at rest
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using R = robots::Scara;
#ifdef MENDED
using S = axial::Scene<R, axial::RuntimeGravity>;
#else
using S = axial::Scene<R, axial::RuntimeGravity, axial::BaseMotion>;
#endif

auto rates(const axial::Joints<R, float>& q, const axial::Inputs<S, float>& in) {
  return axial::torque_rates<S>(q, q, q, q, in);
}
