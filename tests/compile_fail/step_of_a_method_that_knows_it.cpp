// expect: axial: this method knows its step
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/declared_stiffness.hpp>
#include <robots/scara.hpp>

struct Servo {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[] = {100.0, 100.0, 0.0}, damping[] = {1.0, 1.0, 0.0};
};

int main() {
  axial::Motion<robots::Scara, float> x;
  const axial::Held<robots::Scara, float> held;
#ifdef MENDED
  return static_cast<int>(axial::advance<axial::LinearlyImplicitFor<Servo>>(x, held).code);
#else
  return static_cast<int>(axial::advance<axial::LinearlyImplicitFor<Servo>>(x, 1e-3F, held).code);
#endif
}
