// expect: position_limits_are_beyond_100_m_give_metres
// within: 5 lines
// at most: 12 lines
#include <axial/fixed.hpp>

using namespace axial;

#ifdef MENDED
constexpr double travel = 0.5;
#else
constexpr double travel = 500.0;
#endif

/// A plotter whose second slide is in millimetres.
struct Plotter {
  static constexpr auto chain = axial::chain(
      gravity(0, 0, -9.81), payload_limit(0.5, 0.1, 0.01),
      revolute().mass(5).inertia_com(0.1, 0.1, 0.1).speed_limit(2).acceleration_limit(10),
      prismatic().a(0.2).mass(2).position_limits(0, travel).speed_limit(1).acceleration_limit(10),
      revolute().a(0.1).alpha_deg(90).mass(1).inertia_com(0.1, 0.1, 0.1).speed_limit(5).acceleration_limit(20));
};
using S = Scene<Plotter, Gravity, Payload>;
using Q = Positions<Plotter, Fixed32>;
using Qd = Velocities<Plotter, Fixed32>;

auto pose(const Q& q, const Inputs<S, Fixed32>& in) { return forward_kinematics<S>(q, in); }
auto inertia(const Q& q, const Inputs<S, Fixed32>& in) { return mass_matrix<S>(q, in); }
auto efforts(const Q& q, const Qd& qd, const Accelerations<Plotter, Fixed32>& qdd, const Inputs<S, Fixed32>& in) {
  return inverse_dynamics<S>(q, qd, qdd, in);
}
auto weight(SafeLoopState<S, Fixed32>& state, const Q& q, const Inputs<S, Fixed32>& in) {
  return compensate_gravity<S>(state, q, in);
}
