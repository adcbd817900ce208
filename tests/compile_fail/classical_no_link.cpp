// expect: a classical_chain needs at least one link
// within: 5 lines
#include <axial/axial.hpp>

#ifdef MENDED
constexpr auto robot = axial::classical_chain(axial::gravity(0, 0, -9.81), axial::classical_revolute());
#else
constexpr auto robot = axial::classical_chain(axial::gravity(0, 0, -9.81));
#endif
static_assert(robot.size == 1);
