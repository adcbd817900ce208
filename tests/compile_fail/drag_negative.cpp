// expect: drag of a link is negative
#include <axial/axial.hpp>

struct Arm {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0).drag_linear(1.0, 1.0, 1.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0).drag_linear(1.0, -1.0, 1.0));
#endif
};
