// expect: fixed point has no RuntimeTool: declare the tool with axial::tool(), or compute in float
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Number = float;
#else
using Number = axial::Fixed32;
#endif
using Scene = axial::Scene<robots::Scara, axial::RuntimeTool>;

auto pose(const axial::Positions<robots::Scara, Number>& q) { return axial::forward_kinematics<Scene>(q); }
