// expect: give every link an inertia about its joint's axis
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#ifdef MENDED
constexpr double inertia = 0.01;
#else
constexpr double inertia = 0.0;
#endif
struct Robot {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, 0.0, -9.81),
                                             axial::revolute()
                                                 .inertia_com(0, 0, inertia)
                                                 .accept(axial::as_published)
                                                 .speed_limit(3.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(5.0),
                                             axial::revolute()
                                                 .a(0.1)
                                                 .mass(1.0)
                                                 .com(0.1, 0, 0)
                                                 .inertia_com(0.01, 0.01, 0.02, 0, 0, 0)
                                                 .speed_limit(3.0)
                                                 .acceleration_limit(10.0)
                                                 .effort_limit(5.0));
};
using axial::Fixed32;
auto accelerations(const axial::Positions<Robot, Fixed32>& q, const axial::Velocities<Robot, Fixed32>& qd,
                   const axial::EffortsOf<Robot, Fixed32>& tau) {
  return axial::forward_dynamics<Robot>(q, qd, tau);
}
