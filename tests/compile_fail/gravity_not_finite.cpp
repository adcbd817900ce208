// expect: gravity is not finite
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::gravity(0, 0, -9.81), axial::revolute());
#else
  static constexpr auto chain = axial::chain(axial::gravity(0, 0, __builtin_nan("")), axial::revolute());
#endif
};
static_assert(axial::joint_count<Robot> == 1);
