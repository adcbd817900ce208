// expect: viscous friction of a link is negative
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().viscous(0.5));
#else
  static constexpr auto chain = axial::chain(axial::revolute().viscous(-0.5));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
