// expect: give every link a speed_limit()
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0).acceleration_limit(2.0).speed_limit(1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0).acceleration_limit(2.0));
#endif
};
constexpr int exponent = axial::Velocities<Robot, axial::Fixed32>::exponent(0);
