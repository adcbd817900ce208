// expect: axial: joints are held in fixed point by axial/fixed/simulation/sticking.hpp, of Fixed32; include it
#include <axial/fixed.hpp>
#ifdef MENDED
#include <axial/fixed/simulation/sticking.hpp>
#else
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/sticking.hpp>
#endif
#include <robots/puma560.hpp>

using Scene = axial::Scene<robots::Puma560, axial::Gravity, axial::RotorInertia, axial::Friction>;

struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[6] = {}, damping[6] = {};
};

int main() {
  axial::Motion<Scene, axial::Fixed32> x;
  return static_cast<int>(axial::advance<axial::StickingFor<Soft>>(x, axial::Held<Scene, axial::Fixed32>{}).code);
}
