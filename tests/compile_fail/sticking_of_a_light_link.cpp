// expect: axial: words lose a joint that moves by itself a hundred thousand times more easily than with all that it
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/sticking.hpp>

struct Pendulum {
#ifdef MENDED
  static constexpr double inertia = 0.01;
#else
  static constexpr double inertia = 1e-9;
#endif
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.81, 0.0),
                                             axial::revolute()
                                                 .mass(0.01)
                                                 .inertia_com(inertia, inertia, inertia)
                                                 .coulomb(0.1)
                                                 .speed_limit(4.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(5.0),
                                             axial::revolute()
                                                 .mass(100.0)
                                                 .inertia_com(60.0, 60.0, 100.0)
                                                 .speed_limit(4.0)
                                                 .acceleration_limit(20.0)
                                                 .effort_limit(5.0));
};
using Scene = axial::Scene<Pendulum, axial::Gravity, axial::Friction>;

struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[2] = {}, damping[2] = {};
};

int main() {
  axial::Motion<Scene, axial::Fixed32> x;
  return static_cast<int>(axial::advance<axial::StickingFor<Soft>>(x, axial::Held<Scene, axial::Fixed32>{}).code);
}
