// expect: add_the_feature_axial_VelocityThroughWater_to_the_scene
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::Underwater, axial::VelocityThroughWater>;
#else
using Scene = axial::Scene<robots::Scara, axial::Underwater>;
#endif

void give(axial::Inputs<Scene, float>& in) { in.velocity_through_water = {0.0F, 0.0F, 1.0F}; }
