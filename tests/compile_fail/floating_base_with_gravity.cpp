// expect: name RuntimeGravity
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::FloatingBase, axial::RuntimeGravity>;
#else
using Scene = axial::Scene<robots::Scara, axial::FloatingBase, axial::Gravity>;
#endif

axial::Inputs<Scene, float> inputs;
