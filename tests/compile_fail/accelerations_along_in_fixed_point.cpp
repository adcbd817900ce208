// expect: accelerations along a direction have no formats in fixed point
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = axial::Fixed32;
#endif
using R = robots::Scara;

auto change(const axial::Positions<R, Number>& q, const axial::Velocities<R, Number>& qd,
            const axial::EffortsOf<R, Number>& tau, const axial::StateDirection<R, Number>& direction) {
  return axial::forward_dynamics_along<R>(q, qd, tau, direction);
}
