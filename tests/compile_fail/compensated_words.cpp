// expect: axial: in fixed point a Motion keeps what rounding leaves
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <robots/scara.hpp>

int main() {
#ifdef MENDED
  const axial::Motion<robots::Scara, axial::Fixed32> x;
#else
  const axial::CompensatedMotion<robots::Scara, axial::Fixed32> x;
#endif
  return static_cast<int>(x.steps);
}
