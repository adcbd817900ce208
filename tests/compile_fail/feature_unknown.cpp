// expect: take out the type that is none
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::Gravity>;
#else
using Scene = axial::Scene<robots::Scara, axial::Gravity, double>;
#endif
static_assert(axial::joint_count<Scene> == 3);
