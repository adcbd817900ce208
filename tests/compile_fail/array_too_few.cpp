// expect: axial: no such call: inverse_dynamics<Robot>(q, qd, qdd) is what there is
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

float torque(const float (&q)[3], const float (&qd)[3], const float (&qdd)[3]);
float torque(const float (&q)[3], const float (&qd)[3], const float (&qdd)[3]) {
  static_cast<void>(qdd);
#ifdef MENDED
  return axial::inverse_dynamics<robots::Scara>(q, qd, qdd)[0];
#else
  return axial::inverse_dynamics<robots::Scara>(q, qd)[0];
#endif
}
