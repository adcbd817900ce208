// expect: the robot's axial::tool() is beyond its axial::tool_limit(reach)
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

struct Arm {
  static constexpr auto chain = [] {
    auto c = robots::Scara::chain;
    c.tool = axial::tool(0.0, 0.3, 0.4);
#ifdef MENDED
    c.tool_limit = axial::tool_limit(0.5);
#else
    c.tool_limit = axial::tool_limit(0.49);
#endif
    return c;
  }();
};
using Scene = axial::Scene<Arm, axial::RuntimeTool>;

auto pose(const axial::Positions<Arm, axial::Fixed32>& q, const axial::Inputs<Scene, axial::Fixed32>& in) {
  return axial::forward_kinematics<Scene>(q, in);
}
