// expect: mass, com or inertia of a link is not finite
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(__builtin_nan("")));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
