// expect: from what each link resists by itself
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

struct Robot {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, -9.81),
                                             axial::revolute()
                                                 .speed_limit(3.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(5.0)
#ifdef MENDED
                                                 .mass(1.0)
                                                 .inertia_com(0.01, 0.01, 0.02)
#endif
                                                 ,
                                             axial::revolute()
                                                 .a(0.2)
                                                 .mass(1.0)
                                                 .com(0.1, 0, 0)
                                                 .inertia_com(0.01, 0.01, 0.02)
                                                 .speed_limit(3.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(5.0));
};
using Scene = axial::Scene<Robot, axial::Gravity, axial::Looped>;
using axial::Fixed32;
auto derivatives(const axial::Positions<Robot, Fixed32>& q, const axial::Velocities<Robot, Fixed32>& qd,
                 const axial::EffortsOf<Scene, Fixed32>& tau) {
  return axial::forward_dynamics_derivatives<Scene>(q, qd, tau);
}
