// expect: names both FullParameters and BaseParameters
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::BaseParameters>;
#else
using Scene = axial::Scene<robots::Scara, axial::BaseParameters, axial::FullParameters>;
#endif
static_assert(axial::joint_count<Scene> == 3);
