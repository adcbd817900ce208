// expect: classical links make a classical_chain()
// within: 5 lines
#include <axial/axial.hpp>

#ifdef MENDED
constexpr auto robot = axial::classical_chain(axial::classical_revolute().a(0.5).mass(1));
#else
constexpr auto robot = axial::chain(axial::classical_revolute().a(0.5).mass(1));
#endif
static_assert(robot.size == 1);
