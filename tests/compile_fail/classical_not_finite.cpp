// expect: alpha or theta of a link is not finite
#include <axial/axial.hpp>

#ifdef MENDED
constexpr double twist = 90.0;
#else
constexpr double twist = std::numeric_limits<double>::infinity();
#endif
constexpr auto robot = axial::classical_chain(axial::classical_revolute().alpha_deg(twist).mass(1));
static_assert(robot.size == 1);
