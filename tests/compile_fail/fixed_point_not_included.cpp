// expect: fixed point is a plug-in: add #include <axial/fixed.hpp>
// within: 5 lines
#include <axial/axial.hpp>
#ifdef MENDED
#include <axial/fixed.hpp>
#endif
#include <robots/scara.hpp>

int main() {
  axial::Positions<robots::Scara, axial::Fixed32> q{};
  axial::Velocities<robots::Scara, axial::Fixed32> qd{};
  axial::Accelerations<robots::Scara, axial::Fixed32> qdd{};
  (void)axial::inverse_dynamics<robots::Scara>(q, qd, qdd);
}
