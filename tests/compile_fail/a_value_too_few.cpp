// expect: axial: joint values hold one number for each joint
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>

struct Robot {
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0), axial::revolute().a(0.5).mass(1.0));
};
#ifdef MENDED
axial::Joints<Robot, float> q{0.1F, 0.2F};
#else
axial::Joints<Robot, float> q{0.1F};
#endif
