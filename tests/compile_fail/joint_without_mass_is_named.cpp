// expect: every_joint_moves_mass_but<1>
#include <axial/axial.hpp>

using namespace axial;

struct Robot {
#ifdef MENDED
  static constexpr auto chain = axial::chain(gravity(0, -9.81, 0), revolute().mass(1).com(0.1, 0, 0),
                                             revolute().a(0.3).mass(1).com(0.1, 0, 0), prismatic().mass(1));
#else
  static constexpr auto chain = axial::chain(gravity(0, -9.81, 0), revolute().mass(1).com(0.1, 0, 0), revolute().a(0.3),
                                             prismatic().parent(0).mass(1));
#endif
};
auto accelerations(const Joints<Robot, float>& q) { return forward_dynamics<Robot>(q, q, q); }
