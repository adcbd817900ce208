// expect: a classical_chain is serial
// within: 5 lines
#include <axial/axial.hpp>

#ifdef MENDED
constexpr auto robot = axial::classical_chain(axial::classical_revolute(), axial::classical_revolute());
#else
constexpr auto robot = axial::classical_chain(axial::classical_revolute(), axial::classical_revolute().parent(0));
#endif
static_assert(robot.size == 2);
