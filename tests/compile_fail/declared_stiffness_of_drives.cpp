// expect: axial: LinearlyImplicitFor has no joints that share drives
#include <axial/axial.hpp>
#include <axial/simulation/declared_stiffness.hpp>
#include <robots/wrist_arm.hpp>

using Robot = robots::WristArm;
struct Servo {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[axial::joint_count<Robot>] = {}, damping[axial::joint_count<Robot>] = {};
};

int main() {
  axial::Motion<Robot, float> x;
  const axial::Held<Robot, float> held;
#ifdef MENDED
  return static_cast<int>(axial::advance<axial::LinearlyImplicitEuler>(x, 1e-3F, held).code);
#else
  return static_cast<int>(axial::advance<axial::LinearlyImplicitFor<Servo>>(x, held).code);
#endif
}
