// expect: add_the_feature_axial_Payload_to_the_scene
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::Gravity, axial::Payload>;
#else
using Scene = axial::Scene<robots::Scara, axial::Gravity>;
#endif

float mass(const axial::Inputs<Scene, float>& in) { return in.payload.mass; }
