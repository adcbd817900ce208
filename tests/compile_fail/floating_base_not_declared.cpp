// expect: add axial::base_body().mass(kg)
#include <axial/axial.hpp>

struct Arm {
#ifdef MENDED
  static constexpr auto chain = axial::chain(axial::base_body().mass(5.0).inertia_com(0.1, 0.1, 0.1),
                                             axial::revolute().mass(1.0).inertia_com(0.1, 0.1, 0.1));
#else
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0).inertia_com(0.1, 0.1, 0.1));
#endif
};

using Scene = axial::Scene<Arm, axial::FloatingBase>;
auto accelerate(const axial::Joints<Arm, float>& x, const axial::Inputs<Scene, float>& in) {
  return axial::forward_dynamics<Scene>(x, x, x, in);
}
