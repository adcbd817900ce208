// expect: add_the_feature_axial_RuntimeGravity_to_the_scene
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::RuntimeGravity>;
#else
using Scene = axial::Scene<robots::Scara>;
#endif

void give(axial::Inputs<Scene, float>& in) { in.gravity = {0.0F, 0.0F, -9.81F}; }
