// expect: ignoring return value of
#include <axial/simulation/integrators.hpp>
#include <robots/scara.hpp>

int main() {
  axial::Motion<robots::Scara, float> x{};
#ifdef MENDED
  const auto answer = axial::advance<axial::RungeKutta4>(x, 1e-3F, axial::Held<robots::Scara, float>{});
  static_cast<void>(answer);
#else
  axial::advance<axial::RungeKutta4>(x, 1e-3F, axial::Held<robots::Scara, float>{});
#endif
}
