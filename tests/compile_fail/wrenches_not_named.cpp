// expect: add_the_feature_axial_ExternalWrenches_to_the_scene
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::ExternalWrenches>;
#else
using Scene = axial::Scene<robots::Scara>;
#endif

void give(axial::Inputs<Scene, float>& in) { in.wrenches[1].force = {0.0F, 0.0F, 1.0F}; }
