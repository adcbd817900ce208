// expect: alpha or theta of a link is not finite
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().alpha(1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().alpha(__builtin_inf()));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
