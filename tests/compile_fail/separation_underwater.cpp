// expect: drag and added mass have no place in the terms
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::Gravity>;
#else
using Scene = axial::Scene<robots::Scara, axial::Gravity, axial::Underwater>;
#endif

auto apart(const axial::Joints<robots::Scara, float>& q) { return axial::separate<Scene>(q); }
