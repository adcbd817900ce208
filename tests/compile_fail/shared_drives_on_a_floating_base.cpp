// expect: unrolled, in air, on a base that does not float
#include <axial/axial.hpp>

struct Afloat {
  static constexpr auto link = axial::revolute().a(0.3).mass(1).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01);
  static constexpr auto chain =
      axial::chain(axial::base_body().mass(20).inertia_com(1, 1, 1), link, link.alpha_deg(90).driven_by(0, -1.0));
};
#ifdef MENDED
using S = axial::Scene<Afloat, axial::RuntimeGravity, axial::FloatingBase>;
#else
using S = axial::Scene<Afloat, axial::RuntimeGravity, axial::FloatingBase, axial::ArticulatedBody>;
#endif

auto udd(const axial::Joints<Afloat, float>& u, const axial::Inputs<S, float>& in) {
  return axial::forward_dynamics<S>(u, u, u, in);
}
