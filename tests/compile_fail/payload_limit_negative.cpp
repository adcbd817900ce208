// expect: payload_limit must be finite and >= 0
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::revolute(), axial::payload_limit(1.0, 0.1, 0.01));
#else
  static constexpr auto chain = axial::chain(axial::revolute(), axial::payload_limit(-1.0, 0.1, 0.01));
#endif
};
static_assert(axial::joint_count<Robot> == 1);
