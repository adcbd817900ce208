// expect: forward dynamics needs every joint to move some mass, inertia or rotor
// within: 5 lines
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr auto chain =
      axial::chain(axial::revolute().mass(1).com(0.1, 0, 0), axial::revolute().rotor_inertia(1e-4, 50.0));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(1).com(0.1, 0, 0), axial::revolute());
#endif
};

axial::Joints<Robot, float> q{}, qd{}, tau{};
auto acceleration = axial::forward_dynamics<Robot>(q, qd, tau);
auto torque = axial::inverse_dynamics<Robot>(q, qd, tau);  // the massless link is legitimate here in either case
