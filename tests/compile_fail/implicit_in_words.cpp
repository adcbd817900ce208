// expect: axial: formats follow from how stiff a robot is
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/declared_stiffness.hpp>
#include <robots/scara.hpp>

struct Servo {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[] = {100.0, 100.0, 0.0}, damping[] = {1.0, 1.0, 0.0};
};

int main() {
  axial::Motion<robots::Scara, axial::Fixed32> x;
#ifdef MENDED
  return static_cast<int>(
      axial::advance<axial::LinearlyImplicitFor<Servo>>(x, axial::Held<robots::Scara, axial::Fixed32>{}).code);
#else
  return static_cast<int>(
      axial::advance<axial::LinearlyImplicitEuler>(x, 1e-3, axial::Held<robots::Scara, axial::Fixed32>{}).code);
#endif
}
