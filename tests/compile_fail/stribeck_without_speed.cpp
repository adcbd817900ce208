// expect: the speed of stribeck() must be at least
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().stribeck(3.0, 0.1));
#else
  static constexpr auto chain = axial::chain(axial::revolute().stribeck(3.0, 0.0));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
