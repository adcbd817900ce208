// expect: a chain needs at least one link
// within: 5 lines
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::gravity(0, 0, -9.81), axial::revolute());
#else
  static constexpr auto chain = axial::chain(axial::gravity(0, 0, -9.81));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
