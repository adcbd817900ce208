// What each package's user writes.
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

namespace {

struct Arm {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.81, 0.0),
                                             axial::revolute()
                                                 .mass(0.4)
                                                 .com(0.1, 0, 0)
                                                 .inertia_com(0, 0.001, 0.001)
                                                 .position_limits(-3, 3)
                                                 .speed_limit(6.0)
                                                 .acceleration_limit(50.0)
                                                 .effort_limit(2.0),
                                             axial::revolute()
                                                 .a(0.2)
                                                 .mass(0.2)
                                                 .com(0.08, 0, 0)
                                                 .inertia_com(0, 0.0005, 0.0005)
                                                 .position_limits(-3, 3)
                                                 .speed_limit(8.0)
                                                 .acceleration_limit(60.0)
                                                 .effort_limit(1.0));
};

}  // namespace

int main() {
  const axial::Joints<Arm, float> q{0.5F, 0.25F}, qd{1.0F, 0.0F}, qdd{2.0F, 0.0F};
  const auto tau = axial::inverse_dynamics<Arm>(q, qd, qdd);
  const auto back = axial::forward_dynamics<Arm>(q, qd, tau);
  const axial::Positions<Arm, axial::Fixed32> words{};
  const auto held = axial::gravity_torque<Arm>(words);
  return back.status.ok() && back[0] > 1.99F && back[0] < 2.01F && held[0].raw > 0 ? 0 : 1;
}
