// expect: gamma or b of a link's branch is not finite
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute(), axial::revolute().branch_deg(45.0, 0.25));
#else
  static constexpr auto chain = axial::chain(axial::revolute(), axial::revolute().branch_deg(__builtin_nan(""), 0.25));
#endif
};
static_assert(axial::joint_count<Robot> == 2);
