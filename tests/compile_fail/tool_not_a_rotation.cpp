// expect: base or tool rotation is not orthonormal
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute(), axial::tool({{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}}));
#else
  static constexpr auto chain = axial::chain(axial::revolute(), axial::tool({{1, 0, 0, 0, 2, 0, 0, 0, 1}, {0, 0, 0}}));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
