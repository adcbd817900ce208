// expect: takes its formats from what each drive is resisted by
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

// Points of mass resist by where they are, which formats do not know.
struct Points {
  static constexpr auto chain = axial::chain(
      axial::revolute().mass(1).com(0.3, 0, 0).rotor_inertia(1e-4, 50).drive_limits(-3, 3, 3, 20),
      axial::revolute().a(0.3).mass(1).com(0.2, 0, 0).rotor_inertia(1e-4, 50).driven_by(0, -1.0).drive_limits(-3, 3, 3,
                                                                                                              20));
};
#ifdef MENDED
using S = axial::Scene<Points, axial::Gravity, axial::RotorInertia>;
#else
using S = axial::Scene<Points, axial::Gravity>;
#endif
using T = axial::Fixed32;

auto udd(const axial::Positions<Points, T>& u, const axial::Velocities<Points, T>& ud,
         const axial::EffortsOf<S, T>& tau) {
  return axial::forward_dynamics<S>(u, ud, tau);
}
