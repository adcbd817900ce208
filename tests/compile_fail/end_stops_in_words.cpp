// expect: axial: end stops are of float and double
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/end_stops.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = axial::Fixed32;
#endif
using Held = axial::Held<robots::Scara, Number>;

int main() {
  const axial::WithEndStops<robots::Scara, Number, Held> drive(Held{}, axial::EndStops{1e5, 30.0});
  return static_cast<int>(sizeof drive);
}
