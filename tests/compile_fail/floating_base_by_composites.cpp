// expect: forward dynamics of a floating base is that of ArticulatedBody
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::FloatingBase, axial::ArticulatedBody>;
#else
using Scene = axial::Scene<robots::Scara, axial::FloatingBase, axial::CompositeBody>;
#endif

axial::Inputs<Scene, float> inputs;
