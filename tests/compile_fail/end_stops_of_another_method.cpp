// expect: axial: end stops in fixed point are met by StickingFor
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/sticking.hpp>
#include <robots/puma560.hpp>

using Scene = axial::Scene<robots::Puma560, axial::Gravity, axial::RotorInertia>;
using Held = axial::Held<Scene, axial::Fixed32>;

struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[6] = {}, damping[6] = {};
};

int main() {
  axial::Motion<Scene, axial::Fixed32> x;
  const Held held{};
  const axial::WithEndStops<Scene, axial::Fixed32, Held> drive(held, axial::EndStops{});
#ifdef MENDED
  return static_cast<int>(axial::advance<axial::StickingFor<Soft>>(x, drive).code);
#else
  return static_cast<int>(axial::advance<axial::RungeKutta4>(x, 1e-3, drive).code);
#endif
}
