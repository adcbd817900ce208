// expect: axial: how large a step may be is asked in float
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/step_limit.hpp>
#include <robots/scara.hpp>

int main() {
  const axial::Positions<robots::Scara, axial::Fixed32> q{};
#ifdef MENDED
  const auto limit = axial::step_limit<axial::RungeKutta4, robots::Scara>(axial::to_real<float>(q));
#else
  const auto limit = axial::step_limit<axial::RungeKutta4, robots::Scara>(q);
#endif
  return static_cast<int>(limit.status.code);
}
