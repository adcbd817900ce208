// expect: axial::tool_limit(reach) to the robot's chain
#include <axial/fixed.hpp>
#include <robots/scara.hpp>

struct Arm {
  static constexpr auto chain = [] {
    auto c = robots::Scara::chain;
#ifdef MENDED
    c.tool_limit = axial::tool_limit(0.3);
#endif
    return c;
  }();
};
using Scene = axial::Scene<Arm, axial::RuntimeTool>;

auto pose(const axial::Positions<Arm, axial::Fixed32>& q, const axial::Inputs<Scene, axial::Fixed32>& in) {
  return axial::forward_kinematics<Scene>(q, in);
}
