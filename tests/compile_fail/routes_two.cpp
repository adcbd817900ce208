// expect: names more than one form of forward dynamics
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::CompositeBody>;
#else
using Scene = axial::Scene<robots::Scara, axial::CompositeBody, axial::ArticulatedBody>;
#endif
static_assert(axial::joint_count<Scene> == 3);
