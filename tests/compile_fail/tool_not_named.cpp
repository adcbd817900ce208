// expect: add_the_feature_axial_RuntimeTool_to_the_scene
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::RuntimeTool>;
#else
using Scene = axial::Scene<robots::Scara>;
#endif

void give(axial::Inputs<Scene, float>& in) { in.tool.position = {0.0F, 0.0F, 0.1F}; }
