// expect: a or d of a link is not finite
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().a(1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().a(__builtin_inf()));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
