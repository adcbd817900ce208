// expect: gamma or b of a link's branch is not finite
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute(), axial::revolute().branch(1.0, 0.25));
#else
  static constexpr auto chain = axial::chain(axial::revolute(), axial::revolute().branch(1.0, __builtin_inf()));
#endif
};
static_assert(axial::joint_count<Robot> == 2);
