// expect: spring of a link is not finite
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().spring(5.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().spring(axial::LinkParameters::unlimited));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
