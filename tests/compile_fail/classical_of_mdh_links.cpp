// expect: revolute() and prismatic() are MDH links
// within: 5 lines
#include <axial/axial.hpp>

#ifdef MENDED
constexpr auto robot = axial::classical_chain(axial::classical_revolute(), axial::classical_prismatic());
#else
constexpr auto robot = axial::classical_chain(axial::classical_revolute(), axial::prismatic());
#endif
static_assert(robot.size == 2);
