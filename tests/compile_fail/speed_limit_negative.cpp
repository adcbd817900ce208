// expect: speed_limit of a link must be > 0
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().speed_limit(1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().speed_limit(-1.0));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
