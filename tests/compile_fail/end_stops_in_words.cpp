// expect: axial: end stops in fixed point are those of axial/fixed/simulation/sticking.hpp; include it
#include <axial/fixed.hpp>
#ifdef MENDED
#include <axial/fixed/simulation/sticking.hpp>
#else
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/end_stops.hpp>
#endif
#include <robots/scara.hpp>

using Held = axial::Held<robots::Scara, axial::Fixed32>;

int main() {
  const axial::WithEndStops<robots::Scara, axial::Fixed32, Held> drive(Held{}, axial::EndStops{1e5, 30.0});
  return static_cast<int>(sizeof drive);
}
