// expect: must name an earlier link
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().parent(axial::LinkParameters::base));
#else
  static constexpr auto chain = axial::chain(axial::revolute().parent(0));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
