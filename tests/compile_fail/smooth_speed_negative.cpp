// expect: smooth_speed of a link must be at least
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().smooth_speed(0.1));
#else
  static constexpr auto chain = axial::chain(axial::revolute().smooth_speed(-0.1));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
