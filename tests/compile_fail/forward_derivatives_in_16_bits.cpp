// expect: derivatives of forward dynamics in fixed point are those of Fixed32
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = axial::Fixed32;
#else
using Number = axial::Fixed16;
#endif
using R = robots::Scara;

auto slopes(const axial::Positions<R, Number>& q, const axial::Velocities<R, Number>& qd,
            const axial::EffortsOf<R, Number>& tau) {
  return axial::forward_dynamics_derivatives<R>(q, qd, tau);
}
