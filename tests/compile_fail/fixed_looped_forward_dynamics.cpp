// expect: take Looped out
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

struct Robot {
  static constexpr auto chain =
      axial::chain(axial::gravity(0.0, 0.0, -9.81), axial::revolute()
                                                        .mass(1.0)
                                                        .com(0.1, 0, 0)
                                                        .inertia_com(0.01, 0.01, 0.02, 0, 0, 0)
                                                        .speed_limit(3.0)
                                                        .acceleration_limit(10.0)
                                                        .effort_limit(5.0));
};
#ifdef MENDED
using Scene = axial::Scene<Robot, axial::Gravity>;
#else
using Scene = axial::Scene<Robot, axial::Gravity, axial::Looped>;
#endif
using axial::Fixed32;
auto accelerations(const axial::Positions<Robot, Fixed32>& q, const axial::Velocities<Robot, Fixed32>& qd,
                   const axial::EffortsOf<Scene, Fixed32>& tau) {
  return axial::forward_dynamics<Scene>(q, qd, tau);
}
