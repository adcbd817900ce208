// expect: base_wrench needs every link's own parameters
// within: 5 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Scene = axial::Scene<robots::Scara, axial::Gravity>;
#else
using Scene = axial::Scene<robots::Scara, axial::Gravity, axial::BaseParameters>;
#endif

auto bear(const axial::Joints<robots::Scara, float>& x) { return axial::base_wrench<Scene>(x, x, x); }
