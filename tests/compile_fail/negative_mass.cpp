// expect: mass_is_negative_give_kg_of_0_or_more
// within: 5 lines
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().mass(0.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(-1.0));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
