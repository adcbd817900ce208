// expect: axial: how joints are held in fixed point follows from the step; take StickingFor
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/sticking.hpp>
#include <robots/puma560.hpp>

using Scene = axial::Scene<robots::Puma560, axial::Gravity, axial::RotorInertia, axial::Friction>;
using Held = axial::Held<Scene, axial::Fixed32>;

struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[6] = {}, damping[6] = {};
};

int main() {
  axial::Motion<Scene, axial::Fixed32> x;
#ifdef MENDED
  return static_cast<int>(axial::advance<axial::StickingFor<Soft>>(x, Held{}).code);
#else
  return static_cast<int>(axial::advance<axial::StickingEuler>(x, 1e-3, Held{}).code);
#endif
}
