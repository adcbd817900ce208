// expect: name each feature once
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::Gravity, axial::Friction>;
#else
using Scene = axial::Scene<robots::Scara, axial::Gravity, axial::Friction, axial::Gravity>;
#endif
static_assert(axial::joint_count<Scene> == 3);
