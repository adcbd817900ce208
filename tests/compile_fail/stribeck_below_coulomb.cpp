// expect: static effort of stribeck() is below the Coulomb friction
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().coulomb(2.0).stribeck(3.0, 0.1));
#else
  static constexpr auto chain = axial::chain(axial::revolute().coulomb(2.0).stribeck(1.0, 0.1));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
