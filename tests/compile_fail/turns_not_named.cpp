// expect: add_the_feature_axial_SineCosines_to_the_scene
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::SineCosines>;
#else
using Scene = axial::Scene<robots::Scara>;
#endif

void give(axial::Inputs<Scene, float>& in) { in.turns[0] = {0.0F, 1.0F}; }
