// expect: derivatives in fixed point have no payload
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

struct Arm : robots::Scara {
  static constexpr auto payload_limit = axial::PayloadLimit{0.5, 0.02, 0.001};
};
#ifdef MENDED
using Number = float;
#else
using Number = axial::Fixed32;
#endif
using S = axial::Scene<Arm, axial::Gravity, axial::Payload>;

auto slopes(const axial::Positions<Arm, Number>& q, const axial::Velocities<Arm, Number>& qd,
            const axial::Accelerations<Arm, Number>& qdd) {
  return axial::inverse_dynamics_derivatives<S>(q, qd, qdd);
}
