// expect: mass_is_negative_give_kg_of_0_or_more
// within: 5 lines
#include <axial/axial.hpp>

#ifdef MENDED
constexpr double mass = 1.0;
#else
constexpr double mass = -1.0;
#endif

struct Robot {
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01),
                                             axial::revolute().mass(mass).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01));
};
// What kernels say of a robot that does not compile comes after it.
auto effort(const axial::Joints<Robot, float>& q) { return axial::inverse_dynamics<Robot>(q, q, q); }
auto accelerate(const axial::Joints<Robot, float>& q) { return axial::forward_dynamics<Robot>(q, q, q); }
