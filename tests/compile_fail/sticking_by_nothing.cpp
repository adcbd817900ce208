// expect: axial: what is held is held by dry friction or by end stops
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/sticking.hpp>
#include <robots/puma560.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Puma560, axial::Gravity, axial::RotorInertia, axial::Friction>;
#else
using Scene = axial::Scene<robots::Puma560, axial::Gravity, axial::RotorInertia>;
#endif

struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[6] = {}, damping[6] = {};
};

int main() {
  axial::Motion<Scene, axial::Fixed32> x;
  return static_cast<int>(axial::advance<axial::StickingFor<Soft>>(x, axial::Held<Scene, axial::Fixed32>{}).code);
}
