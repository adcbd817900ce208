// expect: derivatives of forward dynamics have no formats in fixed point
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = axial::Fixed32;
#endif
using R = robots::Scara;

auto slopes(const axial::Positions<R, Number>& q, const axial::Velocities<R, Number>& qd,
            const axial::EffortsOf<R, Number>& tau) {
  return axial::forward_dynamics_derivatives<R>(q, qd, tau);
}
