// expect: derivatives in fixed point have no payload
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = axial::Fixed32;
#endif
using R = robots::Scara;
using S = axial::Scene<R, axial::Gravity, axial::Payload>;

auto slopes(const axial::Positions<R, Number>& q, const axial::Velocities<R, Number>& qd,
            const axial::Accelerations<R, Number>& qdd) {
  return axial::inverse_dynamics_derivatives<S>(q, qd, qdd);
}
