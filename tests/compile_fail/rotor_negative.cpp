// expect: rotor_inertia of a link is negative
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().rotor_inertia(1e-4, 50.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().rotor_inertia(-1e-4, 50.0));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
