// expect: position_limits of a link are upside down
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().position_limits(-1.0, 1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().position_limits(1.0, -1.0));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
