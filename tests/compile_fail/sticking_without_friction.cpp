// expect: axial: what sticks is dry friction; name Friction in the scene
#include <axial/axial.hpp>
#include <axial/simulation/sticking.hpp>
#include <robots/puma560.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Puma560, axial::Gravity, axial::RotorInertia, axial::Friction>;
#else
using Scene = axial::Scene<robots::Puma560, axial::Gravity, axial::RotorInertia>;
#endif

int main() {
  axial::Motion<Scene, float> x;
  return static_cast<int>(axial::advance<axial::StickingEuler>(x, 1e-3F, axial::Held<Scene, float>{}).code);
}
