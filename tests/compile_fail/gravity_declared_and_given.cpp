// expect: names both Gravity and RuntimeGravity
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::RuntimeGravity>;
#else
using Scene = axial::Scene<robots::Scara, axial::Gravity, axial::RuntimeGravity>;
#endif
static_assert(axial::joint_count<Scene> == 3);
