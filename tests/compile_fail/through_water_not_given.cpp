// expect: add VelocityThroughWater and give
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::FloatingBase, axial::Underwater, axial::VelocityThroughWater>;
#else
using Scene = axial::Scene<robots::Scara, axial::FloatingBase, axial::Underwater>;
#endif

axial::Inputs<Scene, float> inputs;
