// expect: derivatives of forward dynamics know no free base
#include <axial/axial.hpp>
#include <robots/scara.hpp>

using R = robots::Scara;
#ifdef MENDED
using S = axial::Scene<R, axial::RuntimeGravity, axial::BaseMotion>;
#else
using S = axial::Scene<R, axial::RuntimeGravity, axial::FloatingBase>;
#endif

auto slopes(const axial::Joints<R, float>& q, const axial::EffortsOf<S, float>& tau,
            const axial::Inputs<S, float>& in) {
  return axial::forward_dynamics_derivatives<S>(q, q, tau, in);
}
