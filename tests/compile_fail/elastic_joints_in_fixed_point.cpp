// expect: torque rates have no formats in fixed point
#include <axial/fixed.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = axial::Fixed32;
#endif
struct Arm {
  static constexpr auto chain = axial::chain(axial::revolute()
                                                 .mass(1)
                                                 .com(0.5, 0, 0)
                                                 .stiffness(1000)
                                                 .position_limits(-1, 1)
                                                 .speed_limit(1)
                                                 .acceleration_limit(1)
                                                 .effort_limit(50));
};

auto drive(const axial::Positions<Arm, Number>& q, const axial::Velocities<Arm, Number>& qd,
           const axial::Accelerations<Arm, Number>& qdd, const axial::Joints<Arm, Number>& more) {
  return axial::elastic_feedforward<Arm>(q, qd, qdd, more, more);
}
